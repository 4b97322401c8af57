// Marks the functions and classes that the library exports. All other symbols are hidden, so that the library's copies
// of other libraries do not conflict with those of a program.
#pragma once

#if defined(_WIN32)
#define PATINA_API
#else
#define PATINA_API __attribute__((visibility("default")))
#endif
