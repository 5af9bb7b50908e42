#include "scene/internals.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void Internals::declare(ParameterSection& section) {
  section.add_section("contact solver", methods.solver, "the order of the ways through the contact conditions");
  section.add_section("active set", methods.active_set, "semismooth Newton with Coulomb's coupling");
  section.add_section("patches", methods.patches, "stones that are brought to rest alone");
  section.add_section("interior path", methods.path, "the way that leads from anywhere");
  section.add_section("pseudo-time", methods.pseudo_time,
                      "what follows where the path ends early, and tells collapses");
  section.add_section("preconditioner", preconditioner, "of linear systems");
  section.add_section("rest", rest, "points that are bonded again, and marking");
  section.add_section("step", step, "rounds of selection, their system, rotations that are followed");
  section.add_section("time step", time_step, "what rests, and velocities");
  section.add_section("ties", ties, "stones that nothing but ties holds");
}

}  // namespace voussoir
