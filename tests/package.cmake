# What comes with Patina: licences, the bill of materials, and the protections of its programs.
set(package_tests ${CMAKE_CURRENT_SOURCE_DIR}/package)
add_python_test(licences ${package_tests}/licences_test.py ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR} $<TARGET_FILE:patina_cli>)
add_python_test(sbom ${package_tests}/sbom_test.py ${CMAKE_BINARY_DIR})
add_python_test(hardening ${package_tests}/hardening_test.py ${CMAKE_BINARY_DIR} $<BOOL:${PATINA_IS_HARDENED}>)
if(Python3_Interpreter_FOUND)
  set_tests_properties(sbom hardening PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)skipped: ")
endif()
