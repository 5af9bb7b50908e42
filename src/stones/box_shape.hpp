// Stones that are boxes: six quadrilateral facets, eight corners. Right angles are not asked for.
#pragma once

#include <optional>

#include "stones/stone_structure.hpp"

namespace voussoir {

/// A box as the image of the unit cube: trilinear between its corners.
struct BoxShape {
  std::array<Vector<3>, 8> corner{};  ///< in the order of a hexahedral cell
  double size = 0;                    ///< [m] longest edge

  Vector<3> place(const Vector<3>& at) const;
  /// Where in the cube a place is, by Newton's method; meant for places on or near the box.
  Vector<3> where(const Vector<3>& place) const;
  /// [m3] of the box for one of the cube, at a place of the cube; negative where it is turned inside out.
  double jacobian(const Vector<3>& at) const;
  double volume() const;  ///< [m3]
  /// [m] longest of the four edges along a direction.
  double length(int direction) const;
};

/// Corners of a cube, in the order of a hexahedral cell.
inline constexpr std::array<std::array<int, 3>, 8> cube_corners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// The shape of a stone over the points of the imprint; nothing when it is no box.
std::optional<BoxShape> box_shape(const StoneStructure&, int stone);

}  // namespace voussoir
