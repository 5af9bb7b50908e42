#include "step/time_step_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void TimeStepParameters::declare(ParameterSection& section) {
  section.add("largest iterations", largest_iterations, "-", between(1, 1e6),
              "linear solves of a time step. Reason: active sets, one path and one closing; half the step is the way "
              "out then");
  section.add("share of fastest", share_of_fastest, "-", above(0.0),
              std::string("relative velocities below this share of the fastest rest. ") + no_reason);
  section.add("share of energy", share_of_energy, "-", above(0.0),
              std::string("and of the velocity that the energy of the structure could give it. ") + no_reason);
  section.add("share of tolerance", share_of_tolerance, "-", above(0.0),
              std::string("of the error tolerance that points which count as resting may make together. ") + no_reason);
  section.add("left by solver", left_by_solver, "-", above(0.0),
              std::string("times the tolerance by which gaps that load steps leave may press. ") + no_reason);
  section.add("no force", no_force, "-", inside(0.0, 1.0),
              std::string("share of the largest force below which a force is none. ") + no_reason);
  section.add("impulse accuracy", impulse_accuracy, "-", inside(0.0, 1.0),
              std::string("of the solve that spreads an impact. ") + no_reason);
  section.add("velocity accuracy", velocity_accuracy, "-", inside(0.0, 1.0),
              "of the projection of velocities. Reason: less lets runs on 1 and 2 ranks part");
  section.add("velocity round off", velocity_round_off, "-", above(0.0),
              "of the largest velocity: what differences of velocities are known to. Reason: the system is singular "
              "at vertices of three blocks");
  section.add("no way", no_way, "-", above(0.0),
              "share of the energy of an impact below which nothing moves behind its points. Reason: round-off");
}

}  // namespace voussoir
