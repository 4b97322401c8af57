# cmake -D BUILD=... -D SOURCE=... -D WORK=... -D CXX=(compiler) -D NM=... -D FLAGS=(compiler flags) -P embed_test.cmake
# Installs the library into an empty prefix, and builds and runs examples/embed with no other part of Patina in reach.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component library --prefix ${WORK}/prefix)
# A copy, so that the example finds no files of the source tree.
file(COPY ${SOURCE}/examples/embed DESTINATION ${WORK})
run(${CMAKE_COMMAND} -S ${WORK}/embed -B ${WORK}/build -D CMAKE_PREFIX_PATH=${WORK}/prefix
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -D CMAKE_BUILD_TYPE=Release -D "CMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/embed)
foreach(wanted IN ITEMS "dotted.forward.vert.glsl" "dotted.forward.frag.glsl" "#version 450" "_Tint" "void main()")
  string(FIND "${output}" "${wanted}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "the program does not print '${wanted}':\n${output}")
  endif()
endforeach()

# A program can use another version of {fmt} or RapidJSON beside it: the library defines neither under its usual name. A
# plugin that contains the library shows Patina's own functions only.
run(${NM} --demangle --defined-only ${BUILD}/compiler/libpatina.a)
foreach(unwanted IN ITEMS "fmt::v[0-9]+::" "rapidjson::(Generic|internal|Reader|Memory)")
  if(output MATCHES "[^\n]*${unwanted}[^\n]*")
    message(FATAL_ERROR "the library defines '${CMAKE_MATCH_0}'")
  endif()
endforeach()
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
run(${CXX} ${flags} -shared -o ${WORK}/plugin.so -Wl,--whole-archive ${BUILD}/compiler/libpatina.a
    -Wl,--no-whole-archive)
run(${NM} --demangle --dynamic --defined-only ${WORK}/plugin.so)
if(NOT output MATCHES "patina::Compiler::compile_text\\(")
  message(FATAL_ERROR "the plugin does not show patina::Compiler::compile_text")
endif()
string(REGEX MATCHALL "[^\n]* (fmt|rapidjson|patina::[a-z_]+)::[^\n]*" shown "${output}")
if(shown)
  message(FATAL_ERROR "the plugin shows what is not public:\n${shown}")
endif()

# The package is self-contained: it has no header of another library, and no path of this build or source tree.
file(GLOB_RECURSE installed ${WORK}/prefix/*.h ${WORK}/prefix/*.cmake)
foreach(file IN LISTS installed)
  file(READ ${file} text)
  foreach(unwanted IN ITEMS "fmt" "rapidjson" "patina_options" "${SOURCE}/" "${BUILD}/")
    string(FIND "${text}" "${unwanted}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${file} mentions '${unwanted}'")
    endif()
  endforeach()
endforeach()

# The example keeps its promise: less than 60 lines, and only public headers.
file(STRINGS ${SOURCE}/examples/embed/main.cpp lines)
file(STRINGS ${SOURCE}/examples/embed/CMakeLists.txt more)
list(LENGTH lines count)
list(LENGTH more count_more)
math(EXPR total "${count} + ${count_more}")
if(total GREATER_EQUAL 60)
  message(FATAL_ERROR "examples/embed has ${total} lines")
endif()
