// How near pyramids come to the round cones of friction in space (admissible_forces.hpp), and what of limit analysis is
// told more coarsely there.
#pragma once

#include "base/order_of_magnitude.hpp"

namespace voussoir {

struct RoundConeParameters {
  static constexpr double pi = 3.14159265358979323846;
  /// Faces of the pyramid that stands for a round cone before any is added: it bears up to 2 % more than the cone
  /// across its edges, or less where it is within; twice as many cost twice the columns.
  static constexpr int sides = 16;
  /// [rad] between lines in which two faces beside each other touch the cone.
  static constexpr double side = 2 * pi / sides;
  /// Faces are added where a force lies beyond the round cone by more than this share of its friction, and lines of the
  /// cone where a motion presses into it by more than this share of its slip, until there are none: that is finer than
  /// any friction is known. Each round leaves a quarter of what the last did.
  static constexpr double off_the_cone = 1e-3;
  /// The same where it decides whether loads are borne at all, by joints or a share of them: to a thousandth of that,
  /// below which drawings tell no slope.
  static constexpr double off_the_cone_at_last = off_the_cone * off_the_cone;
  /// What a factor may be above one for which forces within the cones balance, where nothing is left to be made finer:
  /// an order of magnitude below what it is told to.
  static constexpr double nothing_left = off_the_cone / order_of_magnitude;
  /// Ends what moves between motions that are alike: rounds for each of the 25 points that a joint of a stone has with
  /// usual cells, to which forces go in turn where it is not flat, and for six of which each leaves a quarter.
  static constexpr int most_rounds = 32;
  /// To how much the share is told that forces leave of joints. Each share asked costs seconds for a hundred stones,
  /// and joints are narrowed about the mean of their corners, which is their middle only where they are regular.
  static constexpr double share_told = 1.0 / 64;
};

}  // namespace voussoir
