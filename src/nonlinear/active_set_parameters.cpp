#include "nonlinear/active_set_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ActiveSetParameters::declare(ParameterSection& section) {
  section.add("augmentation in time", augmentation_in_time, "-", above(0.0),
              "resistance of closed points in time, relative to their local stiffness. Reason: the first second of "
              "the bridge's earthquake takes 319 solves with 100, 291 with 1000, 297 with 10^4");
  section.add(
      "alike", alike, "-", inside(0.0, 1.0),
      "share of the change of forces by which the next may differ and be out of balance, and still goes round a "
      "vertex. Reason: one that nodes answer to is out of balance by all of itself and differs by orders of "
      "magnitude; one that goes round comes again to round-off, out of balance by the accuracy of linear solves");
  section.add("accuracy", accuracy, "-", inside(0.0, 1.0),
              "of linear solves, relative to their right side. Reason: what a solve leaves looks like points that "
              "change: the first second of the bridge's earthquake takes 338 solves with 1e-2, 291 with 1e-4");
  section.add(
      "patience", patience, "-", between(1, 1e6),
      "solves that gain too little after which it circles. Reason: A(61) takes 21, 31 with 3; the trough of the "
      "ablation 219, 259 with 24");
  section.add("gained", gained, "-", inside(0.0, 1.0),
              "share of the best residual below which a solve has gained. Reason: a step halved would gain as much; a "
              "third of it moves no count by a tenth");
  section.add("many krylov", many_krylov, "-", between(1, 1e6),
              "Krylov iterations of a solve at rest, at most; one that has taken them and not gained means stones that "
              "nothing holds: another way is taken. Reason: a preconditioned system of stones that bear takes 3 to 30");
  section.add("many krylov in space", many_krylov_in_space, "-", between(1, 1e6),
              "the same of stones in space. Reason: with a third of the joints open and the resistance of active sets "
              "sound systems of 100 to 1000 stones take 45 to 460");
  section.add(
      "damping", damping, "-", at_least(0.0),
      "resistance of points that give way once a stone is lost, relative to their local stiffness, a tenth of it "
      "where patches begin; 0: none. It rises by the growth that means a lost stone with every repeated solve, as "
      "long as that helps, in patches by the root of that with every step that is cut, and falls by it with every "
      "other step. Reason: stones that nothing holds would fly; arches of 31, 61 and 121 stones take 37, 25, 24 "
      "solves, with 0.01 57, 23, 52");
}

}  // namespace voussoir
