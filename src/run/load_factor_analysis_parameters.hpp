// How long an attempt of a search for a load factor may take, and what of it is believed (load_factor_analysis.hpp).
#pragma once

namespace voussoir {

struct LoadFactorAnalysisParameters {
  /// Attempts that stand rarely take so many times the linear solves of the dearest that did.
  static constexpr int patience = 5;
  /// The first attempt that stands may need hundreds.
  static constexpr int fewest_solves = 300;
  /// Where what is left undecided cannot be let go in time: the solver tells a mechanism in up to so many.
  static constexpr int fewest_in_statics = 1000;
  /// Beyond this share of the structure displacements change what bears what, which small ones leave out.
  static constexpr double small_displacements = 0.01;
  /// A mechanism whose stones overlap by less of its largest motion than this is one: those found far from the limit
  /// by 1e-5.
  static constexpr double believable_overlap = 1e-3;
  /// How far along a mechanism the theorem is asked again, as shares of the size of the structure: as far as
  /// displacements are small, and an order of magnitude on.
  static constexpr double shares_along[] = {small_displacements, 10 * small_displacements};
};

}  // namespace voussoir
