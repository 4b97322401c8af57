// Marks what the library shows to programs. Everything else in it is hidden, so that its own copies of other libraries
// cannot meet a program's.
#pragma once

#if defined(_WIN32)
#define PATINA_API
#else
#define PATINA_API __attribute__((visibility("default")))
#endif
