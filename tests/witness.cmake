# Tests that let GLSL and HLSL on the GPU and the CPU interpreter check each other. Four executables and what they
# share.
add_library(patina_witness STATIC witness/bench.cpp witness/random_graph.cpp)
target_include_directories(patina_witness PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(patina_witness PUBLIC patina_runtime GTest::gtest PRIVATE patina_options)
foreach(name half library quads random_graphs)
  add_executable(witness_${name}_test witness/${name}_test.cpp)
  target_link_libraries(witness_${name}_test PRIVATE patina_options patina_witness GTest::gtest_main)
endforeach()

add_test(NAME witness_half COMMAND witness_half_test)
add_test(NAME witness_library COMMAND witness_library_test)
add_test(NAME witness_quads COMMAND witness_quads_test)
add_test(NAME witness_random_graphs_quick COMMAND witness_random_graphs_test --gtest_filter=*.Quick)
add_test(NAME witness_random_graphs COMMAND witness_random_graphs_test --gtest_filter=-*.Quick)
set_tests_properties(witness_random_graphs PROPERTIES LABELS slow)
