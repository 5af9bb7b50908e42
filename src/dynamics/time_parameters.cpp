#include "dynamics/time_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void TimeParameters::declare(ParameterSection& section) {
  section.add_choice<Mass>("mass", mass, {{"consistent", Mass::consistent}, {"lumped", Mass::lumped}},
                           "consistent follows the shape functions, lumped puts it into the nodes");
  section.add("mass damping", mass_damping, "1/s", at_least(0.0).usually(1e-5, 1e5),
              "alpha of the Rayleigh damping alpha M + beta K; slows whole motions", "damping takes energy");
  section.add("stiffness damping", stiffness_damping, "s", at_least(0.0).usually(1e-12, 0.2),
              "beta of the Rayleigh damping alpha M + beta K; slows vibrations, the fast ones most",
              "damping takes energy", "For a share z of the critical damping at the period T give z x T / pi.");
  section.add("error tolerance", error_tolerance, "-", above(0.0),
              "error of one automatic time step, relative, energy norm", "an error never vanishes",
              "0.02 resolves impacts, 0.1 gives an impression.");
  section.add("force tolerance", force_tolerance, "-", between(1e-13, 1e-4),
              "of the forces of a time step, relative to the largest; newton > tolerance where that is smaller",
              "below 1e-13 is round-off, above 1e-4 no energy is kept",
              "1e-11 keeps energy over ten thousand steps; 1e-8 is for hundreds of points at their friction bound.");
  section.add("largest Courant number", largest_courant, "-", at_least(1.0),
              "an automatic time step lasts no longer than so many passages of a wave through the smallest cell, than "
              "half the interval of a record, a table or a ramp where it changes, than a twentieth of the period of a "
              "load, and than half the time that an axle stands on a stone; nor, for these, shorter than one passage",
              "one passage is what a cell resolves");
  section.add("largest halvings", largest_halvings, "-", between(0, 30),
              "how often a time step that does not converge may be halved",
              "after 30 halvings a step is 1e-9 of its size", "Give 0 to stop at the first failure.");
}

void InitialVelocityParameters::declare(ParameterSection& section) {
  section.add("blocks", blocks,
              "set of blocks, when the first stage with a duration begins; a later velocity goes before an earlier one",
              Presence::optional, "Give \"all\" or a set of the mesh.");
  section.add("vx", vx, "m/s", any_number().usually(1e-9, 1000), "to the right");
  section.add("vy", vy, "m/s", any_number().usually(1e-9, 1000), "upwards; in space along y");
  section.add("vz", vz, "m/s", any_number().usually(1e-9, 1000), "upwards in space");
  turn.declare(section, "rad/s", 1e-9, 1000,
               "counter-clockwise seen from the end of its axis, added to the velocity of all these blocks",
               "the mass centre of the blocks");
}

std::vector<KeyOfSpace> InitialVelocityParameters::keys_of_space() const {
  auto keys = turn.keys_of_space();
  add_if_given(keys, "vz", vz, "m/s");
  return keys;
}

}  // namespace voussoir
