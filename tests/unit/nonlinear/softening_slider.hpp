// The node of the slider, mortared to the ground and held by springs along and across it, is pulled off.
#pragma once

#include "unit/nonlinear/slider.hpp"

namespace voussoir::test {

/// How it is pulled and what its mortar is like.
struct Mortar {
  double up = 80, along = 0;  ///< [N]
  Softening rate{5, 2, false};
  double compliance = 0;  ///< [m/N]
};

class Mortared : public Patch {
 public:
  static constexpr double strength = 50, cohesion = 100;  // [N]
  explicit Mortared(const Mortar& mortar)
      : Patch(parts(mortar)), rate_(1, mortar.rate), points_(law(), rate_, none_, none_) {}
  const SofteningPoints* softening() const override { return &points_; }

 private:
  static PatchParts parts(const Mortar& mortar) {
    auto parts = parts_of_slider(0);
    parts.imbalance = {-mortar.along, -mortar.up};
    parts.proximal_weight = {0, 0};
    parts.stiffness = {{0, 0, spring}, {1, 1, spring}};
    parts.points[0].law = {0.6, cohesion, strength};
    if (mortar.compliance > 0) parts.points[0].compliance = {mortar.compliance, mortar.compliance};
    return parts;
  }
  const std::vector<Softening> rate_;
  const std::vector<double> none_{0};
  const SofteningPoints points_;
};

}  // namespace voussoir::test
