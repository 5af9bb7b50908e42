// Leaks of memory, in builds with the address sanitizer; otherwise nothing of this does anything.
//
// They are looked for between the start and the end of MPI: plug-ins it has unloaded when the process ends take the
// only pointers to their memory with them, which is no leak of ours. cmake/leaks.txt names what the libraries keep.
#pragma once

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace voussoir::leaks {

#ifdef __SANITIZE_ADDRESS__
inline void ignore_from_here() { __lsan_disable(); }
inline void watch_from_here() { __lsan_enable(); }
/// Whether memory was lost that was allocated while watched; says what and where.
inline bool found() { return __lsan_do_recoverable_leak_check() != 0; }
#else
inline void ignore_from_here() {}
inline void watch_from_here() {}
inline bool found() { return false; }
#endif

}  // namespace voussoir::leaks
