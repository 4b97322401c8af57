# Files that no author would write: whatever they hold, they are read or refused at a place, and nothing crashes.
add_executable(fuzz fuzz/main.cpp fuzz/model_kinds.cpp fuzz/mutate.cpp fuzz/picture_kinds.cpp fuzz/seeds.cpp
               fuzz/text_kinds.cpp fuzz/tokens.cpp fuzz/verdict.cpp)
target_link_libraries(fuzz PRIVATE patina_options patina patina_importers patina_runtime patina_validate
                      GTest::gtest PkgConfig::OIIO)
precompile_headers(fuzz ${test_headers})
target_include_directories(fuzz PRIVATE ${CMAKE_SOURCE_DIR})
target_compile_definitions(fuzz PRIVATE PATINA_SOURCE="${CMAKE_SOURCE_DIR}")
# `build/fuzz all 100000` makes so many of each kind. The preset `asan` builds it with sanitizers.
add_test(NAME fuzz_quick COMMAND fuzz all quick)
# With sanitizers, which see what an ordinary build survives, the slow tests make 100,000 of each kind.
if(CMAKE_CXX_FLAGS MATCHES "fsanitize")
  foreach(kind IN ITEMS graph scene node hlsl pass options reflection merge snapshot png jpeg webp exr hdr tiff tga bmp gif dds psd
          merl map gltf glb mtlx mat shadergraph)
    add_test(NAME fuzz_${kind} COMMAND fuzz ${kind} slow)
    set_tests_properties(fuzz_${kind} PROPERTIES LABELS slow TIMEOUT 7200)  # sanitizers make it ten times slower
  endforeach()
endif()
