# Tests of texts: diagnostics, emitted shaders, the examples of the documentation; and rules for the source tree itself.
add_library(patina_received STATIC support/received.cpp)
target_link_libraries(patina_received PUBLIC patina_options patina patina_validate GTest::gtest GTest::gtest_main)
precompile_headers(patina_received ${test_headers})
target_compile_definitions(patina_received PRIVATE
  PATINA_TESTS_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}" PATINA_RECEIVED_FOLDER="${CMAKE_BINARY_DIR}/received"
  PATINA_PROGRAM="$<TARGET_FILE:patina_cli>")

# The files of 'patina env', read back.
add_executable(env_test cli/env_test.cpp)
target_link_libraries(env_test PRIVATE patina_received patina_pictures)
precompile_headers(env_test ${test_headers})
add_dependencies(env_test patina_cli patina_render)
add_test(NAME env_test COMMAND env_test)

foreach(name IN ITEMS diagnostics graphs docs)
  add_executable(${name}_test ${name}/${name}_test.cpp)
  target_link_libraries(${name}_test PRIVATE patina_received)
  precompile_headers(${name}_test ${test_headers})
  add_dependencies(${name}_test patina_cli)
  add_test(NAME ${name}_test COMMAND ${name}_test)
endforeach()
