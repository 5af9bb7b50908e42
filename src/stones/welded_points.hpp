// Points that lie closer than a distance are one: the first of them.
#pragma once

#include <unordered_map>
#include <vector>

#include "stones/surface.hpp"

namespace voussoir {

class WeldedPoints {
 public:
  /// @param within  [m] > 0
  explicit WeldedPoints(double within) : within_(within) {}
  /// The number of the nearest point that is as close as `within`, or of a new one. A cluster is known by its first
  /// point, so that a chain of close points does not drift.
  int add(const Vector<3>&);
  /// The same for a point that is known already; -1 when none is as close.
  int find(const Vector<3>&) const;
  const Places& points() const { return points_; }

 private:
  using Cube = std::array<long long, 3>;
  struct Hash {
    std::size_t operator()(const Cube&) const;
  };
  Cube cube_of(const Vector<3>&) const;

  double within_;
  Places points_;
  std::unordered_map<Cube, std::vector<int>, Hash> cubes_;  ///< by the cube of side 2 within that they lie in
};

}  // namespace voussoir
