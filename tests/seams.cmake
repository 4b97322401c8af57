# What happens where exceptions end: without memory, and after mistakes.
add_executable(allocations_test seams/allocations_test.cpp seams/failing_new.cpp seams/works.cpp seams/works_in_c.cpp)
target_link_libraries(allocations_test PRIVATE patina_options patina GTest::gtest GTest::gtest_main)
precompile_headers(allocations_test ${test_headers})
add_test(NAME allocations_quick COMMAND allocations_test --gtest_filter=*Quick* WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
add_test(NAME allocations COMMAND allocations_test --gtest_filter=*Every* WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
set_tests_properties(allocations PROPERTIES LABELS slow)

add_executable(c_functions_test seams/c_functions_test.cpp)
target_link_libraries(c_functions_test PRIVATE patina_options patina GTest::gtest GTest::gtest_main)
precompile_headers(c_functions_test ${test_headers})
target_include_directories(c_functions_test PRIVATE ${RAPIDJSON_INCLUDE})
add_test(NAME c_functions COMMAND c_functions_test WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})

add_executable(jobs_failure_test seams/jobs_failure_test.cpp)
target_link_libraries(jobs_failure_test PRIVATE patina_options patina_jobs GTest::gtest GTest::gtest_main)
precompile_headers(jobs_failure_test ${test_headers})
add_test(NAME jobs_failure COMMAND jobs_failure_test)

add_executable(lighting_failure_test seams/lighting_failure_test.cpp seams/failing_new.cpp)
target_link_libraries(lighting_failure_test PRIVATE patina_options patina_light GTest::gtest GTest::gtest_main)
precompile_headers(lighting_failure_test ${test_headers})
add_test(NAME lighting_failure COMMAND lighting_failure_test)

# The commands, with an allocator that fails. Sanitizers have one of their own.
if(NOT CMAKE_CXX_FLAGS MATCHES "fsanitize")
  add_library(failing_allocator MODULE seams/failing_allocator.cpp)
  target_link_libraries(failing_allocator PRIVATE patina_options ${CMAKE_DL_LIBS})
  add_test(NAME commands_without_memory
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/seams/commands_test $<TARGET_FILE:patina_cli>
                   $<TARGET_FILE:failing_allocator> ${CMAKE_SOURCE_DIR})
endif()
