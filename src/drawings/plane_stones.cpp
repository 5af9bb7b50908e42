#include "drawings/plane_stones.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/file_ending.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/drawing_files.hpp"
#include "drawings/snap_choice.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

using Kind = SnapFault::Kind;

/// What a file says of its unit and what a scene says differ when they are farther apart than this.
constexpr double same_unit = 1e-6;

/// Corners that were drawn as one are this near, over the tolerance, whatever arithmetic made of them.
constexpr double round_off = 1e-6;

std::string metres(double length) { return three_digits(length) + " m"; }

/// Lengths in metres and y up; a drawing whose y runs down is seen as it is on paper.
void place(std::vector<OutlinedStone>& stones, const StonesParameters& p) {
  const bool down = p.up == UpAxis::minus_y || (p.up == UpAxis::usual && lower_ending(p.file) == ".svg");
  for (auto& stone : stones)
    for (auto& loop : stone.loops)
      for (auto& x : loop.corners)
        x = p.up == UpAxis::x ? Vector<2>{-p.unit * x[1], p.unit * x[0]}
                              : Vector<2>{p.unit * x[0], (down ? -p.unit : p.unit) * x[1] + 0.0};  // of -0 makes 0
}

std::string fault_text(const SnapFault& f, const std::vector<OutlinedStone>& stones) {
  const std::string one = in_words(stones[f.stone]), at = " at " + place_of_drawing(f.place);
  const std::string other = f.other < 0 ? "" : in_words(stones[f.other]);
  switch (f.kind) {
    case Kind::sliver:
      return one + " is somewhere narrower than snap" + at;
    case Kind::twice:
      return one + " is there twice, the second time as " + other;
    case Kind::overlap:
      return one + " and " + other + " lie in each other" + (f.size > 0 ? " by " + metres(f.size) : std::string()) + at;
    case Kind::gap:
      return one + " and " + other + " do not touch: " + metres(f.size) + " apart" + at;
    default:
      return one + " crosses itself" + at;
  }
}

/// What to do about faults, by their kinds.
std::string advice_for(const std::vector<SnapFault>& faults, double snap) {
  double gap = 0, overlap = 0;
  std::set<Kind> kinds;
  for (const auto& f : faults) {
    kinds.insert(f.kind);
    if (f.kind == Kind::gap) gap = std::max(gap, f.size);
    if (f.kind == Kind::overlap) overlap = std::max(overlap, f.size);
  }
  std::string advice;
  if (kinds.count(Kind::twice) > 0) advice += "\n  Delete one of the two stones that are there twice.";
  if (gap > 0)
    advice += "\n  Raise mesh > stones > snap above " + metres(gap) +
              " where these stones are meant to touch; where they are meant to stand open, give snap below a tenth of "
              "the gap.";
  if (kinds.count(Kind::overlap) > 0)
    advice += overlap > snap
                  ? "\n  Look whether a stone is misplaced; where the drawing is as rough as that, raise mesh "
                    "> stones > snap above " +
                        metres(overlap) + "."
                  : "\n  Look whether a stone is misplaced, or correct the drawing there.";
  if (kinds.count(Kind::sliver) > 0)
    advice += "\n  Lower mesh > stones > snap (" + metres(snap) +
              ") below the narrowest part of a stone, or leave such stones out.";
  if (kinds.count(Kind::crossing) > 0) advice += "\n  Lower mesh > stones > snap, or correct the drawing there.";
  return advice;
}

/// A tolerance at which all fits, where one was given that does not.
std::string advice_of(const std::vector<SnapCount>& counts) {
  const double fits = snap_on_plateau(counts);
  for (const auto& c : counts)
    if (c.snap == fits && c.faults == 0)
      return "\n  With snap = " + metres(fits) + " the drawing fits with " + counted(c.joints, "joint") +
             "; leave snap out to have it chosen so.";
  return "";
}

void refuse_faults(const PlaneStones& s, const std::string& file, const std::vector<SnapCount>& counts) {
  const auto& faults = s.snapped.faults;
  if (faults.empty()) return;
  std::string message = "mesh > stones > file = " + file + "\n  " + counted(faults.size(), "place") +
                        " where stones do not fit together, with snap = " + metres(s.snap) + ":";
  for (std::size_t k = 0; k < std::min<std::size_t>(faults.size(), 5); ++k)
    message += "\n    " + fault_text(faults[k], s.stones);
  throw InputError(message + advice_for(faults, s.snap) + advice_of(counts));
}

/// Names are those of sets: one stone has each, and no layer of other stones.
void check_names(const std::string& file, const std::vector<OutlinedStone>& stones) {
  std::map<std::string, const OutlinedStone*> of_name;
  for (const auto& stone : stones)
    if (const auto [known, is_new] = of_name.emplace(stone.name, &stone); !is_new)
      refuse_stones(file, in_words(*known->second) + " and " + in_words(stone) + " have one name",
                    "Give each stone a name of its own");
  for (const auto& stone : stones)
    for (const auto& set : stone.sets) {
      if (set == "all")
        refuse_stones(file, in_words(stone) + " is in a set called \"all\", which always means every stone",
                      "Choose another name");
      const auto named = of_name.find(set);
      if (named == of_name.end()) continue;
      const auto& sets = named->second->sets;
      if (std::find(sets.begin(), sets.end(), set) == sets.end())
        refuse_stones(file, in_words(stone) + " is in the set " + in_quotes(set) + ", and another stone is called so",
                      "Give the set, or the stone, another name");
    }
  if (of_name.count("all") > 0)
    refuse_stones(file, in_words(*of_name["all"]) + " is called \"all\", which always means every stone",
                  "Choose another name");
}

class Teller {
 public:
  explicit Teller(PlaneStones& s) : s_(s) {}

