// The energy book: what went in, what is stored, what was lost, and what the book cannot explain.
//
//   imbalance = elastic + kinetic + friction + fracture + damping - external work        [J]
//
// In load steps friction takes the force at the end of the step times the slip, and the imbalance tells what the rule
// for work and loss leaves (run/load_step_book): it vanishes with the size of the steps. In time steps all is
// exact, so the part of the imbalance that arose in them shows how well they were solved.
#pragma once

namespace voussoir {

/// What one step adds. [J]
struct EnergyOfStep {
  double elastic_at_end = 0, kinetic_at_end = 0;
  double external_work = 0, friction = 0, fracture = 0, damping = 0;
};

class EnergyBook {
 public:
  /// @param in_time  true for a time step, false for a load step
  void advance(const EnergyOfStep& step, bool in_time = false) {
    const double before = imbalance();
    elastic_ = step.elastic_at_end;
    kinetic_ = step.kinetic_at_end;
    external_work_ += step.external_work;
    friction_ += step.friction;
    fracture_ += step.fracture;
    damping_ += step.damping;
    if (in_time) imbalance_in_time_ += imbalance() - before;
  }

  /// Names what a checkpoint keeps (output/checkpoint.hpp).
  template <class Archive>
  void keep(Archive& archive) {
    archive.value("energy.elastic_J", elastic_);
    archive.value("energy.kinetic_J", kinetic_);
    archive.value("energy.external_work_J", external_work_);
    archive.value("energy.friction_J", friction_);
    archive.value("energy.fracture_J", fracture_);
    archive.value("energy.damping_J", damping_);
    archive.value("energy.imbalance_in_time_J", imbalance_in_time_);
  }

  double elastic() const { return elastic_; }
  double kinetic() const { return kinetic_; }
  double external_work() const { return external_work_; }
  double friction() const { return friction_; }
  double fracture() const { return fracture_; }
  double damping() const { return damping_; }
  double imbalance() const { return elastic_ + kinetic_ + friction_ + fracture_ + damping_ - external_work_; }
  double imbalance_in_time() const { return imbalance_in_time_; }
  /// The velocities a structure is given before its first time step.
  void give(double kinetic) {
    kinetic_ += kinetic;
    external_work_ += kinetic;
  }

 private:
  double elastic_ = 0, kinetic_ = 0, external_work_ = 0, friction_ = 0, fracture_ = 0, damping_ = 0;
  double imbalance_in_time_ = 0;
};

}  // namespace voussoir
