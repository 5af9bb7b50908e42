#include "stones/stone_structure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/cell_count.hpp"
#include "stones/overlaps.hpp"
#include "stones/repair.hpp"
#include "stones/solid.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

constexpr StoneDefaults defaults;

// [-] of the joint tolerance: shallower overlaps are those of numbers in files. The least of the tolerances that joints
// are counted at (count_joints).
constexpr double least_told = 0.01;

// [-] of a stone: less than unit weights of stone are known to.
constexpr double told_volume = 0.02;

std::string metres(double length) { return six_digits(length) + " m"; }

/// Axes of the file in their order from the one that becomes x; even permutations mirror nothing.
std::array<int, 3> axes_of(UpAxis up) {
  if (up == UpAxis::x) return {1, 2, 0};
  if (up == UpAxis::y) return {2, 0, 1};
  return {0, 1, 2};
}

double median_size(const std::vector<StoneSurface>& stones) {
  std::vector<double> sizes;
  for (const auto& stone : stones) sizes.push_back(std::cbrt(volume(stone)));
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  return sizes[sizes.size() / 2];
}

/// Tells what was found, in lines for the one who looks and in warnings for what may be wrong.
class Teller {
 public:
  explicit Teller(StoneStructure& s) : s_(s), solids_(s.stones) {}

  void of_stones(const std::vector<Repair>& repairs) {
    Repair sum;
    for (const auto& r : repairs)
      sum.welded += r.welded, sum.doubled += r.doubled, sum.turned += r.turned, sum.no_area += r.no_area;
    double inside = 0, farthest = 0;
    int warped = 0;
    Box<3> box = s_.faceted[0].box;
    for (const auto& stone : s_.stones) inside += volume(stone);
    for (const auto& stone : s_.faceted) {
      box.add(stone.box);
      warped += stone.warped;
      farthest = std::max(farthest, stone.farthest);
    }
    const auto size = box.high - box.low;
    say(counted(s_.stones.size(), "stone") + ", " + six_digits(inside) + " m3, within " + six_digits(size[0]) + " x " +
        six_digits(size[1]) + " x " + six_digits(size[2]) + " m");
    say("mended: " + counted(sum.welded, "point") + " on others, " + counted(sum.doubled, "face") + " twice, " +
        counted(sum.turned, "face") + " turned, " + counted(sum.no_area, "face") + " without area");
    if (warped == 0) return;
    say(counted(warped, "face is not plane", "faces are not plane") + ", up to " + metres(farthest) +
        "; cut into triangles");
    warn("faces_not_plane", farthest,
         counted(warped, "face is", "faces are") + " up to " + metres(farthest) +
             " from plane: cuts are by shortest diagonals, which decides the shape of these stones");
  }

  void of_tolerances() {
    const auto counts = count_joints(s_.stones, s_.tolerance);
    std::string line;
    for (std::size_t from = 0, to = 0; from < counts.size(); from = to) {
      while (to < counts.size() && counts[to].joints == counts[from].joints) ++to;
      line += (line.empty() ? "" : "; ") + std::to_string(counts[from].joints) + " at " +
              (to > from + 1 ? six_digits(counts[from].tolerance) + " to " : "") + metres(counts[to - 1].tolerance);
    }
    say("joints by tolerance: " + line);
    const double proposed = tolerance_on_plateau(counts);
    const int found = static_cast<int>(s_.joints.joints.size()) - number_welded();
    const auto at = [&](double tolerance) {
      return std::min_element(counts.begin(), counts.end(), [&](const auto& a, const auto& b) {
        return std::abs(std::log(a.tolerance / tolerance)) < std::abs(std::log(b.tolerance / tolerance));
      });
    };
    if (proposed == 0 || at(proposed)->joints == found) return;
    warn("joint_tolerance", proposed,
         "mesh > stones > joint tolerance = " + metres(s_.tolerance) + " finds " + counted(found, "joint") +
             ", one of " + metres(proposed) + " " + std::to_string(at(proposed)->joints) +
             ", the number that stays the same over the widest range: look which is meant");
  }

