# find_package(patina [COMPONENTS lighting shaders]) gives patina::patina, and patina::lighting if it was built. They are
# the shared libraries if BUILD_SHARED_LIBS is on and there are some, else the static ones. patina::patina_static,
# patina::patina_shared and the same of lighting name a form. If Patina's programs are installed, there is a function
# patina_add_shaders() (patina-shaders.cmake), the component `shaders`.
if(CMAKE_C_COMPILER_LOADED OR CMAKE_CXX_COMPILER_LOADED)  # a project without both links no library
  include(CMakeFindDependencyMacro)
  find_dependency(Threads)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/patina-targets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/patina-shaders.cmake" OPTIONAL RESULT_VARIABLE patina_shaders_FOUND)
foreach(library IN ITEMS patina lighting)
  set(form static)
  if(BUILD_SHARED_LIBS AND TARGET patina::${library}_shared)
    set(form shared)
  endif()
  if(TARGET patina::${library}_${form} AND NOT TARGET patina::${library})
    add_library(patina::${library} ALIAS patina::${library}_${form})
  endif()
  if(TARGET patina::${library})
    set(patina_${library}_FOUND TRUE)
  endif()
endforeach()
foreach(component IN LISTS patina_FIND_COMPONENTS)
  if(patina_FIND_REQUIRED_${component} AND NOT patina_${component}_FOUND)
    set(patina_FOUND FALSE)
    set(patina_NOT_FOUND_MESSAGE "this installation of Patina has no component '${component}'")
    if(component STREQUAL "shaders")
      string(APPEND patina_NOT_FOUND_MESSAGE ", because Patina's programs are not installed: 'cmake --install', without "
                                             "'--component library', installs everything")
    endif()
  endif()
endforeach()
