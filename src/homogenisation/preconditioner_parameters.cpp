#include "homogenisation/preconditioner_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void PreconditionerParameters::declare(ParameterSection& section) {
  section.add("homogenised", homogenised, "the bonded continuum, by algebraic multigrid");
  section.add("rigid blocks", rigid_blocks, "rigid motions of the blocks, solved directly");
  section.add("block local", block_local, "exact solves on single blocks");
  section.add("released region", released_region,
              "where few nodes have parted, direct solution around them instead of the two before");
  section.add("factored up to", factored_up_to, "-", between(0, 1e8),
              "unknowns of a system that is factored whole once it has taken 20 Krylov iterations, 0: none is",
              "factors take 1.5 kB of memory per unknown of a million in the plane; in space they fill in more, and "
              "none are made that would take more than so many of the plane");
}

}  // namespace voussoir
