cmake_minimum_required(VERSION 3.22)
# cmake -D ROOT=... -P layering.cmake
# Checks who may include whom, which names C++ may not mention, and how many files a room holds. Exits with an error
# that lists every violation.
set(breaches "")
set(most_files 25)  # the limit for a room; more than that are two rooms
math(EXPR too_many_files "${most_files} + 1")

# --- the rooms of the compiler

# room: the rooms that it may include (itself always); `include` is compiler/include/patina. The list goes from the bottom
# to the top, and a room includes only rooms above it in the list, so there are no circles.
set(compiler_rooms
    "include:"
    "base:"
    "seam: include base"
    "json/memory: base"
    "json: base json/memory"
    "ir: base"
    "nodelang: base"
    "emit: base ir nodelang"
    "languages: base ir"
    "format: include base json nodelang"
    "format/schema: include base json format"
    "edit: include base json nodelang format"
    "engines: include base json ir format"
    "paths: include base ir nodelang format"
    "resolve: include base json nodelang format engines paths"
    "lower: include base ir nodelang emit format engines paths resolve"
    "link: include base ir languages engines paths resolve lower"
    "output: include base ir format languages engines resolve lower link"
    "writers/*: include base ir languages format engines resolve lower link output"
    "writers: base languages engines resolve output writers/*"
    "reflection: include base json/memory json"
    "interpret: include base ir link"
    "validate: include seam"
    "api: include base seam json/memory json ir nodelang emit format format/schema edit engines paths resolve lower link output writers reflection interpret"
    "exporters/*: include base seam ir format engines paths resolve lower link output api"
    "capi: include base json nodelang format api")