  void of_stones(const DrawnFile& drawn, const StonesParameters& p) {
    double sum = 0;
    std::size_t holes = 0;
    Vector<2> low = s_.stones[0].loops[0].corners[0], high = low;
    for (const auto& stone : s_.stones) {
      holes += stone.loops.size() - 1;
      for (const auto& loop : stone.loops) {
        sum += area(loop.corners);
        for (const auto& x : loop.corners)
          for (std::size_t i = 0; i < 2; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
      }
    }
    say(counted(s_.stones.size(), "stone") + (holes > 0 ? " with " + counted(holes, "hole") : std::string()) + ", " +
        six_digits(sum) + " m2, from " + place_of_drawing(low) + " to " + place_of_drawing(high) + " m");
    if (!drawn.unused.empty()) {
      say("not used: " + list_of(drawn.unused));
      warn("drawing_not_used", static_cast<double>(drawn.unused.size()),
           "the drawing has what is no stone and was left out: " + list_of(drawn.unused, 8) +
               "; look whether stones are among it");
    }
    if (drawn.unit > 0 && std::abs(drawn.unit / p.unit - 1) > same_unit)
      warn("drawing_unit", drawn.unit,
           "the drawing says that its unit is " + six_digits(drawn.unit) +
               " m, and mesh > stones > unit = " + six_digits(p.unit) + " m is taken: look at the sizes of stones");
  }

  void of_snaps(const std::vector<SnapCount>& counts, bool given) {
    std::string line;
    for (std::size_t from = 0, to = 0; from < counts.size(); from = to) {
      const bool fits = counts[from].faults == 0;
      while (to < counts.size() && (counts[to].faults == 0) == fits &&
             (!fits || counts[to].joints == counts[from].joints))
        ++to;
      line += (line.empty() ? "" : "; ") + (fits ? std::to_string(counts[from].joints) : "does not fit") + " at " +
              (to > from + 1 ? three_digits(counts[from].snap) + " to " : "") + metres(counts[to - 1].snap);
    }
    say("joints by snap: " + line);
    say("snap = " + metres(s_.snap) + (given ? "" : ", from the middle of the widest range that fits"));
    std::set<std::size_t> others;
    for (const auto& c : counts)
      if (c.faults == 0 && c.joints > 0 && c.joints != s_.snapped.joints.size()) others.insert(c.joints);
    if (others.empty()) return;
    warn("snap", s_.snap,
         "mesh > stones > snap = " + metres(s_.snap) + " makes " + counted(s_.snapped.joints.size(), "joint") +
             ", and the drawing fits with " + std::to_string(*others.rbegin()) +
             " at another tolerance: look which is meant");
  }

  void of_moves() {
    const auto& s = s_.snapped;
    say(counted(s.joints.size(), "joint") + ", " + six_digits(s.joint_length) + " m long; " +
        counted(s.corners, "corner") + " became " + counted(s.points.size(), "point") + ", edges are split at " +
        counted(s.cuts, "corner") + " of others" +
        (s.dropped > 0 ? ", " + counted(s.dropped, "corner") + " merged with the next of the same stone"
                       : std::string()));
    if (s.farthest > round_off * s_.snap)
      say("moved by up to " + metres(s.farthest) + ", of " + in_words(s_.stones[s.moved_stone]) + " from " +
          place_of_drawing(s.moved_from));
    else
      say("nothing was moved");
    std::vector<char> joined(s_.stones.size(), 0);
    for (const auto& pair : s.joints) joined[pair[0]] = joined[pair[1]] = 1;
    std::vector<std::string> alone;
    for (std::size_t k = 0; k < joined.size(); ++k)
      if (!joined[k]) alone.push_back(stone_name(s_.stones[k]) + " at " + place_of_drawing(middle_of(s_.stones[k])));
    if (alone.empty() || s_.stones.size() == 1) return;
    say("stones without a joint: " + list_of(alone));
    warn("stones_without_joint", static_cast<double>(alone.size()),
         counted(alone.size(), "stone") + " without a joint (" + list_of(alone, 5) +
             "): raise mesh > stones > snap where they are meant to touch others");
  }

 private:
  void say(const std::string& line) { s_.report.push_back(line); }
  void warn(const std::string& what, double how_much, const std::string& text) {
    add_warning(s_.warnings, {what, "mesh > stones", "", how_much, text});
  }

  PlaneStones& s_;
};

}  // namespace

PlaneStones plane_stones_of(DrawnFile drawn, const StonesParameters& p) {
  PlaneStones s;
  s.stones = std::move(drawn.stones);
  place(s.stones, p);
  check_outlines(p.file, s.stones);
  check_names(p.file, s.stones);
  const double extent = extent_of(s.stones);
  if (p.snap > 0 && p.snap < SnapDefaults().round_off * extent)
    refuse_stones(p.file,
                  "is " + metres(extent) + " wide, and snap = " + number_text(p.snap) +
                      " m is less than the round-off of its corners",
                  "Give snap in metres, or 0");
  const auto counts = count_snaps(s.stones);
  const bool given = p.snap > 0;
  s.snap = given ? p.snap : snap_on_plateau(counts);
  s.element_size = p.element_size > 0 ? p.element_size : usual_element * median_size(s.stones);
  s.snapped = snapped(s.stones, s.snap, reach_of(s.stones, s.snap, given));
  refuse_faults(s, p.file, counts);
  Teller tell(s);
  tell.of_stones(drawn, p);
  tell.of_snaps(counts, given);
  tell.of_moves();
  return s;
}

PlaneStones plane_stones_of(const StonesParameters& p) { return plane_stones_of(read_drawing(p.file), p); }

}  // namespace voussoir
