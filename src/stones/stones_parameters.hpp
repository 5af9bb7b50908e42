// Stones from a file, in space or drawn in the plane: what a scene says of it.
#pragma once

#include <map>
#include <string>

namespace voussoir {

class ParameterSection;

/// The axis of the file that points up: in space z of the scene; others are turned, never mirrored. In the plane
/// it is y; a drawing whose y runs down the page is seen as it is on the page.
enum class UpAxis { usual, x, y, z, minus_y };

/// Hexahedra where stones are boxes and joints allow it, tetrahedra elsewhere; or tetrahedra alone. In the plane
/// quadrilaterals where stones are, triangles elsewhere; or triangles alone, linear ones or such that bend.
enum class StoneCells { by_shape, tetrahedra, triangles, quadratic_triangles };

/// Tetrahedra that are quadratic between joints and linear on them, or linear ones.
enum class StoneElement { quadratic, linear };

struct StonesParameters {
  std::string file;   ///< or a folder; a scene that was read holds an absolute path
  double unit = 1.0;  ///< [m] length that the file calls 1
  UpAxis up = UpAxis::usual;
  double snap = 0;             ///< [m] of a drawing: corners that are nearer are one; 0 = from the drawing
  double joint_tolerance = 0;  ///< [m] 0 = a part of the stones' size
  double weld = 0;             ///< [m] 0 = a multiple of the tolerance
  double element_size = 0;     ///< [m] 0 = a part of the stones' size
  StoneCells cells = StoneCells::by_shape;
  StoneElement element = StoneElement::quadratic;
  std::map<std::string, double> geometry;  ///< numbers set in a .geo, by name, in its units
  /// Whether the file is a drawing in the plane (.csv, .dxf, .svg, .geojson), by its ending.
  bool is_drawing() const;
  void declare(ParameterSection&);
};

}  // namespace voussoir
