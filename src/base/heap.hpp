// How the heap gives memory back to the system: not before the program ends.
//
// Each factorisation asks for tens of megabytes that the one before has freed. By default glibc gives such blocks back
// and the system clears their pages anew. Keeping them saves 6 to 16 % of the time of the processor on walls and on the
// bridge, and raises the peak of memory by at most 6 %.
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace voussoir {

/// Blocks that are freed stay with the program, for the next ones. Other C libraries than glibc do as they do.
inline void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);         // no block of its own mapping
  mallopt(M_TRIM_THRESHOLD, -1);  // [bytes] free at the end of the heap: any number
#endif
}

}  // namespace voussoir
