// operator new and delete of the command: a compile makes some ten thousand small things and frees them together.
#include <mimalloc-new-delete.h>
