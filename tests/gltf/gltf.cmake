# cmake -D PATINA=... -D SOURCE=... -D WORK=... -P gltf.cmake
# The Khronos validator has neither an error nor a warning for the files that `patina bake` writes: every graph of the
# folder graphs/ and every example that can be baked, in both workflows, and with the mesh of a glTF file.
# Prints "skipped: ..." where Node or the package is absent.
cmake_minimum_required(VERSION 3.22)
set(time_limit 300)  # in seconds, for each program

find_program(node NAMES node nodejs NO_CACHE)
if(NOT node)
  message("skipped: Node is absent, so the validator does not run; scripts/setup installs both")
  return()
endif()
if(NOT EXISTS ${SOURCE}/tests/gltf/node_modules/gltf-validator)
  message("skipped: the package gltf-validator is absent: npm ci in tests/gltf, or scripts/setup, with a network")
  return()
endif()

# Exit code and texts of the validator over files.
function(validate)
  execute_process(COMMAND ${node} ${SOURCE}/tests/gltf/validate.mjs ${ARGN} TIMEOUT ${time_limit}
                  RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  set(status "${status}" PARENT_SCOPE)
  set(text "${text}" PARENT_SCOPE)
endfunction()

# A validator that accepts everything proves nothing: a material of this file names a texture that is not there.
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/wrong.gltf
     "{ \"asset\": { \"version\": \"2.0\" }, \"materials\": [{ \"normalTexture\": { \"index\": 3 } }] }")
validate(${WORK}/wrong.gltf)
if(NOT status EQUAL 1 OR NOT text MATCHES "UNRESOLVED_REFERENCE")
  message(FATAL_ERROR "the validator should refuse wrong.gltf, with exit code 1\nexit code ${status}\n${text}")
endif()

# bake(FOLDER OPTION... GRAPH...): all of them are baked.
function(bake folder)
  execute_process(COMMAND ${PATINA} bake --quiet --size 32 -o ${WORK}/${folder} ${ARGN} TIMEOUT ${time_limit}
                  RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "patina bake ${ARGN}: exit code ${status}\n${text}")
  endif()
endfunction()

file(GLOB graphs ${SOURCE}/tests/gltf/graphs/*.graph.json)
bake(metallic ${graphs})
bake(specular --workflow specular-glossiness ${graphs})
bake(torus --mesh torus --format exr ${graphs})
bake(again --mesh ${WORK}/metallic/varied.glb ${graphs})
# Some examples cannot be baked: they read the screen, or have no surface of glTF's kinds.
file(GLOB_RECURSE examples ${SOURCE}/examples/*.graph.json)
execute_process(COMMAND ${PATINA} bake --quiet --size 32 --time 0 --camera position=0,0,4 --env studio
                        -o ${WORK}/examples ${examples}
                TIMEOUT ${time_limit} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
string(REGEX MATCHALL "error: [^\n]*" errors "${text}")
list(FILTER errors EXCLUDE REGEX "\\[(pass-refused|cannot-bake)\\]$")
if(NOT status MATCHES "^[01]$" OR errors)
  message(FATAL_ERROR "patina bake of the examples: exit code ${status}\n${errors}")
endif()

file(GLOB_RECURSE models ${WORK}/*.glb)
list(LENGTH models count)
list(LENGTH examples count_of_examples)
if(count LESS count_of_examples)
  message(FATAL_ERROR "only ${count} models were made")
endif()
validate(${models})
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${text}")
endif()
message("${count} models")
