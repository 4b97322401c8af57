# The code of others: what is in Patina's programs and libraries, and what they are linked with. One row each. The list
# of `patina --licences`, the texts of licences that are installed and the bill of materials (patina.spdx.json) are made of
# it, and tests/package compares it with what the linker and the compiler read.
#
# component(NAME
#   LICENCE spdx        as SPDX writes it
#   FILE file           a header or a library of the package: it finds the package and so its version
#   MODULE name         what pkg-config calls it: the version where there is no dpkg
#   TEXT_OF version     the version whose licence package/licences/NAME.txt is, the file `copyright` of Debian's package;
#                       left out if no code of it is in ours
#   STATIC product...   a static library is in these
#   HEADERS product...  inline functions and templates of its headers are in these
#   SHARED product...   these load its shared library)
set(others patina patina-import patina-render)

component(fmt LICENCE MIT FILE fmt/format.h MODULE fmt TEXT_OF 9.1.0 HEADERS libpatina ${others})
component(rapidjson LICENCE MIT FILE rapidjson/reader.h MODULE RapidJSON TEXT_OF 1.1.0 HEADERS libpatina ${others})
component(glm LICENCE MIT FILE glm/glm.hpp MODULE glm TEXT_OF 0.9.9.8 HEADERS libpatina-lighting ${others})
component(cli11 LICENCE BSD-3-Clause FILE CLI/CLI.hpp MODULE CLI11 TEXT_OF 2.1.2 HEADERS ${others})
if(NOT CMAKE_CXX_FLAGS MATCHES "fsanitize")  # sanitizers have an allocator of their own
  component(mimalloc LICENCE MIT FILE libmimalloc.so TEXT_OF 2.0.9 HEADERS patina SHARED patina)
endif()
# A part of glslang's parser is made by Bison; the preprocessor has a licence of its own.
component(glslang
  LICENCE "BSD-3-Clause AND MIT AND GPL-3.0-or-later WITH Bison-exception-2.2 AND LicenseRef-NVIDIA"
  FILE libglslang.a TEXT_OF 12.0.0 HEADERS patina patina-render STATIC patina patina-render)
component(spirv-tools LICENCE Apache-2.0 FILE libSPIRV-Tools.a MODULE SPIRV-Tools TEXT_OF 2023.1
  HEADERS patina patina-render STATIC patina patina-render)
# The tables of instructions in the two above are made from it. No file says from which version.
component(spirv-headers LICENCE MIT TEXT_OF NOASSERTION STATIC patina patina-render)
component(tinygltf LICENCE "MIT AND BSL-1.0" FILE libtinygltf.so MODULE tinygltf TEXT_OF 2.7.0
  HEADERS patina-import patina-render SHARED patina-import patina-render)
component(draco LICENCE Apache-2.0 FILE libdraco.so MODULE draco TEXT_OF 1.5.5
  HEADERS patina-import patina-render SHARED patina-import patina-render)
component(nlohmann-json LICENCE MIT FILE nlohmann/json.hpp MODULE nlohmann_json TEXT_OF 3.11.2
  HEADERS patina-import patina-render)
component(pugixml LICENCE MIT FILE libpugixml.so MODULE pugixml TEXT_OF 1.13
  HEADERS patina-import patina-render SHARED patina-import patina-render)
component(yaml-cpp LICENCE MIT FILE libyaml-cpp.so MODULE yaml-cpp TEXT_OF 0.7.0
  HEADERS patina-import patina-render SHARED patina-import patina-render)
component(openimageio LICENCE "BSD-3-Clause AND MIT" FILE libOpenImageIO.so MODULE OpenImageIO TEXT_OF 2.4.7.1
  HEADERS patina-render SHARED patina-render)
# Declarations only: no code of these is in the programs.
component(vulkan-loader LICENCE Apache-2.0 FILE libvulkan.so MODULE vulkan SHARED patina-render)
component(graphviz LICENCE EPL-1.0 FILE libgvc.so MODULE libgvc SHARED patina-render)
# What every program in C++ has. Their licences ask nothing of programs that are compiled with them.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  component(gcc-runtime LICENCE "GPL-3.0-or-later WITH GCC-exception-3.1" FILE libstdc++.so.6
    SHARED libpatina libpatina-lighting ${others})
  component(glibc LICENCE LGPL-2.1-or-later FILE libc.so.6 SHARED libpatina libpatina-lighting ${others})
endif()
