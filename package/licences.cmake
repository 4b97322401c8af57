# Writes what is installed and printed of the licences (find_components.cmake): a text for each component whose code is in
# Patina, the LICENSE of the installation, and the C++ file with all of it for `patina --licences`.
function(write_if_changed file text)
  set(before "")
  if(EXISTS ${file})
    file(READ ${file} before)
  endif()
  if(NOT before STREQUAL "${text}")
    file(WRITE ${file} "${text}")
  endif()
endfunction()

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/LICENSE)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
set(installed_license "${license}
Code of others is in Patina's libraries and programs. The folder 'licences' has the text of each licence:

")
set(rows "")
foreach(name IN LISTS components)
  set(text "")
  set(code_in ${of_${name}_STATIC} ${of_${name}_HEADERS})
  list(REMOVE_DUPLICATES code_in)
  list(JOIN code_in ", " code_in)
  list(JOIN of_${name}_SHARED ", " loaded_by)
  set(licence "${of_${name}_licence}")
  if(of_${name}_text)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${of_${name}_text})
    file(READ ${of_${name}_text} text)
    # What the copyright files of Debian refer to.
    string(REPLACE " " ";" words "${licence}")
    foreach(word IN LISTS words)
      if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/licences/${word}.txt)
        file(READ ${CMAKE_CURRENT_SOURCE_DIR}/licences/${word}.txt more)
        string(APPEND text "\n\n${word}:\n\n${more}")
      endif()
    endforeach()
    string(REPLACE NOASSERTION "of an unknown version" version ${of_${name}_version})
    string(APPEND installed_license "${name} ${version}: ${licence}; in ${code_in}\n")
    write_if_changed(${CMAKE_CURRENT_BINARY_DIR}/licences/${name}.txt "${text}")
  endif()
  string(APPEND rows "    {\"${name}\", \"${of_${name}_version}\", \"${licence}\", \"${code_in}\", \"${loaded_by}\",\n"
                     "     R\"LICENCE(${text})LICENCE\"},\n")
endforeach()
write_if_changed(${CMAKE_CURRENT_BINARY_DIR}/LICENSE "${installed_license}")
write_if_changed(${CMAKE_CURRENT_BINARY_DIR}/licence_data.cpp
"// Written by package/licences.cmake. Do not edit.
#include \"compiler/cli/licences/licences.h\"

namespace patina::cli {
namespace {
constexpr ComponentLicence kComponents[] = {
${rows}};
}  // namespace

std::span<const ComponentLicence> component_licences() {
    return kComponents;
}

std::string_view own_licence() {
    return R\"LICENCE(${license})LICENCE\";
}

}  // namespace patina::cli
")
