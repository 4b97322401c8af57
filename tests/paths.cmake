# Compares rendering paths with each other, and with values that are computed without them. One executable for each
# file.
add_library(patina_paths STATIC paths/drawing/drawing.cpp paths/drawing/checkerboard.cpp
            paths/drawing/matt_plane.cpp)
target_include_directories(patina_paths PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(patina_paths PUBLIC patina patina_runtime GTest::gtest PRIVATE patina_options)
file(GLOB paths_tests CONFIGURE_DEPENDS paths/*_test.cpp)
foreach(file IN LISTS paths_tests)
  get_filename_component(name ${file} NAME_WE)
  add_executable(paths_${name} ${file})
  target_link_libraries(paths_${name} PRIVATE patina_options patina_paths GTest::gtest_main)
  add_test(NAME paths_${name} COMMAND paths_${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
endforeach()
set_tests_properties(paths_mutation_test paths_witnesses_test PROPERTIES LABELS slow)
