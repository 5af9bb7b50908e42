// When the static theorem is asked of a load step (static_theorem.hpp): where that costs no more than the step itself.
#pragma once

namespace voussoir {

struct StaticTheoremParameters {
  /// Load steps that stand take no more linear solves than this but for the hardest (the first step of a bridge takes
  /// 33); those that fall may take thousands.
  static constexpr int solves_before_asking = 40;
  /// The simplex method takes some twenty pivots a stone, and each costs in proportion to the stones: so many take ten
  /// seconds. More are asked of the theorem where a scene or a user asks.
  static constexpr int most_stones = 1200;
  /// A quarter of the stones takes a sixteenth of the time: no more than the stage itself.
  static constexpr int most_stones_at_ends = most_stones / 4;
  /// In space a stone has twice the rows and, of its joints, some twenty times the columns: a hundred stones take
  /// some five seconds, so many a minute, as do as many linear solves there as are awaited.
  static constexpr int most_stones_in_space = most_stones / 4;
  /// An eighth of the stones takes a sixtieth of the time: a second.
  static constexpr int most_stones_at_ends_in_space = most_stones_in_space / 8;
  /// Of so few, asking costs less than half as many solves, and those that have been followed to where they turned to
  /// take few where they stand.
  static constexpr int solves_before_asking_few = solves_before_asking / 2;
  /// Of the way from the loads before, what is none: what the theorem answers is exact to 1e-7.
  static constexpr double nothing_borne = 1e-6;
};

}  // namespace voussoir
