// A stone as a drawing has it: its outline and its holes, before anything is known of neighbours.
#pragma once

#include <string>
#include <vector>

#include "stones/polygon.hpp"

namespace voussoir {

/// A closed polygon, its last corner not the first one again.
struct DrawnLoop {
  Polygon corners;
  std::vector<char> curved;  ///< per corner: a point of something curved, where what is drawn does not turn
};

struct OutlinedStone {
  std::string name;                ///< of the file; `stone 7` by its number from 1 where the file has none
  std::string origin;              ///< where it is written, for messages: "wall.csv, line 17"
  std::vector<std::string> sets;   ///< layers or classes
  std::vector<DrawnLoop> loops{};  ///< the outline, then holes
};

/// What a file holds, in its own lengths and axes.
struct DrawnFile {
  std::vector<OutlinedStone> stones;
  std::vector<std::string> unused;  ///< what of the file is no stone and was left out: `12 LINE`
  double unit = 0;                  ///< [m] length that the file says it calls 1; 0 where it says nothing
};

/// The name as a block has it: "stone b7".
std::string stone_name(const OutlinedStone&);
/// Where a stone is: its centre of mass or, where that lies outside, a place far from its border.
Vector<2> middle_of(const OutlinedStone&);
/// "(1.25, 0.4)", with the digits a place in a drawing can use.
std::string place_of_drawing(const Vector<2>&);
/// `stone "b7" (wall.csv, line 17) at (1.25, 0.4)`
std::string in_words(const OutlinedStone&);

/// Loops that a file gives without saying which is a hole: one that lies in an odd number of others is a hole of the
/// smallest that holds it, every other is a stone. More than one are named "name (2)", ...
std::vector<OutlinedStone> stones_of_loops(const OutlinedStone& named, std::vector<DrawnLoop>);

/// Of what a file draws again elsewhere; more are no drawing of stones that could be computed.
constexpr int most_copies = 100000;

/// Chords of an arc turn by no more than this [rad], five degrees: then they are off by a thousandth of its radius.
constexpr double chord_turn = 0.087266462599716474;

}  // namespace voussoir