  void of_joints() {
    std::set<std::array<int, 2>> pairs;
    double farthest = 0;
    for (const auto& joint : s_.joints.joints) {
      pairs.insert(joint.stone);
      farthest = std::max(farthest, joint.farthest);
    }
    say(counted(s_.joints.joints.size(), "joint") + " of " + counted(pairs.size(), "pair") + " of stones, " +
        six_digits(s_.joints.area()) + " m2, faces up to " + metres(farthest) + " apart; " +
        counted(s_.joints.slivers, "sliver") + " narrower than the tolerance left out, " +
        six_digits(s_.joints.sliver_area) + " m2");
    of_welded_joints();
    of_welded_corners();
    of_overlaps();
    const double size = s_.tetrahedron_size;
    say("shortest edge " + metres(s_.imprint.shortest_edge) + ", tetrahedra of " + metres(size) + ", hexahedra of " +
        metres(s_.hexahedron_size));
    if (s_.imprint.shortest_edge < 0.1 * size)
      warn("short_edges", s_.imprint.shortest_edge,
           "cut by their joints, faces have edges down to " + metres(s_.imprint.shortest_edge) +
               " where cells are of " + metres(size) + ": cells there are flat; a larger weld makes such corners one");
    of_neighbours(pairs);
  }

  /// Stones that were measured, or drawn with round numbers, lie in each other by less than the tolerance: which most.
  void of_overlaps() {
    const auto& joints = s_.joints.joints;
    const auto most = std::min_element(joints.begin(), joints.end(),
                                       [](const auto& a, const auto& b) { return a.opening < b.opening; });
    const auto lies_in = [&](const auto& joint) { return joint.opening < -least_told * s_.tolerance; };
    if (most == joints.end() || !lies_in(*most)) return;
    say(counted(std::count_if(joints.begin(), joints.end(), lies_in), "joint") + " of stones that lie in each other, " +
        in_words(s_.stones[most->stone[0]]) + " and " + in_words(s_.stones[most->stone[1]]) + " most, by " +
        metres(-most->opening) + " on the mean");
  }

  /// Facets that face each other just beyond the tolerance: joints whose mortar was not drawn.
  void of_open_joints() {
    const auto near = find_joints(s_.faceted, s_.tolerance, defaults.reach * s_.tolerance);
    std::set<std::array<std::array<int, 2>, 2>> welded;
    for (const auto& joint : s_.joints.joints)
      if (joint.welded) welded.insert({joint.stone, joint.facet});
    std::size_t open = 0;
    double widest = 0, area = 0;
    for (const auto& joint : near.joints) {
      if (joint.farthest <= s_.tolerance || joint.opening <= 0 || welded.count({joint.stone, joint.facet}) > 0)
        continue;
      if (is_between(joint)) continue;
      ++open;
      widest = std::max(widest, joint.opening);
      area += joint.area;
    }
    if (open == 0) return;
    const std::string found = counted(open, "pair") + " of faces, " + six_digits(area) +
                              " m2, facing each other open by up to " + metres(widest);
    say(found);
    warn(
        "open_joints", widest,
        found + ": stones do not touch there; where mortar was left out of the drawing raise joint tolerance above it");
  }

 private:
  /// Whether another stone lies between the faces of a joint that is open.
  bool is_between(const StoneJoint& joint) const {
    Places corners;
    for (const auto& piece : joint.pieces) corners.insert(corners.end(), piece.begin(), piece.end());
    const auto middle = mean(corners);
    for (int k = 0; k < static_cast<int>(s_.stones.size()); ++k)
      if (k != joint.stone[0] && k != joint.stone[1] && s_.faceted[k].box.overlaps({middle, middle}) &&
          solids_[static_cast<std::size_t>(k)].depth(middle) > -s_.tolerance)
        return true;
    return false;
  }

  int number_welded() const {
    const auto& joints = s_.joints.joints;
    return static_cast<int>(std::count_if(joints.begin(), joints.end(), [](const auto& j) { return j.welded; }));
  }

