# cmake -D BUILD=... -D SOURCE=... -D WORK=... -D CXX=(compiler) -D CC=(C compiler) -D PYTHON=(or empty) -D NM=...
#       -D LLD=(or empty)
#       -D FLAGS=(compiler flags) -P embed_test.cmake
# Installs the libraries into an empty prefix, and builds and runs programs with no other part of Patina in reach: with
# the static and with the shared libraries, by CMake's package and by pkg-config alone.
cmake_minimum_required(VERSION 3.22)
separate_arguments(flags UNIX_COMMAND "${FLAGS}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

# run_and_find(RUN PROGRAM... PRINTS WORDS...): runs a program, which must print each of the words; sets `output`.
function(run_and_find)
  cmake_parse_arguments(arg "" "" "RUN;PRINTS" ${ARGN})
  run(${arg_RUN})
  foreach(wanted IN LISTS arg_PRINTS)
    string(FIND "${output}" "${wanted}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${arg_RUN} does not print '${wanted}':\n${output}")
    endif()
  endforeach()
  set(output "${output}" PARENT_SCOPE)
endfunction()
set(shaders "dotted.forward.vert.glsl" "dotted.forward.frag.glsl" "#version 450" "_Tint" "void main()")

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component library --prefix ${WORK}/installed)
# The package works wherever it is moved to.
file(RENAME ${WORK}/installed ${WORK}/prefix)
# Copies, so that the programs find no files of the source tree.
file(COPY ${SOURCE}/examples/embed ${SOURCE}/examples/embed_c ${SOURCE}/examples/embed_python
     ${SOURCE}/tests/embed/programs DESTINATION ${WORK})
