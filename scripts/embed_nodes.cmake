# Writes nodes/** as one C++ file of raw string literals: cmake -D OUT=... -D DIR=... -D FILES=a;b -P embed_nodes.cmake
set(text "// Generated from nodes/ by scripts/embed_nodes.cmake. Do not edit.\n#include \"compiler/nodelang/embedded.h\"\n\n")
string(APPEND text "namespace patina::nodelang {\nnamespace {\nconstinit const EmbeddedFile kFiles[] = {\n")
foreach(file IN LISTS FILES)
  file(READ "${DIR}/${file}" hex HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  # Adjacent literals of one line each stay below every compiler's limit on the length of a line.
  string(REPLACE "\\x0a" "\\n\"\n\"" bytes "${bytes}")
  file(SIZE "${DIR}/${file}" size)
  string(APPEND text "{\"nodes/${file}\", {\"${bytes}\", ${size}}},\n")
endforeach()
string(APPEND text "};\n}  // namespace\n\nstd::span<const EmbeddedFile> embedded_files() {\n    return kFiles;\n}\n\n}  // namespace patina::nodelang\n")
file(WRITE "${OUT}" "${text}")