  /// What making corners one has done to stones.
  void of_welded_corners() {
    double farthest = 0, before = 0, after = 0, most = 0;
    int stone = -1;
    for (std::size_t k = 0; k < s_.stones.size(); ++k) {
      auto moved = s_.stones[k];
      for (std::size_t n = 0; n < moved.points.size(); ++n) {
        const int point = s_.imprint.number[k][n];
        if (point < 0) continue;
        farthest = std::max(farthest, norm(s_.imprint.points[point] - moved.points[n]));
        moved.points[n] = s_.imprint.points[point];
      }
      const double drawn = volume(s_.stones[k]), has = volume(moved);
      before += drawn;
      after += has;
      if (std::abs(has - drawn) > most * drawn) most = std::abs(has - drawn) / drawn, stone = static_cast<int>(k);
    }
    if (farthest <= least_told * s_.tolerance) return;
    say("corners made one have moved by up to " + metres(farthest) + ", volumes from " + six_digits(before) + " to " +
        six_digits(after) + " m3");
    if (most > told_volume)
      warn("welded_volumes", most,
           "weld = " + metres(s_.weld) + " makes corners one that are up to " + metres(farthest) +
               " apart, and the volume of " + in_words(s_.stones[stone]) + " another by " + six_digits(100 * most) +
               " %: give a smaller weld, or draw stones that touch with the same corners");
  }

  /// What is open wider than joints are, and closed by making corners one.
  void of_welded_joints() {
    double widest = 0;
    for (const auto& joint : s_.joints.joints)
      if (joint.welded) widest = std::max(widest, joint.farthest);
    const int welded = number_welded();
    if (welded == 0) return;
    const std::string found = counted(welded, "joint") + " of faces up to " + metres(widest) +
                              " apart, more than joint tolerance = " + metres(s_.tolerance);
    say(found + ", closed by welding");
    warn("welded_joints", widest,
         found + ": they touch because weld = " + metres(s_.weld) +
             " makes their corners one; raise joint tolerance where stones are meant to touch there, else give a weld "
             "below their distance");
  }

  void of_neighbours(const std::set<std::array<int, 2>>& pairs) {
    std::vector<int> neighbours(s_.stones.size(), 0);
    for (const auto& pair : pairs) ++neighbours[pair[0]], ++neighbours[pair[1]];
    std::vector<std::string> alone, single;
    std::vector<int> without;
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      if (neighbours[k] == 0) alone.push_back(s_.stones[k].name), without.push_back(static_cast<int>(k));
      if (neighbours[k] == 1) single.push_back(s_.stones[k].name);
    }
    say("stones with one neighbour: " + list_of(single));
    if (alone.empty() || s_.stones.size() == 1) return;
    say("stones without a joint: " + list_of(alone));
    const double nearest = distance_to_others(without[0]);
    warn("stones_without_joint", static_cast<double>(alone.size()),
         counted(alone.size(), "stone shares", "stones share") + " no joint with another (" + list_of(alone, 5) +
             "), " + alone[0] +
             (nearest > s_.tolerance
                  ? " is " + metres(nearest) +
                        " from the next: raise mesh > stones > joint tolerance where they are meant to touch"
                  : " touches the next in no face, but at an edge, a corner or a sliver that was left out: draw where "
                    "they are meant to touch"));
  }

  /// [m] from a stone to the nearest of those whose boxes may be nearer than the nearest so far.
  double distance_to_others(int stone) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double least = infinity;
    for (int k = 0; k < static_cast<int>(s_.stones.size()); ++k) {
      const auto &a = s_.faceted[stone].box, &b = s_.faceted[k].box;
      Vector<3> apart{};
      for (int i = 0; i < 3; ++i) apart[i] = std::max({0.0, a.low[i] - b.high[i], b.low[i] - a.high[i]});
      if (k != stone && norm(apart) < least) least = std::min(least, solids_[stone].distance(solids_[k], infinity));
    }
    return least;
  }

  void say(const std::string& line) { s_.report.push_back(line); }
  void warn(const std::string& what, double how_much, const std::string& text) {
    add_warning(s_.warnings, {what, "mesh > stones", "", how_much, text});
  }

  StoneStructure& s_;
  Solids solids_;
};

}  // namespace

void refuse_overlaps(const std::vector<StoneSurface>& stones, double tolerance) {
  auto found = overlaps(stones, tolerance);
  if (found.empty()) return;
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
  std::string message = "mesh > stones: " + counted(found.size(), "pair of stones lies", "pairs of stones lie") +
                        " in each other by more than the joint tolerance of " + metres(tolerance) + ":";
  for (std::size_t k = 0; k < std::min<std::size_t>(found.size(), 5); ++k) {
    const auto& [pair, depth, place, of_chords] = found[k];
    message += "\n    " + in_words(stones[pair[0]]) + " and " + in_words(stones[pair[1]]) + " by " + metres(depth) +
               " or more at " + place_in_words(place);
    if (depth <= of_chords) message += ", as chords of round faces do that have other corners on either side";
  }
  message +=
      "\n  Look whether a stone is there twice or misplaced; where stones were measured so, raise joint tolerance "
      "above the overlap.";
  if (std::any_of(found.begin(), found.end(), [](const auto& o) { return o.depth <= o.of_chords; }))
    message +=
        "\n  Draw round faces that touch with the same chords, corner on corner; a larger joint tolerance finds only "
        "those chords of both that face each other within 5 degrees.";
  throw InputError(message);
}

