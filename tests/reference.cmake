# The reference of the public headers, by Doxygen: the target `reference` writes it to reference/html in the build folder.
# The test `reference` does the same: it fails if something public has no comment.
find_program(DOXYGEN doxygen)
if(DOXYGEN AND Python3_Interpreter_FOUND)
  set(make_reference ${Python3_EXECUTABLE} -B ${CMAKE_SOURCE_DIR}/docs/reference/make.py ${CMAKE_BINARY_DIR}/reference)
  add_custom_target(reference COMMAND ${make_reference} VERBATIM)
  add_test(NAME reference COMMAND ${make_reference})
else()
  add_test(NAME reference COMMAND ${CMAKE_COMMAND} -E echo "skipped: there is no Doxygen, or no Python 3")
  set_tests_properties(reference PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: ")
endif()
