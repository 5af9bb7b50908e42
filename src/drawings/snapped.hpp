// Stones of a drawing fitted together: corners that are nearer than a tolerance are one, edges have the corners of
// others that lie on them. What does not fit is found, stone by stone and place by place.
#pragma once

#include <string>
#include <vector>

#include "drawings/outlined_stone.hpp"

namespace voussoir {

/// Something that keeps stones from fitting together.
struct SnapFault {
  enum class Kind {
    sliver,    ///< of the stone nothing is left, or it touches itself
    twice,     ///< two stones have one outline
    overlap,   ///< two stones lie in each other
    gap,       ///< two stones are near and do not touch
    crossing,  ///< a stone crosses itself
  };
  Kind kind = Kind::sliver;
  int stone = 0, other = -1;
  Vector<2> place{};  ///< [m]
  double size = 0;    ///< [m] width or depth; 0 where it is not known
};

struct SnappedStones {
  Polygon points;                                    ///< [m] each the mean of the corners that became one
  std::vector<char> turns;                           ///< per point: the drawing may turn there, it is of no curve alone
  std::vector<std::vector<std::vector<int>>> loops;  ///< per stone: outline counter-clockwise, holes clockwise
  std::vector<std::vector<std::vector<int>>> drawn;  ///< the same without the points of others
  std::vector<std::array<int, 2>> joints;            ///< pairs of stones that share an edge, ascending
  double joint_length = 0;                           ///< [m]
  int corners = 0;                                   ///< drawn
  int dropped = 0;                                   ///< corners that became one with another of the same stone
  int cuts = 0;                                      ///< corners of others put on edges
  double farthest = 0;                               ///< [m] that a corner, or an edge at the corner of another, moved
  int moved_stone = 0;                               ///< whose corner or edge it is
  Vector<2> moved_from{};                            ///< [m]
  std::vector<SnapFault> faults;
};

/// @param stones  checked (check_outlines)
/// @param snap  [m] > 0
/// @param reach  [m] >= snap: stones that are nearer than this and share no point there have a gap
SnappedStones snapped(const std::vector<OutlinedStone>& stones, double snap, double reach);

/// [m] how deep two stones lie in each other at their corners and the middles of their edges, and the deepest place.
double depth_of_overlap(const OutlinedStone&, const OutlinedStone&, Vector<2>& place);

/// Drops points that are there twice, turns outlines counter-clockwise and holes clockwise. Throws InputError for loops
/// without area, that cross themselves, and holes outside of their stone; by stone and place.
/// @param file  for messages
void check_outlines(const std::string& file, std::vector<OutlinedStone>&);

}  // namespace voussoir
