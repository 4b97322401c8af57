# Khronos' validator reads the files that `patina bake` writes. It runs under Node; scripts/setup installs both.
add_test(NAME gltf COMMAND ${CMAKE_COMMAND} -D PATINA=$<TARGET_FILE:patina_cli> -D SOURCE=${CMAKE_SOURCE_DIR}
         -D WORK=${CMAKE_BINARY_DIR}/gltf_files -P ${CMAKE_CURRENT_SOURCE_DIR}/gltf/gltf.cmake)
set_tests_properties(gltf PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)skipped: " LABELS slow TIMEOUT 600)