file(GLOB_RECURSE found ${WORK}/prefix/*/libpatina.a)
get_filename_component(libraries "${found}" DIRECTORY)

# --- CMake
set(configure -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${CXX} -D "CMAKE_CXX_FLAGS=${FLAGS}" -D CMAKE_C_COMPILER=${CC} -D "CMAKE_C_FLAGS=${FLAGS}")
foreach(shared IN ITEMS OFF ON)
  set(folder ${WORK}/shared-${shared})
  run(${CMAKE_COMMAND} -S ${WORK}/embed -B ${folder}/example ${configure} -D BUILD_SHARED_LIBS=${shared})
  run(${CMAKE_COMMAND} --build ${folder}/example)
  run_and_find(RUN ${folder}/example/embed PRINTS ${shaders} "block Material" "pack://textures/grain.png"
               "compiled pack://stone/plain.graph.json")
  # Only the graph that uses the changed file is compiled again.
  if(NOT output MATCHES "mask.subgraph.json changes\ncompiled pack://stone/dotted.graph.json\n$")
    message(FATAL_ERROR "the example compiles something else when a file changes:\n${output}")
  endif()
  run(${CMAKE_COMMAND} -S ${WORK}/programs -B ${folder}/programs ${configure} -D BUILD_SHARED_LIBS=${shared}
      -D EXAMPLES=${WORK})
  run(${CMAKE_COMMAND} --build ${folder}/programs)
  run_and_find(RUN ${folder}/programs/embed PRINTS ${shaders})
  run_and_find(RUN ${folder}/programs/embed_c PRINTS ${shaders})
  run_and_find(RUN ${folder}/programs/lighting PRINTS "lighting 6 64")
  run_and_find(RUN ${folder}/programs/global_compiler PRINTS "global Lerp, 4 shaders")
endforeach()
# A project in C alone, by the shared library.
run(${CMAKE_COMMAND} -S ${WORK}/embed_c -B ${WORK}/c ${configure})
run(${CMAKE_COMMAND} --build ${WORK}/c)
run_and_find(RUN ${WORK}/c/embed_c PRINTS ${shaders})

# --- pkg-config
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/pkgconfig)  # no other package is in reach
set(ENV{LD_LIBRARY_PATH} ${libraries})
file(MAKE_DIRECTORY ${WORK}/pkg-config)
function(compile_with package program)  # and the compiler with the files of the program
  run(pkg-config --cflags --libs ${package})
  separate_arguments(arguments UNIX_COMMAND "${output}")
  run(${ARGN} ${arguments} -o ${WORK}/pkg-config/${program})
endfunction()
foreach(form IN ITEMS "" "-static")
  set(compiler ${CXX} -std=c++20 ${flags} ${WORK}/programs/other_fmt.cpp)
  compile_with(patina${form} embed${form} ${compiler} ${WORK}/embed/main.cpp)
  run_and_find(RUN ${WORK}/pkg-config/embed${form} PRINTS ${shaders})
  compile_with(patina${form} embed_c${form} ${CC} -std=c99 -Wall -Wextra -Werror -pedantic ${flags} ${WORK}/embed_c/main.c)
  run_and_find(RUN ${WORK}/pkg-config/embed_c${form} PRINTS ${shaders})
  compile_with(patina-lighting${form} lighting${form} ${compiler} ${WORK}/programs/lighting.cpp)
  run_and_find(RUN ${WORK}/pkg-config/lighting${form} PRINTS "lighting 6 64")
endforeach()
# A program that contains all that it needs.
if(NOT FLAGS MATCHES "sanitize")
  run(pkg-config --static --cflags --libs patina)
  separate_arguments(arguments UNIX_COMMAND "${output}")
  run(${CC} -static ${WORK}/embed_c/main.c ${arguments} -o ${WORK}/pkg-config/whole)
  run_and_find(RUN ${WORK}/pkg-config/whole PRINTS ${shaders})
endif()
file(READ ${SOURCE}/compiler/include/patina/version.h version)
string(REGEX MATCH "PATINA_VERSION_STRING \"([0-9.]+)\"" version "${version}")
run_and_find(RUN pkg-config --modversion patina PRINTS ${CMAKE_MATCH_1})

# --- Python, which cannot load a library with sanitizers
if(PYTHON AND NOT FLAGS MATCHES "sanitize")
  run_and_find(RUN ${PYTHON} -B -I ${WORK}/embed_python/main.py ${libraries}/libpatina.so PRINTS ${shaders} "// _Tint")
  run_and_find(RUN ${PYTHON} -B -I ${WORK}/programs/module.py ${WORK}/embed_python ${libraries}/libpatina.so
               PRINTS "the module works")
endif()

# --- what the libraries show
# A program can use another version of {fmt} or RapidJSON beside it: the library defines neither under its usual name. A
# plugin that contains the library shows Patina's own functions only.
foreach(name IN ITEMS patina patina-lighting)
  run(${NM} --demangle --defined-only ${libraries}/lib${name}.a)
  foreach(unwanted IN ITEMS "fmt::v[0-9]+::" "rapidjson::(Generic|internal|Reader|Memory)")
    if(output MATCHES "[^\n]*${unwanted}[^\n]*")
      message(FATAL_ERROR "lib${name}.a defines '${CMAKE_MATCH_0}'")
    endif()
  endforeach()
endforeach()
run(${CXX} ${flags} -shared -o ${WORK}/plugin.so -Wl,--whole-archive ${libraries}/libpatina.a -Wl,--no-whole-archive)
run(${NM} --demangle --dynamic --defined-only ${WORK}/plugin.so)
if(NOT output MATCHES "patina::Compiler::compile_text\\(")
  message(FATAL_ERROR "the plugin does not show patina::Compiler::compile_text")
endif()
string(REGEX MATCHALL "[^\n]* (fmt|rapidjson|glm|patina::[a-z_]+)::[^\n]*" shown "${output}")
if(shown)
  message(FATAL_ERROR "the plugin shows what is not public:\n${shown}")
endif()
# The shared libraries show nothing else, not even instances of the standard library's templates. Each symbol has the version
# of the library's name; the functions for C are those of the header.
file(READ ${SOURCE}/compiler/include/patina/version.h version)
string(REGEX MATCH "PATINA_VERSION_STRING \"([0-9]+\\.[0-9]+)" version "${version}")
set(version PATINA_${CMAKE_MATCH_1})
file(READ ${WORK}/prefix/include/patina/patina_c.h c_header)
string(REGEX MATCHALL "patina_[a-z0-9_]+\\([^*]" c_functions "${c_header}")
list(TRANSFORM c_functions REPLACE "\\(.*" "")
foreach(name IN ITEMS patina patina-lighting)
  set(own_functions "")
  if(name STREQUAL "patina")
    set(own_functions "${c_functions}")
  endif()
  foreach(linker IN ITEMS "" ${LLD})
    set(library ${libraries}/lib${name}.so)
    if(linker)  # the same objects and the same list of symbols
      set(library ${WORK}/lib${name}-lld.so)
      run(${CXX} ${flags} -shared -fuse-ld=lld -o ${library} -Wl,--version-script=${BUILD}/package/${name}.map
          -Wl,--whole-archive ${libraries}/lib${name}.a -Wl,--no-whole-archive -pthread)
    endif()
    run(${NM} --demangle --dynamic --defined-only ${library})
    string(REPLACE ";" "" output "${output}")
    string(REGEX REPLACE "[^\n]* A ${version}\n" "" text "${output}")
    string(REGEX REPLACE "[^\n]* [A-Z] ((typeinfo|typeinfo name|vtable) for )?(patina::[^\n]*|patina_[a-z0-9_]+)@@${version}\n" ""
           other "${text}")
    if(NOT other STREQUAL "" OR NOT output MATCHES "patina::")
      message(FATAL_ERROR "${library} shows what is not public, or has no version:\n${other}")
    endif()
    string(REGEX MATCHALL " T patina_[a-z0-9_]+@@" shown "${text}")
    list(TRANSFORM shown REPLACE " T (.*)@@" "\\1")
    foreach(function IN LISTS own_functions)
      if(NOT function IN_LIST shown)
        message(FATAL_ERROR "${library} does not show ${function}, which patina_c.h declares")
      endif()
    endforeach()
    foreach(function IN LISTS shown)
      if(NOT function IN_LIST own_functions)
        message(FATAL_ERROR "${library} shows ${function}, which patina_c.h does not declare")
      endif()
    endforeach()
  endforeach()
endforeach()
# A program says which version it needs: another one stops it when it starts, not when it calls.
run(${NM} --dynamic --undefined-only ${WORK}/c/embed_c)
if(NOT output MATCHES " patina_compile@${version}\n")
  message(FATAL_ERROR "a program that is linked with libpatina.so does not ask for ${version}:\n${output}")
endif()

# What comes with the libraries.
set(documents ${WORK}/prefix/share/doc/patina)
foreach(row IN ITEMS "LICENSE:Permission is hereby granted" "LICENSE:Patina contributors" "LICENSE:fmt 9" "LICENSE:rapidjson 1"
                     "licences/fmt.txt:Victor Zverovich" "licences/rapidjson.txt:Milo Yip" "licences/glm.txt:G-Truc Creation")
  string(REGEX MATCH "(.*):(.*)" matched "${row}")
  file(READ ${documents}/${CMAKE_MATCH_1} license)
  string(FIND "${license}" "${CMAKE_MATCH_2}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${CMAKE_MATCH_1}, which is installed, lacks '${CMAKE_MATCH_2}'")
  endif()
endforeach()
run(${CMAKE_COMMAND} -E compare_files ${WORK}/prefix/share/patina/reflection.schema.json ${SOURCE}/docs/reflection.schema.json)

# The package is self-contained: it has no header of another library, and no path of this build or source tree.
file(GLOB_RECURSE installed ${WORK}/prefix/*.h ${WORK}/prefix/*.cmake ${WORK}/prefix/*.pc)
foreach(file IN LISTS installed)
  file(READ ${file} text)
  foreach(unwanted IN ITEMS "fmt" "rapidjson" "glm" "patina_options" "${SOURCE}/" "${BUILD}/")
    string(FIND "${text}" "${unwanted}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${file} mentions '${unwanted}'")
    endif()
  endforeach()
endforeach()

# The example keeps its promise: less than 150 lines, and only public headers.
file(STRINGS ${SOURCE}/examples/embed/main.cpp lines)
file(STRINGS ${SOURCE}/examples/embed/CMakeLists.txt more)
list(LENGTH lines count)
list(LENGTH more count_more)
math(EXPR total "${count} + ${count_more}")
if(total GREATER_EQUAL 150)
  message(FATAL_ERROR "examples/embed has ${total} lines")
endif()
