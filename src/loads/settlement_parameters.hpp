// Prescribed motion of a support: translation and small rotation about a point.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct SettlementParameters : LoadKindParameters {
  static constexpr const char* word = "settlement";
  static constexpr const char* text = "Prescribed motion of a support";
  std::string support;        ///< name of a support of the scene; only its held components move
  double ux = 0.0, uy = 0.0;  ///< [m]
  double rotation = 0.0;      ///< [rad] counter-clockwise
  /// Stands for a coordinate of the middle of the support's edges.
  static constexpr double middle = std::numeric_limits<double>::infinity();
  double about_x = middle, about_y = middle;  ///< [m] centre of rotation
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
};

}  // namespace voussoir
