# Compiles material graphs when a project is built: each graph is a step of its own, which is done again when the graph,
# a file that it reads, its options or Patina itself has changed, when a file appears that it would read instead, and
# when one of its outputs was deleted or edited.
#
#   find_package(patina REQUIRED)
#   patina_add_shaders(shaders FOLDER art OPTIONS -t glsl --path deferred)
#   add_dependencies(game shaders)
#
# patina_add_shaders(TARGET
#   [FOLDER folder]       all graphs (*.graph.json) in this folder and below; the output gets the same folders
#   [GRAPHS graph...]     these graphs; their files are directly in the output folder
#   [OUTPUT folder]       where the files go; default: ${CMAKE_CURRENT_BINARY_DIR}/TARGET. If a tree has several
#                         configurations, each has a folder of its own there, unless a generator expression says where
#   [OPTIONS option...]   of 'patina compile', also as generator expressions; paths in them are full ones
#   [DEPENDS file...]     more files that all graphs are made again for
#   [ALL])                build it by default
#
# The property PATINA_OUTPUTS of TARGET is a text file that lists the paths of all files that were made, one a line. It
# gets a new time whenever a graph has been compiled: let a step that reads the shaders depend on it. If a tree has
# several configurations, its name has a generator expression in it.

# The step that joins the lists of the graphs: cmake -D LISTS=(file that lists them) -D FOLDER=(where they are; the joined
# one is named outputs there) -D TARGETS=(for make: the folder with CMake's files of targets) -P patina-shaders.cmake
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  file(STRINGS "${LISTS}" lists ENCODING UTF-8)
  set(text "")
  foreach(list IN LISTS lists)
    file(READ "${FOLDER}/${list}" lines)
    string(APPEND text "${lines}")
  endforeach()
  file(WRITE "${FOLDER}/outputs" "${text}")
  # For make, CMake adds what a graph reads now to all that it ever read. One of these files that is gone would be a reason
  # to compile in every build. So CMake forgets what it knows of this target, and reads the dependency files anew.
  if(TARGETS)
    get_filename_component(name "${FOLDER}" NAME)
    file(GLOB known "${TARGETS}/*.dir/compiler_depend.internal")
    foreach(file IN LISTS known)
      file(READ "${file}" text)
      string(FIND "${text}" "${name}/" place)
      if(NOT place EQUAL -1)
        file(REMOVE "${file}")
      endif()
    endforeach()
  endif()
  return()
endif()

