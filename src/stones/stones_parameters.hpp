// Stones in space from a file: what a scene says of it.
#pragma once

#include <map>
#include <string>

namespace voussoir {

class ParameterSection;

/// The axis of the file that points up; in a scene that is z. Others are turned, never mirrored.
enum class UpAxis { x, y, z };

/// Hexahedra where stones are boxes and joints allow it, tetrahedra elsewhere; or tetrahedra alone.
enum class StoneCells { by_shape, tetrahedra };

/// Tetrahedra that are quadratic between joints and linear on them, or linear ones.
enum class StoneElement { quadratic, linear };

struct StonesParameters {
  std::string file;   ///< or a folder; a scene that was read holds an absolute path
  double unit = 1.0;  ///< [m] length that the file calls 1
  UpAxis up = UpAxis::z;
  double joint_tolerance = 0;  ///< [m] 0 = a part of the stones' size
  double weld = 0;             ///< [m] 0 = a multiple of the tolerance
  double element_size = 0;     ///< [m] 0 = a part of the stones' size
  StoneCells cells = StoneCells::by_shape;
  StoneElement element = StoneElement::quadratic;
  std::map<std::string, double> geometry;  ///< numbers set in a .geo, by name, in its units
  void declare(ParameterSection&);
};

}  // namespace voussoir
