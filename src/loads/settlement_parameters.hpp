// Prescribed motion of a support: translation and rotation, in space about any axis.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct SettlementParameters : LoadKindParameters {
  static constexpr const char* word = "settlement";
  static constexpr const char* text = "Prescribed motion of a support";
  std::string support;                            ///< name of a support of the scene; only its held components move
  double ux = 0.0, uy = 0.0, uz = 0.0;            ///< [m] uz in space
  RotationParameters turn;                        ///< [rad] a middle stands for that of the support's edges or faces
  Vector<3> way() const { return {ux, uy, uz}; }  ///< [m]
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
};

}  // namespace voussoir
