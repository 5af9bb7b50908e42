// The terms of the energy book: names and kinds. A new term is a member and a line of the table; the book, checkpoints,
// result.json and history.csv follow.
#pragma once

namespace voussoir {

/// [J]
struct Energies {
  double elastic = 0, kinetic = 0;
  double external_work = 0;  ///< of loads and moved supports
  double friction = 0, fracture = 0, damping = 0;
  double jump = 0;               ///< lost in load steps within which equilibrium is lost
  double removed = 0;            ///< left with stones that were taken away and with velocities that load steps drop
  double work_within_steps = 0;  ///< of external work, what mean forces of steps on their ways leave out
};

enum class EnergyKind {
  stored,  ///< at some time; the others are sums
  given,   ///< from outside
  lost,
  part  ///< of another term: counts no second time
};

struct EnergyTerm {
  const char* name;  ///< with its unit
  double Energies::*value;
  EnergyKind kind;
};

inline constexpr EnergyTerm energy_terms[] = {
    {"elastic_J", &Energies::elastic, EnergyKind::stored},
    {"kinetic_J", &Energies::kinetic, EnergyKind::stored},
    {"external_work_J", &Energies::external_work, EnergyKind::given},
    {"friction_J", &Energies::friction, EnergyKind::lost},
    {"fracture_J", &Energies::fracture, EnergyKind::lost},
    {"damping_J", &Energies::damping, EnergyKind::lost},
    {"jump_J", &Energies::jump, EnergyKind::lost},
    {"removed_J", &Energies::removed, EnergyKind::lost},
    {"work_within_steps_J", &Energies::work_within_steps, EnergyKind::part},
};

}  // namespace voussoir
