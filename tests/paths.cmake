# Compares rendering paths with each other, and with values that are computed without them.
add_library(patina_paths STATIC paths/drawing/drawing.cpp paths/drawing/checkerboard.cpp
            paths/drawing/matt_plane.cpp)
target_include_directories(patina_paths PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(patina_paths PUBLIC patina patina_runtime GTest::gtest PRIVATE patina_options)
precompile_headers(patina_paths ${test_headers})
file(GLOB paths_tests CONFIGURE_DEPENDS paths/*_test.cpp)
test_program(paths_tests FILES ${paths_tests} LIBRARIES patina_paths)
foreach(file IN LISTS paths_tests)
  get_filename_component(name ${file} NAME_WE)
  add_test_file(paths_${name} paths_tests ${file})
endforeach()
set_tests_properties(paths_mutation_test paths_witnesses_test PROPERTIES LABELS slow)
