# Properties that the lighting terms must have, shown by millions of evaluations. The code that
# the tests share is a library.
add_library(patina_proof STATIC proof/closed_models.cpp proof/domain.cpp proof/lowered.cpp proof/term.cpp)
target_include_directories(patina_proof PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(patina_proof PUBLIC patina patina_lighting GTest::gtest PRIVATE patina_options)
precompile_headers(patina_proof ${test_headers})
file(GLOB proof_tests CONFIGURE_DEPENDS proof/*_test.cpp)
test_program(proof_tests FILES ${proof_tests} LIBRARIES patina_proof patina_witness patina_runtime)
foreach(file IN LISTS proof_tests)
  get_filename_component(name ${file} NAME_WE)
  add_test_file(proof_${name} proof_tests ${file})
endforeach()
set_tests_properties(proof_surroundings_test PROPERTIES LABELS slow)
