#include "homogenisation/coarse_operator_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void CoarseOperatorParameters::declare(ParameterSection& section) {
  section.add("shear", shear, "stones that many points let go shear in the block motions");
  section.add("whole factorisation", whole_factorisation,
              "systems on which Krylov's method labours are factored whole");
  section.add("released region", released_region,
              "where little has parted it is solved directly; as preconditioner > released region");
  section.add("block weight", block_weight, "-", inside(0.0, 1.0),
              "w of the block solves. Reason: every contact couples two blocks, so no eigenvalue of S H exceeds 2");
  section.add("same", same, "-", above(0.0),
              "change of a resistance up to which factors stay. Reason: eigenvalues of S H and Q H move by no more "
              "than that");
  section.add("many", many, "-", above(0.0),
              std::string("share of its points that have to give way for a block to shear. ") + no_reason);
  section.add("giving way", giving_way, "-", above(0.0),
              std::string("a point gives way below this share of what the stiffest resists. ") + no_reason);
  section.add("krylov to shear", krylov_to_shear, "-", between(1, 1e6),
              "Krylov iterations of a system after which stones shear in those that follow. Reason: W(64) takes 5 to "
              "11 under its own weight, 20 to 40 when pushed");
  section.add("krylov to factor", krylov_to_factor, "-", between(1, 1e6),
              "Krylov iterations after which a system is factored whole. Reason: whole.md");
  section.add("layers", layers, "-", between(0, 1000),
              "layers of cells around nodes that have parted. Reason: W(128) takes 84, 78, 75, 75 iterations with 1, "
              "2, 3, 4");
  section.add("largest region", largest_region, "-", above(0.0),
              "largest share of all unknowns in them. Reason: beyond, factors cost more than iterations save "
              "(released_region.md)");
  section.add("smallest multigrid", smallest_multigrid, "-", between(1, 1e6),
              "unknowns of the continuum from which on it is preconditioned by multigrid. Reason: MueLu stops "
              "coarsening at 1000; with one level it would be a direct solver on all ranks");
  section.add("even", even, "-", above(0.0),
              "ratio of the stiffest stone to the softest up to which multigrid will do. Reason: beyond, a "
              "factorisation takes a third of its iterations");
  section.add("largest factor", largest_factor, "-", between(1, 1e9),
              "unknowns of the continuum up to which it is factored where stones are uneven. Reason: up to there it "
              "is hardly dearer");
}

}  // namespace voussoir
