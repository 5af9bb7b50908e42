// Loads of a scene. Each has a type; a load acts with the factor its step gives it.
#pragma once

#include <string>

#include "loads/time_function_parameters.hpp"

namespace voussoir {

class ParameterSection;

/// Weight of every block: density x volume x gravity, downwards (-y).
struct SelfWeightParameters {
  double gravity = 9.81;  ///< [m/s2]
  void declare(ParameterSection&);
};

/// The same acceleration on every block, as an inertia force density x volume x (ax, ay).
struct AccelerationParameters {
  double ax = 0.0, ay = 0.0;  ///< [m/s2]
  void declare(ParameterSection&);
};

/// Traction on a set of facets, dead (does not follow the deformation).
struct TractionParameters {
  std::string on;             ///< a set of facets
  double tx = 0.0, ty = 0.0;  ///< [Pa]
  double pressure = 0.0;      ///< [Pa] against the outward normal, added to (tx, ty)
  void declare(ParameterSection&);
};

/// Prescribed motion of a support: translation and small rotation about a point.
struct SettlementParameters {
  std::string support;        ///< name of a support of the scene; only its held components move
  double ux = 0.0, uy = 0.0;  ///< [m]
  double rotation = 0.0;      ///< [rad] counter-clockwise
  double about_x = 0.0, about_y = 0.0;  ///< [m] centre of rotation
  void declare(ParameterSection&);
};

enum class LoadType { self_weight, acceleration, traction, settlement };

struct LoadParameters {
  std::string name;
  LoadType type = LoadType::self_weight;
  SelfWeightParameters self_weight;
  AccelerationParameters acceleration;
  TractionParameters traction;
  SettlementParameters settlement;
  TimeFunctionParameters time_function;
  void declare(ParameterSection&);
};

}  // namespace voussoir
