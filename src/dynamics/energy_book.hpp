// The energy book: what went in, what is stored, what was lost, and what the book cannot explain.
//
//   imbalance = elastic + kinetic + friction + fracture - external work        [J]
//
// In load steps the work of contact forces is that of their mean over a step. Friction and fracture are what sticks
// to the tangential direction and to joints that broke; the pressure of a joint that opened within a step is the
// imbalance: it vanishes with the size of the steps.
#pragma once

namespace voussoir {

class EnergyBook {
 public:
  /// Books one step: stored energies at its end, increments of the others.
  void advance(double elastic_at_end, double kinetic_at_end, double external_work, double friction, double fracture) {
    elastic_ = elastic_at_end;
    kinetic_ = kinetic_at_end;
    external_work_ += external_work;
    friction_ += friction;
    fracture_ += fracture;
  }

  /// Names what a checkpoint keeps (output/checkpoint.hpp).
  template <class Archive>
  void keep(Archive& archive) {
    archive.value("energy.elastic_J", elastic_);
    archive.value("energy.kinetic_J", kinetic_);
    archive.value("energy.external_work_J", external_work_);
    archive.value("energy.friction_J", friction_);
    archive.value("energy.fracture_J", fracture_);
  }

  double elastic() const { return elastic_; }
  double kinetic() const { return kinetic_; }
  double external_work() const { return external_work_; }
  double friction() const { return friction_; }
  double fracture() const { return fracture_; }
  double imbalance() const { return elastic_ + kinetic_ + friction_ + fracture_ - external_work_; }

 private:
  double elastic_ = 0, kinetic_ = 0, external_work_ = 0, friction_ = 0, fracture_ = 0;
};

}  // namespace voussoir
