# Properties that the lighting terms must have, shown by millions of evaluations. One executable for each file, and the
# code that they share.
add_library(patina_proof STATIC proof/closed_models.cpp proof/domain.cpp proof/lowered.cpp proof/term.cpp)
target_include_directories(patina_proof PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(patina_proof PUBLIC patina patina_lighting GTest::gtest PRIVATE patina_options)
file(GLOB proof_tests CONFIGURE_DEPENDS proof/*_test.cpp)
foreach(file IN LISTS proof_tests)
  get_filename_component(name ${file} NAME_WE)
  add_executable(proof_${name} ${file})
  target_link_libraries(proof_${name} PRIVATE patina_options patina_proof patina_witness GTest::gtest_main)
  target_include_directories(proof_${name} PRIVATE ${RAPIDJSON_INCLUDE})
  add_test(NAME proof_${name} COMMAND proof_${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
endforeach()
