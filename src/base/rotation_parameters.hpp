// A small rotation about an axis, as a scene gives it: of a support that settles, of blocks that fly off.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

class ParameterSection;

/// A key that has a meaning in space alone, and what a plane scene gives it, such as " = 0.1 [m]".
struct KeyOfSpace {
  std::string key, value;
};

/// A number of space where a scene gives one other than its default.
void add_if_given(std::vector<KeyOfSpace>&, const std::string& key, double value, const std::string& unit,
                  double otherwise = 0);

struct RotationParameters {
  double rotation = 0;      ///< [rad or rad/s] counter-clockwise seen from where the axis points to
  Vector<3> axis{0, 0, 1};  ///< of any length; in the plane it points to the reader
  /// Stands for a coordinate of the middle of what turns.
  static constexpr double middle = std::numeric_limits<double>::infinity();
  Vector<3> about{middle, middle, middle};  ///< [m] a point of the axis

  /// @param unit    of the rotation
  /// @param text    what the rotation is
  /// @param turns   what stands for the centre where none is given: "the middle of the support's edges"
  void declare(ParameterSection&, const std::string& unit, double usual_least, double usual_most,
               const std::string& text, const std::string& turns);
  /// Of the axis, length 1.
  Vector<3> direction() const { return (1 / norm(axis)) * axis; }
  /// Fills in the coordinates of the centre that are not given.
  template <std::size_t dim>
  void set_middle(const std::array<double, dim>& found) {
    for (std::size_t c = 0; c < dim; ++c)
      if (std::isinf(about[c])) about[c] = found[c];
  }
  std::vector<KeyOfSpace> keys_of_space() const;
};

/// Velocity of a point at `arm` from the axis of a turn of size one.
inline Vector<2> spin(const Vector<3>&, const Vector<2>& arm) { return {-arm[1], arm[0]}; }
inline Vector<3> spin(const Vector<3>& direction, const Vector<3>& arm) { return cross(direction, arm); }

}  // namespace voussoir
