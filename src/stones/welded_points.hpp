// Points that lie closer than a distance are one: the first of them.
#pragma once

#include <unordered_map>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// @tparam dim  2 for drawings in the plane, 3 in space
template <int dim>
class WeldedPoints {
 public:
  /// @param within  [m] > 0
  explicit WeldedPoints(double within) : within_(within) {}
  /// The number of the nearest point that is as close as `within`, or of a new one. A cluster is known by its first
  /// point, so that a chain of close points does not drift.
  int add(const Vector<dim>&);
  /// The same for a point that is known already; -1 when none is as close.
  int find(const Vector<dim>&) const;
  const std::vector<Vector<dim>>& points() const { return points_; }

 private:
  using Cube = std::array<long long, static_cast<std::size_t>(dim)>;
  struct Hash {
    std::size_t operator()(const Cube&) const;
  };
  Cube cube_of(const Vector<dim>&) const;

  double within_;
  std::vector<Vector<dim>> points_;
  std::unordered_map<Cube, std::vector<int>, Hash> cubes_;  ///< by the cube of side 2 within that they lie in
};

}  // namespace voussoir
