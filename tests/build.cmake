# Patina in other people's builds: ninja, make, CMake and Bazel.
foreach(name IN ITEMS ninja cmake bazel)
  add_test(NAME build_with_${name} COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/build/${name}_test ${CMAKE_BINARY_DIR}
           ${CMAKE_BINARY_DIR}/build_with_${name})
  set_tests_properties(build_with_${name} PROPERTIES SKIP_RETURN_CODE 77)
endforeach()
set_tests_properties(build_with_bazel PROPERTIES LABELS slow)
