// How long an attempt of a search for a load factor may take, and what of it is believed (load_factor_analysis.hpp).
#pragma once

#include "base/order_of_magnitude.hpp"
#include "run/static_theorem_parameters.hpp"

namespace voussoir {

struct LoadFactorAnalysisParameters {
  /// Attempts that stand rarely take so many times the linear solves of the dearest that did.
  static constexpr int patience = 5;
  /// The first attempt that stands may need hundreds.
  static constexpr int fewest_solves = 300;
  /// What the dearest load steps that stand take, but for the rarest.
  static constexpr int solves_of_dearest = patience * StaticTheoremParameters::solves_before_asking;
  /// Where what is left undecided cannot be let go in time the first attempt has the patience of the dearest: the
  /// solver tells a mechanism in up to so many.
  static constexpr int fewest_in_statics = patience * solves_of_dearest;
  /// Beyond this share of the structure displacements change what bears what, which small ones leave out.
  static constexpr double small_displacements = 0.01;
  /// A mechanism whose stones overlap by less of its largest motion than this is one: those found far from the limit
  /// overlap by 1e-5.
  static constexpr double believable_overlap = 1 / (order_of_magnitude * order_of_magnitude * order_of_magnitude);
  /// How far along a mechanism the theorem is asked again, as shares of the size of the structure: as far as
  /// displacements are small, and an order of magnitude on.
  static constexpr double shares_along[] = {small_displacements, 10 * small_displacements};
};

}  // namespace voussoir
