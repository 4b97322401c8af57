# `cmake --build build --target bench` prints the compiler's figures; ctest does not run it.
find_package(benchmark REQUIRED)
add_executable(patina_bench bench/figures.cpp bench/patina_bench.cpp)
target_link_libraries(patina_bench PRIVATE patina_options patina_allocator patina_model_cost benchmark::benchmark)
add_executable(picture_bench bench/figures.cpp bench/picture_bench.cpp)
target_link_libraries(picture_bench PRIVATE patina_options patina_runtime benchmark::benchmark)
foreach(program patina_bench picture_bench)
  target_compile_definitions(${program} PRIVATE
    PATINA_EXAMPLES="${CMAKE_SOURCE_DIR}/examples/graphs" PATINA_COMMAND="$<TARGET_FILE:patina_cli>"
    PATINA_SCRATCH="${CMAKE_BINARY_DIR}/bench")
endforeach()
add_custom_target(bench COMMAND patina_bench COMMAND picture_bench DEPENDS patina_bench picture_bench patina_cli
                  USES_TERMINAL VERBATIM)

# The compiler's shaders against those that an expert wrote for the same materials.
add_executable(handwritten_test bench/handwritten_test.cpp)
target_link_libraries(handwritten_test PRIVATE patina_options patina_paths patina_validate GTest::gtest_main)
add_test(NAME handwritten COMMAND handwritten_test WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})

# If compile time grows with the square of a graph's length, this test times out. No other test would notice.
set_tests_properties(long_graph_test PROPERTIES TIMEOUT 120)
