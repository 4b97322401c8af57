# A build from nothing spends most of its time on headers. Those that everything includes are compiled once.
#
# Patina's own headers are not among them: a change of one compiles again only what includes it.
#
# Without PATINA_PRECOMPILED each file is compiled by itself. The preset `clang` does so, and finds a file that lacks an
# include.
option(PATINA_PRECOMPILED "Compile the headers of the standard library once" ON)
set(PATINA_HEADERS <algorithm> <array> <charconv> <cmath> <cstdint> <functional> <limits> <map> <memory>
    <optional> <set> <span> <string> <string_view> <tuple> <unordered_map> <utility> <vector> <fmt/format.h>)

# precompile_headers(TARGET [<header>...]): with more headers that most of its files include. Targets that are compiled
# with the same options and headers share them.
function(precompile_headers target)
  if(NOT PATINA_PRECOMPILED)
    return()
  endif()
  get_directory_property(options COMPILE_OPTIONS)
  get_directory_property(definitions COMPILE_DEFINITIONS)
  get_target_property(is_pic ${target} POSITION_INDEPENDENT_CODE)
  string(MD5 key "${options} ${definitions} ${is_pic} ${ARGN}")
  get_property(owner GLOBAL PROPERTY PATINA_HEADERS_${key})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${PATINA_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY PATINA_HEADERS_${key} ${target})
  endif()
endfunction()