# `writers/*` stands for each folder of that room.
foreach(room IN ITEMS writers exporters)
  file(GLOB folders LIST_DIRECTORIES true RELATIVE ${ROOT}/compiler ${ROOT}/compiler/${room}/*)
  list(FILTER folders EXCLUDE REGEX "\\.")
  set(rows "")
  foreach(row IN LISTS compiler_rooms)
    if(row MATCHES "^${room}/\\*:(.*)$")
      foreach(folder IN LISTS folders)
        list(APPEND rows "${folder}:${CMAKE_MATCH_1}")
      endforeach()
    else()
      list(JOIN folders " " all_folders)
      string(REPLACE "${room}/*" "${all_folders}" row "${row}")
      list(APPEND rows "${row}")
    endif()
  endforeach()
  set(compiler_rooms "${rows}")
endforeach()

set(names "")
foreach(row IN LISTS compiler_rooms)
  string(REGEX REPLACE ":.*" "" room "${row}")
  list(APPEND names ${room})
endforeach()

# The room of a file, by its path below compiler/: its folder, or the nearest folder above it that is in the list. (A
# folder that is not in the list belongs to the room that it is in: compiler/ir/passes, compiler/languages/glsl.)
function(room_of path out)
  get_filename_component(folder "${path}" DIRECTORY)
  while(NOT folder STREQUAL "" AND NOT folder IN_LIST names)
    get_filename_component(folder "${folder}" DIRECTORY)
  endwhile()
  if(folder MATCHES "^include")
    set(folder include)
  endif()
  set(${out} "${folder}" PARENT_SCOPE)
endfunction()

set(below "")
foreach(row IN LISTS compiler_rooms)
  string(REGEX MATCH "^([^:]*): ?(.*)$" unused "${row}")
  set(room ${CMAKE_MATCH_1})
  string(REPLACE " " ";" allowed "${CMAKE_MATCH_2}")
  foreach(to IN LISTS allowed)
    if(NOT to IN_LIST below)
      string(APPEND breaches "the list lets compiler/${room} include compiler/${to}, which is not above it there\n")
    endif()
  endforeach()
  list(APPEND below ${room})
  if(room STREQUAL "include")
    continue()
  endif()
  file(GLOB_RECURSE files ${ROOT}/compiler/${room}/*.h ${ROOT}/compiler/${room}/*.cpp ${ROOT}/compiler/${room}/*.def)
  foreach(file IN LISTS files)
    file(RELATIVE_PATH name ${ROOT} ${file})
    file(RELATIVE_PATH below_compiler ${ROOT}/compiler ${file})
    room_of("${below_compiler}" own)
    if(NOT own STREQUAL room)
      continue()
    endif()
    file(STRINGS ${file} includes REGEX "^ *#include \"")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^ *#include \"([^\"]*)\".*" "\\1" path "${line}")
      if(path MATCHES "^compiler/(.*)$")
        room_of("${CMAKE_MATCH_1}" to)
      elseif(path MATCHES "^patina/")
        set(to include)
      else()
        set(to "another tree")
      endif()
      if(NOT to STREQUAL room AND NOT to IN_LIST allowed)
        string(APPEND breaches "${name} includes ${path}\n")
      endif()
    endforeach()
  endforeach()
endforeach()
file(GLOB_RECURSE files RELATIVE ${ROOT}/compiler ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp ${ROOT}/compiler/*.def)
foreach(file IN LISTS files)
  get_filename_component(folder "${file}" DIRECTORY)
  room_of("${file}" room)
  if(folder STREQUAL "" AND NOT file STREQUAL "compile.cpp")
    string(APPEND breaches "compiler/${file}: only compile.cpp, the list of steps, may be outside the rooms\n")
  elseif(NOT folder STREQUAL "" AND room STREQUAL "" AND NOT folder MATCHES "^(cli|importers)")
    string(APPEND breaches "compiler/${folder} is not in the list of rooms\n")
  endif()
  string(MAKE_C_IDENTIFIER "${folder}" key)
  math(EXPR files_in_${key} "0${files_in_${key}} + 1")
  if(files_in_${key} EQUAL too_many_files)
    string(APPEND breaches "compiler/${folder} has more than ${most_files} files: it is two rooms\n")
  endif()
endforeach()

# A room has the namespace of its folder, or of a folder around it: compiler/lower has patina::lower. What embedding
# programs see, and the rooms that all others use, have patina alone. A block that only declares structs and classes
# of another room is allowed.
file(GLOB_RECURSE files RELATIVE ${ROOT}/compiler ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp)
list(FILTER files EXCLUDE REGEX "^include/")
foreach(file IN LISTS files)
  get_filename_component(folder "${file}" DIRECTORY)
  file(READ ${ROOT}/compiler/${file} text)
  string(REGEX REPLACE "\nnamespace patina::[a-z:]+ {\n((class|struct) [A-Za-z]+;\n)+}" "" text "${text}")
  string(REGEX MATCHALL "\nnamespace patina::[a-z:]+ {" opened "${text}")
  foreach(line IN LISTS opened)
    string(REGEX REPLACE "^.namespace patina::([a-z:]+) {$" "\\1" space "${line}")
    string(REPLACE "::" ";" parts "${space}")
    list(GET parts 0 first)
    if(NOT folder MATCHES "^${first}(/|$)")
      string(APPEND breaches "compiler/${file} is in the namespace patina::${space}, which is not that of its room\n")
    endif()
  endforeach()
endforeach()

# The library also compiles with libc++ 13 (the preset emscripten), which has none of these.
file(GLOB_RECURSE files ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp)
list(FILTER files EXCLUDE REGEX "/compiler/(cli|importers|validate)/")
foreach(file IN LISTS files)
  file(STRINGS ${file} uses REGEX "^[^/]*std::(ranges|bit_cast|lexicographical_compare_three_way)")
  file(RELATIVE_PATH name ${ROOT} ${file})
  foreach(use IN LISTS uses)
    string(APPEND breaches "${name} uses what libc++ 13 does not have: ${use}\n")
  endforeach()
endforeach()

# The declarations of a pass file are read once, in compiler/paths; those of a node file, by the rooms that describe
# nodes.
foreach(room IN ITEMS emit lower link output engines writers interpret)
  file(GLOB_RECURSE files ${ROOT}/compiler/${room}/*.h ${ROOT}/compiler/${room}/*.cpp)
  foreach(file IN LISTS files)
    file(STRINGS ${file} reads REGEX "nodelang::Attribute|attribute\\(\"|attribute_text|attribute_words")
    file(RELATIVE_PATH name ${ROOT} ${file})
    foreach(read IN LISTS reads)
      string(APPEND breaches "${name} reads an attribute again: ${read}\n")
    endforeach()
  endforeach()
endforeach()

# An IR pass does not edit instructions in place (compiler/ir/ir.h), so none of its files has a writable reference to an
# instruction, or to the instructions of a block.
file(GLOB files ${ROOT}/compiler/ir/passes/*.h ${ROOT}/compiler/ir/passes/*.cpp)
foreach(file IN LISTS files)
  file(STRINGS ${file} edits REGEX "(^|[( ])Inst& |vector<(Value|Inst)>& [a-z_]+ = .*insts;|insts\\.(insert|erase|push_back)|insts\\[[a-z_.]+\\]\\.[a-z_]+ = ")
  list(FILTER edits EXCLUDE REGEX "const (Inst|std::vector<(Value|Inst)>)&")
  file(RELATIVE_PATH name ${ROOT} ${file})
  foreach(edit IN LISTS edits)
    string(APPEND breaches "${name} edits a function in place: ${edit}\n")
  endforeach()
endforeach()

# A file (a path in the tree) may include only those files of the tree that match `allowed`.
function(check_includes file allowed)
  file(STRINGS ${file} includes REGEX "^ *#include \"")
  file(RELATIVE_PATH name ${ROOT} ${file})
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^ *#include \"([^\"]*)\".*" "\\1" path "${line}")
    if(NOT path MATCHES "${allowed}")
      string(APPEND breaches "${name} includes ${path}\n")
    endif()
  endforeach()
  set(breaches "${breaches}" PARENT_SCOPE)
endfunction()

# What all trees may use: the room base, which also reads files of the disk, and JSON.
set(of_all "^compiler/(base|json|api/describe)/")

# The command uses the public headers, as any program does that embeds the compiler, and of the runtime its lighting models,
# and what writes files and works on several threads. The program of `import` also uses the importers, and that of
# `render` and `watch` both and the whole runtime.
set(of_command "^(compiler/cli|patina)/|${of_all}")
set(of_importers "^compiler/importers/[a-z_]+\\.h$")
file(GLOB_RECURSE files ${ROOT}/compiler/cli/*.h ${ROOT}/compiler/cli/*.cpp ${ROOT}/compiler/cli/*.in)
foreach(file IN LISTS files)
  if(file MATCHES "/cli/(render|watch)/")
    check_includes(${file} "${of_command}|${of_importers}|^runtime/")
  elseif(file MATCHES "/cli/import/")
    check_includes(${file} "${of_command}|${of_importers}")
  else()
    check_includes(${file} "${of_command}|^runtime/((lighting|files|jobs)/|outcome\\.h$)")
  endif()
endforeach()

# An importer makes graphs with the files of the room importers, and pictures and tables with the runtime. It needs no GPU,
# and knows no other importer. Only the files of the room itself may include more.
file(GLOB files ${ROOT}/compiler/importers/*.h ${ROOT}/compiler/importers/*.cpp)
foreach(file IN LISTS files)
  check_includes(${file} "^(compiler/(importers|base|format|json|nodelang)|patina)/|^runtime/(picture|lighting)/")
endforeach()
file(GLOB folders LIST_DIRECTORIES true ${ROOT}/compiler/importers/*)
foreach(folder IN LISTS folders)
  if(NOT IS_DIRECTORY ${folder})
    continue()
  endif()
  get_filename_component(importer ${folder} NAME)
  file(GLOB_RECURSE files ${folder}/*.h ${folder}/*.cpp)
  foreach(file IN LISTS files)
    check_includes(${file} "^compiler/(json|base|nodelang)/|^compiler/importers/([a-z_]+\\.h$|unity/|${importer}/)|^patina/|^runtime/((picture|lighting|gltf|mesh)/|outcome\\.h$)")
  endforeach()
endforeach()

# The runtime uses the public headers only, the room base, and JSON. A snapshot is a
# file of Patina's own, so it is read as graphs are.
file(GLOB_RECURSE files ${ROOT}/runtime/*.h ${ROOT}/runtime/*.cpp)
foreach(file IN LISTS files)
  file(STRINGS ${file} includes REGEX "^#include \"compiler/")
  list(FILTER includes EXCLUDE REGEX "\"compiler/(base|json)/")
  if(file MATCHES "/runtime/snapshot/")
    list(FILTER includes EXCLUDE REGEX "\"compiler/(format|api)/")
  endif()
  file(RELATIVE_PATH name ${ROOT} ${file})
  if(includes)
    string(APPEND breaches "${name}: ${includes}\n")
  endif()
endforeach()

# --- the rooms of the runtime, from the bottom to the top: room -> rooms that it may include (itself and outcome.h
# always). A room includes only rooms above it in this list, so that there are no circles.
set(runtime_rooms files jobs picture lighting mesh gltf scene lights values frame cpu gpu render bake page snapshot sheet)
set(runtime_files "")
set(runtime_jobs "")
set(runtime_picture "files")
set(runtime_lighting "files;jobs;picture")
set(runtime_mesh "")
set(runtime_gltf "files;mesh")
set(runtime_scene "picture;lighting;mesh;gltf")
set(runtime_lights "picture;mesh;scene")
set(runtime_values "picture;lighting;mesh;scene;lights")
set(runtime_frame "picture;mesh;scene;lights;values")
set(runtime_cpu "jobs;picture;mesh;scene;values;frame")
set(runtime_gpu "picture;values;frame")
set(runtime_render "jobs;picture;mesh;scene;values;frame;cpu;gpu")
set(runtime_bake "picture;mesh;gltf;scene;values;render")
set(runtime_page "")
set(runtime_snapshot "files;picture;mesh;gltf;scene;render;page")
set(runtime_sheet "files;picture;render;page")

set(lower_rooms "")
foreach(room IN LISTS runtime_rooms)
  foreach(to IN LISTS runtime_${room})
    if(NOT to IN_LIST lower_rooms)
      string(APPEND breaches "the table lets runtime/${room} include runtime/${to}, which is not below it\n")
    endif()
  endforeach()
  list(APPEND lower_rooms ${room})
  file(GLOB files ${ROOT}/runtime/${room}/*.h ${ROOT}/runtime/${room}/*.cpp)
  list(LENGTH files count)
  if(count EQUAL 0 OR count GREATER 25)
    string(APPEND breaches "runtime/${room} has ${count} files; a room has 1 to 25\n")
  endif()
  foreach(file IN LISTS files)
    file(RELATIVE_PATH name ${ROOT} ${file})
    file(STRINGS ${file} includes REGEX "^#include [<\"]")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^#include [<\"]([^>\"]*)[>\"].*" "\\1" path "${line}")
      if(path MATCHES "^runtime/([a-z]+)/")
        set(to ${CMAKE_MATCH_1})
        if(NOT to STREQUAL room AND NOT to IN_LIST runtime_${room})
          string(APPEND breaches "${name} includes ${path}\n")
        endif()
      elseif(path MATCHES "^vulkan/" AND NOT room STREQUAL "gpu")
        string(APPEND breaches "${name} includes ${path}: only runtime/gpu knows Vulkan\n")
      endif()
    endforeach()
  endforeach()
endforeach()
file(GLOB folders RELATIVE ${ROOT}/runtime ${ROOT}/runtime/*)
foreach(folder IN LISTS folders)
  if(IS_DIRECTORY ${ROOT}/runtime/${folder} AND NOT folder IN_LIST runtime_rooms)
    string(APPEND breaches "runtime/${folder} is not in the list of rooms\n")
  endif()
endforeach()
# Only render uses the GPU's headers; it opens the device.
file(GLOB_RECURSE files ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp)
foreach(file IN LISTS files)
  file(STRINGS ${file} includes REGEX "^#include \"runtime/gpu/")
  file(RELATIVE_PATH name ${ROOT} ${file})
  if(includes)
    string(APPEND breaches "${name}: ${includes}\n")
  endif()
endforeach()

# Files are read in one place, which refuses what is no regular file, stops at a limit and keeps to a root.
set(readers "^compiler/base/disk/disk\\.cpp$")
# bake.cpp is a program of the build, and files.cpp opens files to write them.
set(writers "^runtime/(lighting/bake|files/files)\\.cpp$")
# OpenImageIO gets bytes, but for formats that it cannot read in memory. Its own ImageInput::open() tries all its readers.
set(opens_pictures "^runtime/picture/open_picture\\.cpp$")
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp ${ROOT}/runtime/*.h ${ROOT}/runtime/*.cpp)
set(found_readers 0)
foreach(file IN LISTS files)
  set(ways "std::ifstream|std::fstream|std::filebuf|std::cin|fopen\\(|::open\\([^\"]|ImageInput::(open|create)|ImageBuf\\(\"|load_file\\(|LoadBinaryFromFile|LoadASCIIFromFile|LoadFile\\(|mmap\\(")
  file(STRINGS ${ROOT}/${file} opens REGEX "${ways}")
  string(REPLACE "\\;" "" opens "${opens}")
  # A folder is opened to lock it.
  list(FILTER opens EXCLUDE REGEX "^ *//|Renderer::open|Builder::open|Flattening::open|O_DIRECTORY")
  if(NOT opens)
    continue()
  endif()
  math(EXPR found_readers "${found_readers} + 1")
  if(file MATCHES "${writers}")
    list(FILTER opens EXCLUDE REGEX "std::ofstream|O_WRONLY")
  elseif(file MATCHES "${opens_pictures}")
    list(FILTER opens EXCLUDE REGEX "ImageInput::create")
  endif()
  if(opens AND NOT file MATCHES "${readers}")
    string(APPEND breaches "${file} opens a file to read it, which compiler/base/disk/disk.h does: ${opens}\n")
  endif()
endforeach()
if(found_readers LESS 3)
  string(APPEND breaches "only ${found_readers} files open files: the search itself is broken\n")
endif()

# No C++ file of the compiler names a node, a pass or a lighting model, because these are data.
set(words "")
file(GLOB_RECURSE node_files ${ROOT}/nodes/*.node.hlsl)
foreach(file IN LISTS node_files)
  file(READ ${file} text)
  string(REGEX MATCHALL "\\[node\\([^]]*\\]( *\\[[a-z]+\\])*[ \n]+[a-zA-Z0-9]+ +[A-Za-z0-9]+\\(" found "${text}")
  foreach(match IN LISTS found)
    string(REGEX REPLACE ".*[ \n]([A-Za-z0-9]+)\\($" "\\1" word "${match}")
    # Words that are ordinary English or C++ are looked for as strings only.
    list(APPEND words ${word})
  endforeach()
endforeach()
file(GLOB model_files RELATIVE ${ROOT}/nodes/models ${ROOT}/nodes/models/*.lighting.json
     ${ROOT}/nodes/models/*.workflow.json)
foreach(file IN LISTS model_files)
  string(REGEX REPLACE "\\..*" "" word ${file})
  list(APPEND words ${word})
endforeach()
file(GLOB pass_files RELATIVE ${ROOT}/nodes/passes ${ROOT}/nodes/passes/*.pass.hlsl)
foreach(file IN LISTS pass_files)
  string(REGEX REPLACE "\\..*" "" word ${file})
  list(APPEND words ${word})
  file(READ ${ROOT}/nodes/passes/${file} text)
  string(REGEX MATCHALL "\\[pass\\(\"[a-z-]+" found "${text}")
  foreach(match IN LISTS found)
    string(REGEX REPLACE ".*\"" "" word ${match})
    list(APPEND words ${word})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES words)
list(REMOVE_ITEM words vertex)  # also a stage
list(LENGTH words count)
if(count LESS 50)
  string(APPEND breaches "only ${count} node names were found: the search itself is broken\n")
endif()
file(GLOB_RECURSE files ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp ${ROOT}/compiler/*.def)
list(FILTER files EXCLUDE REGEX "compiler/cli/|compiler/include/|compiler/(im|ex)porters/")
foreach(file IN LISTS files)
  # Only code counts: comments may give examples.
  file(READ ${file} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  file(RELATIVE_PATH name ${ROOT} ${file})
  foreach(word IN LISTS words)
    if(text MATCHES "\"${word}\"")
      string(APPEND breaches "${name} names \"${word}\"\n")
    endif()
  endforeach()
endforeach()


# The same holds for engines: they are data, and only the writers of their file formats know one
# (compiler/writers/FORMAT).
file(GLOB engine_folders RELATIVE ${ROOT}/nodes/engines ${ROOT}/nodes/engines/*)
list(FILTER engine_folders EXCLUDE REGEX "\\.json$")
list(LENGTH engine_folders count_of_engines)
if(count_of_engines LESS 2)
  string(APPEND breaches "only ${count_of_engines} engines were found: the search itself is broken\n")
endif()
file(GLOB_RECURSE files ${ROOT}/compiler/*.h ${ROOT}/compiler/*.cpp ${ROOT}/compiler/*.def ${ROOT}/runtime/*.h ${ROOT}/runtime/*.cpp)
# A format of another program may hold the name of its engine, so importers may, too; so may the command that writes the
# variables that hold its light, and the table of names in other programs that Patina knows under another name.
list(FILTER files EXCLUDE REGEX "/compiler/(writers|importers|cli/render)/|/nodelang/other_names\\.cpp$")
foreach(file IN LISTS files)
  file(READ ${file} text)
  # Comments may cite an engine's manual or its names as an example; so may the examples of --help.
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\"patina [^\"]*\"" "" text "${text}")
  # Lighting models have names of their own, and Vulkan is what the runtime draws with.
  string(REGEX REPLACE "[\"'][a-z]+-(brdf[0-9])" "" text "${text}")
  string(TOLOWER "${text}" text)
  file(RELATIVE_PATH name ${ROOT} ${file})
  foreach(engine IN LISTS engine_folders)
    if(engine STREQUAL "vulkan")
      set(pattern "\"vulkan\"")
    else()
      set(pattern "${engine}")
    endif()
    if(text MATCHES "${pattern}")
      string(APPEND breaches "${name} names the engine '${engine}'\n")
    endif()
  endforeach()
endforeach()

# --- each room has one main header, whose first line says so
set(rooms_with_headers ${names} ir/fold ir/passes ir/linear emit/operations emit/statements importers cli cli/commands cli/render cli/compile cli/diff cli/pages cli/eval)
list(TRANSFORM rooms_with_headers PREPEND "compiler/")
foreach(room IN LISTS runtime_rooms)
  list(APPEND rooms_with_headers runtime/${room})
endforeach()
foreach(folder IN LISTS rooms_with_headers)
  string(REGEX REPLACE "^(compiler|runtime)/" "" room "${folder}")
  if(room STREQUAL "include")
    set(room "include/patina")
    set(folder "compiler/include/patina")
  elseif(room STREQUAL "validate")
    set(folder "compiler/include/patina")  # its only header
  endif()
  file(GLOB files ${ROOT}/${folder}/*.h)
  set(main_headers 0)
  foreach(file IN LISTS files)
    file(STRINGS ${file} first LIMIT_COUNT 1)
    if(first MATCHES "^// The room `${room}`")
      math(EXPR main_headers "${main_headers} + 1")
    endif()
  endforeach()
  if(NOT main_headers EQUAL 1)
    string(APPEND breaches "${folder} has ${main_headers} headers that begin with \"// The room `${room}`\", not 1\n")
  endif()
endforeach()

if(NOT breaches STREQUAL "")
  message(FATAL_ERROR "layering:\n${breaches}")
endif()
message(STATUS "layering: ${count} names, no breach")
