// To how many digits limit analysis is computed and believed (limit_analysis.hpp).
#pragma once

#include "base/order_of_magnitude.hpp"

namespace voussoir {

struct LimitAnalysisParameters {
  /// Balance and prices are exact to so much of the largest of their kind, which has size one: a stone of a millionth
  /// of the weight of the heaviest is in balance to a ten-thousandth of its own.
  static constexpr double tolerance = 1e-10;
  /// Forces are in balance to so much of the largest load, which the programme's tolerance leaves room for; and motions
  /// of a mechanism exact to so much of the largest.
  static constexpr double out_of_balance = 100 * tolerance;
  /// A motion may press into points by so much of its size; more than that proves nothing.
  static constexpr double against_the_law = out_of_balance;
  /// Forces on a stone cancel where their sum is less than so much of their sizes, which is what is lost in adding up
  /// those of some thousand nodes. Such loads, as those of heat, press on no other stone.
  static constexpr double no_resultant = 1e-12;
  /// What is no motion: ten times what it is exact to.
  static constexpr double no_motion = 10 * out_of_balance;
  /// Loads gain along a mechanism by more than this share of what they turn over: a hundred times what an equilibrium
  /// of the elastic structure may be out of balance.
  static constexpr double clear_gain = 100 * out_of_balance;
  /// Points lie on a line and have one normal to so much of the size of their stones: what places of a drawing keep.
  static constexpr double straight = 1e-9;
  /// Stones that are held, or jam between such, may press on each other as much as one likes. Forces end at so many
  /// times the largest load: their round-off is as large as the programme's tolerance there.
  static constexpr double most_force = 1e6;
  /// A reaction of more than this comes from forces at their end, so that it has none.
  static constexpr double endless_reaction = most_force / 10;
  /// Only forces of more than that hold a stone by a lever, or against another support, of so much of its size: that is
  /// what faces of a drawing are off their planes by, and the reactions told count on nothing so small.
  static constexpr double holds_nothing = 1 / endless_reaction;
  /// Friction of so much and more, two orders of magnitude beyond that of stones, counts as without end, which admits a
  /// little more: such a joint slips where the force is within 0.6 degrees of its plane, and generators of its cone
  /// could hardly be told from each other.
  static constexpr double endless_friction = order_of_magnitude * order_of_magnitude;
  /// Friction that hardly dilates: this share of Coulomb's slope is left, so that programmes keep an inside.
  static constexpr double slope_left = 1 / (order_of_magnitude * order_of_magnitude * order_of_magnitude);
  /// What the normal forces of the last programme weigh in the next, and when the sequence has settled, as in Gilbert,
  /// Casapulla and Ahmed (2006).
  static constexpr double weight_of_last = 0.6;
  static constexpr double settled = 1e-4;
  /// After so many a sequence that has not settled goes round: no answer.
  static constexpr int most_programmes = 100;
  /// Share of joints up to which forces are looked for that leave it free: a thousandth is left, to which it is told.
  static constexpr double largest_free_share = 1 - 1.0 / 1024;
};

}  // namespace voussoir