set(PATINA_SHADERS_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")
find_program(PATINA_EXECUTABLE patina DOC "The program that patina_add_shaders() runs"
             HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../bin" "${CMAKE_CURRENT_LIST_DIR}/../../../../bin")

function(patina_refuse_name target name)
  message(FATAL_ERROR "patina_add_shaders(${target}): '${name}': the path of a graph cannot have any of "
                      "; # [ ] \" \\ | < > : % $ in it, which CMake, make and Ninja use themselves: give it another name")
endfunction()

function(patina_add_shaders target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "ALL" "FOLDER;OUTPUT" "GRAPHS;OPTIONS;DEPENDS")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "patina_add_shaders(${target}): cannot use '${arg_UNPARSED_ARGUMENTS}'"
                        "${arg_KEYWORDS_MISSING_VALUES}: the words are FOLDER, GRAPHS, OUTPUT, OPTIONS, DEPENDS and ALL")
  endif()
  if(NOT PATINA_EXECUTABLE)
    message(FATAL_ERROR "patina_add_shaders() needs the program 'patina': install Patina's programs, or set "
                        "PATINA_EXECUTABLE to its path")
  endif()
  if(NOT arg_OUTPUT)
    set(arg_OUTPUT ${target})
  endif()
  set(output "${arg_OUTPUT}")
  if(NOT output MATCHES "^[$]<")
    get_filename_component(output "${output}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  endif()
  # Configurations of one tree may have other options: each has its own files.
  set(own "${CMAKE_CURRENT_BINARY_DIR}/${target}.patina")
  set(names "${own}/lists")
  get_property(is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(is_multi_config)
    string(APPEND own "/$<CONFIG>")
    if(NOT output MATCHES "[$]<")
      string(APPEND output "/$<CONFIG>")
    endif()
  endif()
  # A generator expression may give several options, "$<$<CONFIG:Debug>:-D;shadows>", or none.
  set(options "")
  foreach(option IN LISTS arg_OPTIONS)
    if(NOT option MATCHES "[$]<")
      string(REPLACE ";" "\\;" option "${option}")
    endif()
    string(APPEND options ";${option}")
  endforeach()

  # --- the graphs, each with its path below the output folder
  set(graphs "")
  set(places "")
  foreach(graph IN LISTS arg_GRAPHS)
    get_filename_component(graph "${graph}" ABSOLUTE)
    get_filename_component(place "${graph}" NAME)
    list(APPEND graphs "${graph}")
    list(APPEND places "${place}")
  endforeach()
  if(arg_FOLDER)
    get_filename_component(folder "${arg_FOLDER}" ABSOLUTE)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE "${folder}" "${folder}/*.graph.json")
    list(FILTER found EXCLUDE REGEX "(^|/)\\.")
    foreach(place IN LISTS found)
      if(NOT place MATCHES "\\.graph\\.json$" OR NOT (EXISTS "${folder}/${place}" OR IS_SYMLINK "${folder}/${place}"))
        patina_refuse_name(${target} "${place}")  # a piece of a name with ';'
      endif()
      list(APPEND graphs "${folder}/${place}")
      list(APPEND places "${place}")
    endforeach()
  endif()
  if(NOT graphs)
    message(FATAL_ERROR "patina_add_shaders(${target}): there is no graph '*.graph.json' in '${arg_FOLDER}'; name "
                        "graphs with GRAPHS or a folder with FOLDER")
  endif()

  foreach(graph IN LISTS graphs)
    string(REGEX REPLACE "^[A-Za-z]:" "" path "${graph}")
    if(path MATCHES "[][;#\"\\|<>:%$]")
      patina_refuse_name(${target} "${graph}")
    endif()
  endforeach()

  # --- a step for each
  set(lists "")
  set(lines "")
  foreach(graph place IN ZIP_LISTS graphs places)
    set(list "${own}/${place}.outputs")
    if(list IN_LIST lists)
      message(FATAL_ERROR "patina_add_shaders(${target}): two graphs are named '${place}', and their shaders would be, "
                          "too: give them to two targets with an OUTPUT each, or name their FOLDER")
    endif()
    list(APPEND lists "${list}")
    string(APPEND lines "${place}.outputs\n")
    get_filename_component(below "${place}" DIRECTORY)
    add_custom_command(
      OUTPUT "${list}"
      COMMAND "${PATINA_EXECUTABLE}" compile "${graph}" --output "${output}/${below}" --quiet --depfile
              --depend-on-outputs --list-outputs "${list}" "${options}"
      DEPENDS "${graph}" "${PATINA_EXECUTABLE}" ${arg_DEPENDS}
      DEPFILE "${list}.d"
      COMMENT "Compiling ${place}"
      COMMAND_EXPAND_LISTS
      VERBATIM)
  endforeach()

  # --- one list of all
  set(before "")
  if(EXISTS "${names}")
    file(READ "${names}" before)
  endif()
  if(NOT "${before}" STREQUAL "${lines}")  # else the file keeps its time
    file(WRITE "${names}" "${lines}")
  endif()
  set(targets "")
  if(CMAKE_GENERATOR MATCHES "Makefiles")
    set(targets "-DTARGETS=${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles")
  endif()
  add_custom_command(
    OUTPUT "${own}/outputs"
    COMMAND "${CMAKE_COMMAND}" -D "LISTS=${names}" -D "FOLDER=${own}" "${targets}" -P "${PATINA_SHADERS_SCRIPT}"
    DEPENDS ${lists} "${names}"
    COMMENT "Listing the outputs of ${target}"
    COMMAND_EXPAND_LISTS
    VERBATIM)
  set(all "")
  if(arg_ALL)
    set(all ALL)
  endif()
  add_custom_target(${target} ${all} DEPENDS "${own}/outputs")
  set_target_properties(${target} PROPERTIES PATINA_OUTPUTS "${own}/outputs")
endfunction()
