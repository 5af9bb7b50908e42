// The energy book: what went in, what is stored, what was lost, and what the book cannot explain.
//
//   imbalance = elastic + kinetic + friction + fracture + damping + jump + removed - external work        [J]
//
// Removed is what left with stones that were taken away, and with velocities where load steps, which know none, follow
// time steps.
//
// External work is forces times ways of loads and moved supports, losses are what the laws of joints take on their way:
// neither is made of the other. In load steps the imbalance tells what the rules for work and loss leave
// (results/load_step_book): it vanishes with the size of the steps. In time steps all is exact, so the part of the
// imbalance that arose in them shows how well they were solved.
#pragma once

#include <string>

#include "base/check.hpp"
#include "base/energies.hpp"

namespace voussoir {

/// What one step adds; what is stored is that at its end. [J]
using EnergyOfStep = Energies;

class EnergyBook {
 public:
  /// @param in_time  true for a time step, false for a load step
  /// @param inner    [J] that blocks store beside u.K u / 2 at its end (blocks/inner_loads.hpp): it is what the loads
  ///                 within them have brought, whatever the way
  void advance(EnergyOfStep step, bool in_time = false, double inner = 0) {
    const double before = imbalance();
    step.elastic += inner;
    step.external_work += inner - inner_;
    inner_ = inner;
    if (!in_time) sum_.removed += sum_.kinetic - step.kinetic;
    for (const auto& term : energy_terms)
      sum_.*term.value = step.*term.value + (term.kind == EnergyKind::stored ? 0.0 : sum_.*term.value);
    if (in_time) imbalance_in_time_ += imbalance() - before;
  }

  /// Names what a checkpoint keeps (output/checkpoint.hpp).
  template <class Archive>
  void keep(Archive& archive) {
    for (const auto& term : energy_terms) archive.value("energy." + std::string(term.name), sum_.*term.value);
    archive.value("energy.imbalance_in_time_J", imbalance_in_time_);
    archive.value("energy.inner_J", inner_);
  }

  const Energies& sums() const { return sum_; }
  double elastic() const { return sum_.elastic; }
  double kinetic() const { return sum_.kinetic; }
  double external_work() const { return sum_.external_work; }
  double friction() const { return sum_.friction; }
  double fracture() const { return sum_.fracture; }
  double imbalance() const {
    double left = 0;
    for (const auto& term : energy_terms)
      if (term.kind != EnergyKind::part) left += (term.kind == EnergyKind::given ? -1 : 1) * (sum_.*term.value);
    return left;
  }
  double imbalance_in_time() const { return imbalance_in_time_; }
  /// The velocities a structure is given before its first time step.
  void give(double kinetic) {
    VOUSSOIR_EXPECT(kinetic >= 0 && "kinetic energy: not negative");
    sum_.kinetic += kinetic;
    sum_.external_work += kinetic;
    sum_.work_within_steps += kinetic;
  }
  /// What stones that are taken away take along. @param inner  [J] beside it, of what blocks store beside u.K u / 2
  void remove(double energy, double inner = 0) {
    sum_.removed += energy + inner;
    inner_ -= inner;
  }

 private:
  Energies sum_;
  double imbalance_in_time_ = 0, inner_ = 0;
};

}  // namespace voussoir
