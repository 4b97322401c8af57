# A second front end reads the HLSL of the examples: Slang as WebAssembly under Node, which scripts/setup installs.
add_test(NAME slang COMMAND ${CMAKE_COMMAND} -D PATINA=$<TARGET_FILE:patina_cli> -D SOURCE=${CMAKE_SOURCE_DIR}
         -D WORK=${CMAKE_BINARY_DIR}/slang_test -P ${CMAKE_CURRENT_SOURCE_DIR}/slang/slang.cmake)
set_tests_properties(slang PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)skipped: " LABELS slow TIMEOUT 600)
