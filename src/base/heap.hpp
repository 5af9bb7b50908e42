// How the heap gives memory back to the system: not before the program ends.
//
// Each factorisation asks for tens of megabytes that the one before has freed. By default glibc gives such blocks back
// and the system clears their pages anew. Kept, W(64) takes 7 % (adaptive) and 16 % (every point selected) less time of
// the processor, W(256) 8, the bridge's main job 6; peaks are 0 to 6 % higher (W(64), adaptive, 512 MiB for 483).
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace voussoir {

/// Blocks that are freed stay with the program, for the next ones. Other C libraries than glibc do as they do.
inline void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);  // no block of its own mapping
  mallopt(M_TRIM_THRESHOLD, -1);  // [bytes] free at the end of the heap: any number
#endif
}

}  // namespace voussoir
