# Writes the bill of materials, patina.spdx.json, in SPDX 2.3: Patina, its programs and libraries, and every component
# (find_components.cmake) with its version and how it is used. What nobody knows is NOASSERTION.
#
# The same build writes the same file: the time is SOURCE_DATE_EPOCH, or that of configuring, and only if something else
# has changed.
function(to_json text out)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\n" "\\n" text "${text}")
  string(REPLACE "\t" "\\t" text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

set(spdx_packages "")
set(spdx_relationships "")
# spdx_package(NAME VERSION LICENCE COPYRIGHT PURPOSE PURL)
function(spdx_package name version licence copyright purpose purl)
  set(supplier NOASSERTION)
  if(NOT copyright STREQUAL NOASSERTION)
    set(supplier "Organization: Patina contributors")
  endif()
  set(references "")
  if(purl)
    set(references ",\n      \"externalRefs\": [{ \"referenceCategory\": \"PACKAGE-MANAGER\", \"referenceType\": \"purl\", \
\"referenceLocator\": \"${purl}\" }]")
  endif()
  set(spdx_packages "${spdx_packages},
    {
      \"SPDXID\": \"SPDXRef-${name}\",
      \"name\": \"${name}\",
      \"versionInfo\": \"${version}\",
      \"primaryPackagePurpose\": \"${purpose}\",
      \"supplier\": \"${supplier}\",
      \"downloadLocation\": \"NOASSERTION\",
      \"filesAnalyzed\": false,
      \"licenseConcluded\": \"${licence}\",
      \"licenseDeclared\": \"${licence}\",
      \"copyrightText\": \"${copyright}\"${references}
    }" PARENT_SCOPE)
endfunction()
macro(spdx_relationship from type to)
  string(APPEND spdx_relationships ",
    { \"spdxElementId\": \"SPDXRef-${from}\", \"relationshipType\": \"${type}\", \"relatedSpdxElement\": \"SPDXRef-${to}\" }")
endmacro()

string(REGEX MATCH "Copyright [^\n]*" copyright "${license}")
spdx_package(Patina ${PROJECT_VERSION} MIT "${copyright}" SOURCE "")
foreach(product IN LISTS products)
  set(purpose APPLICATION)
  if(product MATCHES "^lib")
    set(purpose LIBRARY)
  endif()
  spdx_package(${product} ${PROJECT_VERSION} MIT "${copyright}" ${purpose} "")
  spdx_relationship(Patina CONTAINS ${product})
endforeach()
foreach(name IN LISTS components)
  spdx_package(${name} ${of_${name}_full_version} "${of_${name}_licence}" NOASSERTION LIBRARY "${of_${name}_purl}")
  foreach(product IN LISTS of_${name}_STATIC)
    spdx_relationship(${product} STATIC_LINK ${name})
  endforeach()
  foreach(product IN LISTS of_${name}_HEADERS)
    spdx_relationship(${product} CONTAINS ${name})
  endforeach()
  foreach(product IN LISTS of_${name}_SHARED)
    spdx_relationship(${product} DYNAMIC_LINK ${name})
  endforeach()
endforeach()

# The licence of glslang's preprocessor has no name in SPDX: its text is a part of the file.
set(spdx_texts "")
if(glslang IN_LIST components)
  file(READ ${CMAKE_CURRENT_SOURCE_DIR}/licences/glslang.txt text)
  string(REGEX MATCH " NVIDIA Corporation\\(\"NVIDIA\"\\) supplies.*POSSIBILITY OF SUCH DAMAGE\\.\n\nFiles: update" text "${text}")
  string(REGEX REPLACE "\n\nFiles: update$" "" text "${text}")
  string(REGEX REPLACE "\n \\.?" "\n" text "${text}")
  to_json("${text}" text)
  set(spdx_texts "\n    { \"licenseId\": \"LicenseRef-NVIDIA\", \"name\": \"NVIDIA software licence of glslang's \
preprocessor\", \"extractedText\": \"${text}\" }\n  ")
endif()

string(REGEX REPLACE "^," "" spdx_packages "${spdx_packages}")
string(REGEX REPLACE "^," "" spdx_relationships "${spdx_relationships}")
string(MD5 hash "${spdx_packages}${spdx_relationships}${spdx_texts}")
string(TIMESTAMP created "%Y-%m-%dT%H:%M:%SZ" UTC)
set(sbom ${CMAKE_CURRENT_BINARY_DIR}/patina.spdx.json)
set(earlier "")
if(EXISTS ${sbom} AND NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  file(STRINGS ${sbom} line REGEX "\"created\": ")
  if(line MATCHES "\"created\": \"([^\"]*)\"")
    set(earlier ${CMAKE_MATCH_1})
  endif()
endif()
foreach(time IN ITEMS "${earlier}" "${created}")
  set(text "{
  \"spdxVersion\": \"SPDX-2.3\",
  \"dataLicense\": \"CC0-1.0\",
  \"SPDXID\": \"SPDXRef-DOCUMENT\",
  \"name\": \"patina-${PROJECT_VERSION}\",
  \"documentNamespace\": \"https://spdx.org/spdxdocs/patina-${PROJECT_VERSION}-${hash}\",
  \"creationInfo\": {
    \"created\": \"${time}\",
    \"creators\": [\"Tool: CMake-${CMAKE_VERSION}\", \"Organization: Patina contributors\"]
  },
  \"documentDescribes\": [\"SPDXRef-Patina\"],
  \"hasExtractedLicensingInfos\": [${spdx_texts}],
  \"packages\": [${spdx_packages}
  ],
  \"relationships\": [
    { \"spdxElementId\": \"SPDXRef-DOCUMENT\", \"relationshipType\": \"DESCRIBES\", \
\"relatedSpdxElement\": \"SPDXRef-Patina\" },${spdx_relationships}
  ]
}
")
  set(before "")
  if(EXISTS ${sbom})
    file(READ ${sbom} before)
  endif()
  if(before STREQUAL "${text}")
    break()
  endif()
endforeach()
write_if_changed(${sbom} "${text}")
