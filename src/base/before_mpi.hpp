// What Open MPI is told before it starts.
#pragma once

namespace voussoir {

/// To be called once, before MPI starts. Sets variables of the environment that Open MPI reads:
/// - a run without mpirun asks no daemon of Open MPI, which would need a network interface, a loopback at least;
/// - nor does it make the folder in which ranks of a job meet. All such runs of a machine would share one, and one that
///   ends would remove it while another begins;
/// - nor files for pointers of files that ranks share, which would lie there. HDF5 uses no such pointers, and the kind
///   named here makes no file before it is used;
/// - ranks on one machine look for no network: `ob1` sends through memory. To open what drives networks, which `cm` and
///   `ucx` do to see whether there is one, takes a fifth of a second, longer than a small scene;
/// - a single rank waits for nobody, so that it never leaves its core to other programs. Where mpi_yield_when_idle asks
///   for that, each look for a message gives away a slice of time, and MUMPS looks for many: beside a compiler on the
///   same core a run would take many times as long.
/// What a user has set is kept, but for the last.
void before_mpi();

}  // namespace voussoir
