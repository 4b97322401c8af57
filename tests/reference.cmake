# The reference of the public headers, by Doxygen: the target `reference` writes it to reference/html in the build folder,
# and the test `reference` fails if something public in a header of this list has no comment.
set(complete complaints engine_values interpret lighting name_value output_name patina_c place scene segments version)
find_program(DOXYGEN doxygen)
set(folder ${CMAKE_BINARY_DIR}/reference)
set(headers ${CMAKE_SOURCE_DIR}/compiler/include)
file(READ ${CMAKE_SOURCE_DIR}/docs/reference/Doxyfile settings)
file(WRITE ${folder}/Doxyfile "${settings}
PROJECT_NUMBER         = ${PROJECT_VERSION}
INPUT                  = ${headers}/patina
EXCLUDE                = ${headers}/patina/validate.h ${headers}/patina/spirv_size.h
INCLUDE_PATH           = ${headers}
STRIP_FROM_PATH        = ${headers}
STRIP_FROM_INC_PATH    = ${headers}
INPUT_FILTER           = \"${Python3_EXECUTABLE} -B ${CMAKE_SOURCE_DIR}/docs/reference/filter.py\"
OUTPUT_DIRECTORY       = ${folder}
")
list(TRANSFORM complete PREPEND "${headers}/patina/")
list(TRANSFORM complete APPEND ".h")
string(REPLACE ";" " " complete "${complete}")
file(WRITE ${folder}/Checked "@INCLUDE = ${folder}/Doxyfile
INPUT = ${complete}
GENERATE_HTML = NO
WARN_IF_UNDOCUMENTED = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
GENERATE_TAGFILE = ${folder}/tags
")
if(DOXYGEN AND Python3_Interpreter_FOUND)
  add_custom_target(reference COMMAND ${DOXYGEN} ${folder}/Doxyfile COMMENT "Writing reference/html" VERBATIM)
  add_test(NAME reference COMMAND ${DOXYGEN} ${folder}/Checked)
else()
  add_test(NAME reference COMMAND ${CMAKE_COMMAND} -E echo "skipped: there is no Doxygen, or no Python 3")
  set_tests_properties(reference PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: ")
endif()
