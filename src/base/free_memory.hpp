// How much memory there is, as the kernel tells it.
#pragma once

namespace voussoir {

/// [bytes] That this machine has, or the group of processes that this one is counted in, if that is allowed less.
double whole_memory();
/// [bytes] Of that, what nobody uses now.
double free_memory();
/// [bytes] That this process can write to, used or not: what RLIMIT_DATA counts.
double data_of_this_process();

}  // namespace voussoir
