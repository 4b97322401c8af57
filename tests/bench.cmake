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
add_custom_target(bench COMMAND patina_bench COMMAND picture_bench COMMAND ${CMAKE_COMMAND} -E chdir ${CMAKE_SOURCE_DIR}
                  $<TARGET_FILE:twin_bench> DEPENDS patina_bench picture_bench twin_bench patina_cli USES_TERMINAL VERBATIM)

# Shaders that are written by hand, next to those that Patina makes of the same graphs.
add_library(patina_twins STATIC bench/twins.cpp)
target_link_libraries(patina_twins PUBLIC patina patina_validate PRIVATE patina_options)
add_executable(twin_bench bench/twin_bench.cpp)
target_link_libraries(twin_bench PRIVATE patina_options patina_twins)
add_executable(twins_test bench/twins_test.cpp)
target_link_libraries(twins_test PRIVATE patina_options patina_twins patina_paths GTest::gtest_main)
precompile_headers(twins_test ${test_headers})
add_test(NAME twins COMMAND twins_test WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})

# If compile time grows with the square of a graph's length, this test times out. No other test would notice.
set_tests_properties(long_graph_test PROPERTIES TIMEOUT 120)
