# Files that no author would write: whatever they hold, the compiler reports errors and does not crash.
add_executable(fuzz_pass_files_test fuzz/pass_files_test.cpp)
target_link_libraries(fuzz_pass_files_test PRIVATE patina_options patina patina_validate GTest::gtest GTest::gtest_main)
target_compile_definitions(fuzz_pass_files_test PRIVATE PATINA_PASSES="${CMAKE_SOURCE_DIR}/nodes/passes")
add_test(NAME fuzz_pass_files_quick COMMAND fuzz_pass_files_test --gtest_filter=*.Quick)
add_test(NAME fuzz_pass_files COMMAND fuzz_pass_files_test --gtest_filter=-*.Quick)
set_tests_properties(fuzz_pass_files PROPERTIES LABELS slow)

# Takes a folder of shader graphs, which are not in this project.
add_executable(fuzz_shader_graphs EXCLUDE_FROM_ALL fuzz/shader_graphs.cpp)
target_link_libraries(fuzz_shader_graphs PRIVATE patina_options patina patina_importers)
