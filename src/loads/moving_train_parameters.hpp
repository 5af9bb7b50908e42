// Axles that move along an edge, or in space on a track along x.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct MovingTrainParameters : LoadKindParameters {
  static constexpr const char* word = "moving train";
  static constexpr const char* text = "Axle loads that move along an edge, in space on a track along x";
  std::string on;                      ///< a set of facets
  std::string blocks;                  ///< a set of blocks whose facets alone are meant; "" for all of the set
  std::string axle_loads, spacings;    ///< numbers, as text
  double position = 0.0, speed = 0.0;  ///< [m] of the first axle at time 0, [m/s] along x
  double y = 0.0, gauge = 0.0;    ///< [m] in space: middle of the track, between its two lines of wheels; 0: one line
  std::vector<double> axle_load;  ///< [N] downwards, in the plane on the modelled thickness
  std::vector<double> behind;     ///< [m] of each axle, how far it is behind the first
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
  std::vector<SetOfLoad> sets() const { return sets_of(on, blocks); }
  std::optional<FacetsOfLoad> facets() const;
};

}  // namespace voussoir
