add_executable(engines_test engines/engines_test.cpp)
target_link_libraries(engines_test PRIVATE patina_options patina patina_runtime patina_validate GTest::gtest GTest::gtest_main)
precompile_headers(engines_test ${test_headers})
add_test(NAME engines COMMAND engines_test WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
