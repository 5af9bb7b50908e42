#include "mesh/wall_openings.hpp"

#include <cmath>

#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

// Lengths of a scene are decimals of a few digits: a side that is meant to lie on a joint is off by round-off alone,
// and one that is not is off by far more than this share of a stone.
constexpr double on_a_joint = 1e-6;

std::string key_of(const std::string& name) { return "wall in space > openings > " + name; }

/// How many steps fit between 0 and a side, which must be a whole number of them.
int steps_to(const std::string& key, double side, double step, const std::string& what) {
  const double steps = side / step, whole = std::round(steps);
  if (!(std::abs(steps - whole) <= on_a_joint) || std::abs(whole) > 1e9)
    refuse_mesh(key, in_words(side) + " [m]",
                "must be a multiple of " + in_words(step) + " m, " + what + " (no stone is cut thinner).",
                "Give " + in_words(std::floor(steps) * step) + " or " + in_words(std::ceil(steps) * step) + ".");
  return static_cast<int>(whole);
}

/// Where a wall begins and ends for lintels: at corners odd courses belong to the returns.
int margin(const WallInSpaceParameters& p, int stones_of_return) {
  const int half = p.cells_along / 2;
  return stones_of_return > 0 ? 2 * half : half;
}

WallRectangle rectangle_of(const WallInSpaceParameters& p, const std::string& name, const OpeningInSpace& o) {
  const std::string key = key_of(name) + " > ";
  const double half = p.block_length / 2;
  const int cells = p.cells_along / 2;
  WallRectangle r{0, 0, 0, 0, name};
  r.from = cells * steps_to(key + "x from", o.x_from, half, "half a stone");
  r.to = cells * steps_to(key + "x to", o.x_to, half, "half a stone");
  r.below = steps_to(key + "z from", o.z_from, p.block_height, "a course");
  r.above = steps_to(key + "z to", o.z_to, p.block_height, "a course");
  if (r.from >= r.to || r.below >= r.above)
    refuse_mesh(key + "x from", in_words(o.x_from) + " [m]", "makes an opening without area.",
                "Give its lower left corner by \"x from\", \"z from\".");
  if (r.below < 0 || r.above > p.courses)
    refuse_mesh(key + (r.below < 0 ? "z from" : "z to"), in_words(r.below < 0 ? o.z_from : o.z_to) + " [m]",
                "is outside the wall, which reaches from 0 to " + in_words(p.courses * p.block_height) + " m.",
                "Move the opening into the wall.");
  const int columns = p.blocks_per_course * p.cells_along;
  const int least = margin(p, p.return_left), most = columns - margin(p, p.return_right);
  if (r.from < least || r.to > most)
    refuse_mesh(key + (r.from < least ? "x from" : "x to"), in_words(r.from < least ? o.x_from : o.x_to) + " [m]",
                "leaves no half stone beside the opening for its lintel to lie on: openings of this wall lie between " +
                    in_words(half * least / cells) + " and " + in_words(half * most / cells) +
                    " m (half a stone from an end, one from a return).",
                "Move the opening, or make it narrower.");
  return r;
}

bool overlap(const WallRectangle& a, const WallRectangle& b) {
  return a.from < b.to && b.from < a.to && a.below < b.above && b.below < a.above;
}

void refuse_overlaps(const std::vector<WallRectangle>& some, const std::string& what,
                     const std::vector<WallRectangle>& others, const std::string& of_others) {
  for (const auto& a : some)
    for (const auto& b : others)
      if (&a != &b && overlap(a, b))
        refuse_mesh(
            key_of(a.name), what, "meets " + of_others + " of \"" + b.name + "\".",
            "Leave a stone between two openings, or a course: each lintel lies on half a stone at either side.");
}

}  // namespace

WallOpenings openings_of(const WallInSpaceParameters& p) {
  if (!p.openings.empty() && p.cells_along % 2 != 0)
    refuse_mesh("wall in space > cells along", std::to_string(p.cells_along) + " [-]",
                "must be even in a wall with openings (stones beside them may be half as long).",
                "Give " + std::to_string(p.cells_along + 1) + ".");
  WallOpenings all;
  for (const auto& [name, opening] : p.openings) {
    const WallRectangle r = rectangle_of(p, name, opening);
    all.free.push_back(r);
    const int half = p.cells_along / 2;
    if (r.above < p.courses) all.lintels.push_back({r.from - half, r.to + half, r.above, r.above + 1, name});
  }
  refuse_overlaps(all.free, "an opening that", all.free, "the opening");
  refuse_overlaps(all.free, "an opening that", all.lintels, "the lintel");
  refuse_overlaps(all.lintels, "an opening whose lintel", all.lintels, "the lintel");
  return all;
}

}  // namespace voussoir
