// Loads of a scene. Each has a type, and acts with the factor of its stage times its function of time.
// A new type of load: its files, and a word in the list below.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "loads/acceleration_parameters.hpp"
#include "loads/buoyancy_parameters.hpp"
#include "loads/crowd_parameters.hpp"
#include "loads/earth_pressure_parameters.hpp"
#include "loads/ground_motion_parameters.hpp"
#include "loads/moving_train_parameters.hpp"
#include "loads/point_load_parameters.hpp"
#include "loads/self_weight_parameters.hpp"
#include "loads/settlement_parameters.hpp"
#include "loads/temperature_parameters.hpp"
#include "loads/time_function_parameters.hpp"
#include "loads/traction_parameters.hpp"
#include "loads/water_pressure_parameters.hpp"

namespace voussoir {

/// Every type of load the program knows.
using LoadKind =
    std::variant<SelfWeightParameters, AccelerationParameters, TractionParameters, SettlementParameters,
                 PointLoadParameters, CrowdParameters, GroundMotionParameters, MovingTrainParameters,
                 EarthPressureParameters, WaterPressureParameters, BuoyancyParameters, TemperatureParameters>;

struct LoadParameters {
  std::string name;
  LoadKind kind;
  TimeFunctionParameters time_function;

  void declare(ParameterSection&);
  /// The type in words, which is the name of the effect.
  std::string word() const;
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
  std::vector<SetOfLoad> sets() const;
  /// Nothing for a load that acts on no facets.
  std::optional<FacetsOfLoad> facets() const;
  /// Files of the load and of its time function.
  std::vector<FileOfLoad> files();
};

/// Words of all types of load, in the order of LoadKind.
std::vector<std::string> load_words();

/// The parameters of a type of load, nullptr when the load is of another.
template <class Parameters>
Parameters* load_as(LoadParameters& load) {
  return std::get_if<Parameters>(&load.kind);
}
template <class Parameters>
const Parameters* load_as(const LoadParameters& load) {
  return std::get_if<Parameters>(&load.kind);
}

}  // namespace voussoir