double tolerance_of(const std::vector<StoneSurface>& stones, const StonesParameters& p) {
  return p.joint_tolerance > 0 ? p.joint_tolerance : defaults.tolerance * median_size(stones);
}

void turn_up(UpAxis up, Places& places) {
  const auto axes = axes_of(up);
  for (auto& x : places) x = {x[axes[0]], x[axes[1]], x[axes[2]]};
}

/// Before the first cell is made. Of tetrahedra of an edge there are more than of cubes of that edge.
void refuse_too_many_cells(const StoneStructure& s, const StonesParameters& p) {
  double whole = 0;
  for (const auto& stone : s.stones) whole += volume(stone);
  const auto why = too_many_cells(whole / std::pow(std::min(s.hexahedron_size, s.tetrahedron_size), 3));
  if (why.empty()) return;
  throw InputError("mesh > stones > element size = " + metres(p.element_size) + "\n  " + why + ": the stones have " +
                   six_digits(whole) +
                   " m3.\n  Give a larger element size, and mesh > stones > unit where the file is "
                   "drawn in another than metres; 0 lets the program choose.");
}

StoneStructure structure_of(const std::vector<StoneSurface>& drawn, const StonesParameters& p) {
  StoneStructure s;
  auto mended = closed(drawn, p.weld);
  s.stones = std::move(mended.stones);
  s.warnings = std::move(mended.warnings);
  const double size = median_size(s.stones);
  s.tolerance = tolerance_of(s.stones, p);
  s.weld = p.weld > 0 ? p.weld : defaults.weld * s.tolerance;
  const bool quadratic = p.element == StoneElement::quadratic;
  s.hexahedron_size = p.element_size > 0 ? p.element_size : defaults.element_size * size;
  s.tetrahedron_size = p.element_size == 0 && quadratic ? defaults.quadratic_size * size : s.hexahedron_size;
  s.cells = p.cells;
  refuse_too_many_cells(s, p);
  refuse_overlaps(s.stones, s.tolerance);
  s.faceted = facets_of(s.stones, s.tolerance);
  s.joints = find_joints(s.faceted, s.tolerance);
  s.imprint = imprinted(s.faceted, s.joints, s.weld);
  refuse_faults(s.imprint, s.faceted, s.tolerance, s.weld);
  auto& joints = s.joints.joints;
  const auto welded = welded_joints(s.imprint, s.faceted, static_cast<int>(joints.size()));
  joints.insert(joints.end(), welded.begin(), welded.end());
  Teller tell(s);
  tell.of_stones(mended.repairs);
  tell.of_tolerances();
  tell.of_joints();
  tell.of_open_joints();
  return s;
}

/// Refuses a stone that is called as a set is that every scene knows.
void refuse_names_of_sets(const std::string& file, const std::vector<StoneSurface>& stones) {
  const bool flagged = std::any_of(stones.begin(), stones.end(), [](const auto& stone) { return stone.support; });
  for (const auto& stone : stones) {
    const std::string means = stone.name == "all"                   ? "every stone"
                              : stone.name == "one neighbour"       ? "all stones that touch one other"
                              : stone.name == "supports" && flagged ? "all that the file calls supports"
                                                                    : "";
    if (!means.empty())
      refuse_stones(file, in_words(stone) + " has a name that always means " + means, "Give it another");
  }
}

StoneStructure structure_of(const StonesParameters& p) {
  Warnings warnings;
  auto drawn = read_stones(p.file, p.unit, warnings);
  refuse_names_of_sets(p.file, drawn);
  for (auto& stone : drawn) turn_up(p.up, stone.points);
  auto structure = structure_of(drawn, p);
  for (const auto& warning : warnings) add_warning(structure.warnings, warning);
  return structure;
}

}  // namespace voussoir
