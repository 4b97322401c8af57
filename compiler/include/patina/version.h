// The version of these headers, for C and C++. CMakeLists.txt reads it from this file. Until 1.0, another minor version
// may have another API.
//
//   #if PATINA_VERSION >= PATINA_MAKE_VERSION(0, 2, 0)
#pragma once

#define PATINA_VERSION_MAJOR 0  // grows if programs must change
#define PATINA_VERSION_MINOR 1  // grows with additions; until 1.0, also if programs must change
#define PATINA_VERSION_PATCH 0  // grows with corrections
// The three numbers as text: "0.1.0"; patina::version() is that of the library that runs.
#define PATINA_VERSION_STRING "0.1.0"

// A version as one number: a later version is a greater number.
#define PATINA_MAKE_VERSION(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
// PATINA_MAKE_VERSION of these headers.
#define PATINA_VERSION PATINA_MAKE_VERSION(PATINA_VERSION_MAJOR, PATINA_VERSION_MINOR, PATINA_VERSION_PATCH)
