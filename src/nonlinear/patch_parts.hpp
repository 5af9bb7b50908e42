// What a patch is made of: stiffness, points, and what holds it at its border.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "joints/contact_law.hpp"

namespace voussoir {

/// What a contact point is, wherever its nodes are. In the plane the third of all is nothing.
struct PointOfPatch {
  std::array<Vector<3>, 3> axis{};  ///< normal, tangents
  PointLaw law;
  double local_stiffness = 0;  ///< [N/m]
  PointCompliance compliance;
  Vector<3> slip_origin{}, gap{};  ///< [m] where the stones are
  Vector<3> force{};               ///< [N]
  PointStiffness resistance;       ///< at the border
};

/// An unknown that moves a point, along an axis of the drawing; what holds still has none.
struct PatchShare {
  int unknown = 0, component = 0;
  double weight = 0;  ///< negative on side i
};

/// A contact point of a patch.
struct PatchPoint : PointOfPatch {
  std::vector<PatchShare> shares;

  /// How far an unknown moves its gap along an axis.
  double share(const PatchShare& s, int along) const { return s.weight * axis[along][s.component]; }
  /// What a force [N] along its axes does to an unknown.
  double force_on(const PatchShare&, const double* of_point, int components) const;
  /// Motion of its gap when the unknowns move [m].
  Vector<3> motion(const double* displacement) const;
};

/// What a patch is made of.
struct PatchParts {
  struct Entry {
    int row = 0, column = 0;
    double value = 0;
  };
  int components = 0;                   ///< of its points
  std::vector<double> imbalance;        ///< [N] of each unknown: K u - f without the forces of its points
  std::vector<double> start;            ///< [m] from where the stones are to where the path begins
  std::vector<double> proximal_weight;  ///< [N/m]
  std::vector<Entry> stiffness;         ///< [N/m] of the blocks, in any order; equal places add
  std::vector<PatchPoint> points, border;
  double force_scale = 0;   ///< [N] of the whole structure
  double length_scale = 0;  ///< [m] likewise
};

}  // namespace voussoir
