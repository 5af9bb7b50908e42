// Walls of boxes in space, in running bond or with head joints above each other, with returns and openings.
//
// The lattice has blocks_per_course * cells_along columns along x and cells_across rows through the wall; returns go on
// with rows as wide. A course has cells_up storeys, and the ground below them has one.
#include <algorithm>
#include <set>

#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"
#include "mesh/lattice_in_space.hpp"
#include "mesh/wall_openings.hpp"

namespace voussoir {
namespace {

/// Columns of a stone of the wall, or rows of one of a return.
struct Piece {
  int from, to;
};

/// What the stones of a course are in.
struct CourseSets {
  int course, facade, left, right, lintels;  ///< indices of sets of blocks; -1 = none
};

class WallInSpace {
 public:
  explicit WallInSpace(const WallInSpaceParameters& p) : p_(p), openings_(openings_of(p)) {}
  Masonry masonry() &&;

 private:
  bool has_returns() const { return p_.return_left > 0 || p_.return_right > 0; }
  int columns() const { return p_.blocks_per_course * p_.cells_along; }
  /// Columns and rows of half a stone, which is what a wall with returns is thick.
  int half() const { return p_.cells_along / 2; }
  int half_rows() const { return p_.cells_across; }
  /// Rows of a return to its end.
  int rows(int stones) const { return 2 * half_rows() * stones; }
  bool odd(int course) const { return p_.bond == WallBond::running && course % 2 == 1; }

  template <class Names>
  int add_set(Names& sets, const std::string& name) {
    sets.push_back(name);
    return static_cast<int>(sets.size()) - 1;
  }
  int add_group(const std::string& name, std::vector<int> sets, int part = 0);
  std::set<int> joints_of_bond(int course) const;
  void add_wall(int course, int below, int above, int group, const CourseSets*);
  void add_return(bool at_left, int course, int below, int above, int group);
  void add_course(int course, const CourseSets&);
  void add_ground(int set);
  void add_sides();

  WallInSpaceParameters p_;
  WallOpenings openings_;
  Masonry m_;
};

/// Joints between stones from `begin` to `end`, with both, where one of them lies at `first`.
std::set<int> joints_between(int begin, int end, int first, int length) {
  std::set<int> joints{begin, end};
  for (int joint = first; joint < end; joint += length)
    if (joint > begin) joints.insert(joint);
  return joints;
}

std::vector<Piece> pieces(const std::set<int>& joints) {
  std::vector<Piece> all;
  for (auto it = joints.begin(); std::next(it) != joints.end(); ++it) all.push_back({*it, *std::next(it)});
  return all;
}

int WallInSpace::add_group(const std::string& name, std::vector<int> sets, int part) {
  sets.erase(std::remove(sets.begin(), sets.end(), -1), sets.end());
  std::sort(sets.begin(), sets.end());
  m_.groups.push_back({name, std::move(sets), part});
  return static_cast<int>(m_.groups.size()) - 1;
}

/// At a return odd courses begin behind its corner stone.
std::set<int> WallInSpace::joints_of_bond(int course) const {
  const int begin = odd(course) && p_.return_left > 0 ? half() : 0;
  const int end = columns() - (odd(course) && p_.return_right > 0 ? half() : 0);
  return joints_between(begin, end, odd(course) ? half() : 0, p_.cells_along);
}

/// The stones of a course along x. @param sets  those of a course with openings; none for the ground
void WallInSpace::add_wall(int course, int below, int above, int group, const CourseSets* sets) {
  std::set<int> joints = joints_of_bond(course);
  std::vector<WallRectangle> free, lintels;
  if (sets) {
    const auto here = [course](const WallRectangle& r) { return r.below <= course && course < r.above; };
    std::copy_if(openings_.free.begin(), openings_.free.end(), std::back_inserter(free), here);
    std::copy_if(openings_.lintels.begin(), openings_.lintels.end(), std::back_inserter(lintels), here);
  }
  for (const auto& lintel : lintels) joints.erase(joints.upper_bound(lintel.from), joints.lower_bound(lintel.to));
  for (const auto* rectangles : {&free, &lintels})
    for (const auto& r : *rectangles) joints.insert({r.from, r.to});
  int number = 0;
  for (const Piece& piece : pieces(joints)) {
    const auto same = [&piece](const WallRectangle& r) { return r.from <= piece.from && piece.to <= r.to; };
    if (std::any_of(free.begin(), free.end(), same)) continue;
    const auto lintel = std::find_if(lintels.begin(), lintels.end(), same);
    const int of = lintel == lintels.end()
                       ? group
                       : add_group("course " + std::to_string(course) + ", lintel of " + lintel->name,
                                   {sets->course, sets->facade, sets->lintels});
    m_.stones.push_back({{piece.from, 0, below}, {piece.to, p_.cells_across, above}, of, number++});
  }
}

void WallInSpace::add_return(bool at_left, int course, int below, int above, int group) {
  const int end = rows(at_left ? p_.return_left : p_.return_right);
  const int begin = odd(course) ? 0 : half_rows();
  const int from = at_left ? 0 : columns() - half(), to = from + half();
  int number = 0;
  for (const Piece& piece : pieces(joints_between(begin, end, begin, 2 * half_rows()))) {
    const bool back = p_.returns_to == ReturnsTo::back;
    const int low = back ? piece.from : p_.cells_across - piece.to;
    m_.stones.push_back({{from, low, below}, {to, low + piece.to - piece.from, above}, group, number++});
  }
}

void WallInSpace::add_course(int course, const CourseSets& sets) {
  const int below = course * p_.cells_up, above = below + p_.cells_up;
  const std::string name = "course " + std::to_string(course);
  add_wall(course, below, above, add_group(name, {sets.course, sets.facade}), &sets);
  if (p_.return_left > 0)
    add_return(true, course, below, above, add_group(name + ", left return", {sets.course, sets.left}));
  if (p_.return_right > 0)
    add_return(false, course, below, above, add_group(name + ", right return", {sets.course, sets.right}));
}

/// Stones as those of course 0, under openings too.
void WallInSpace::add_ground(int set) {
  const int group = add_group("ground", {set}, ground_part);
  add_wall(0, -1, 0, group, nullptr);
  if (p_.return_left > 0) add_return(true, 0, -1, 0, add_group("ground, left return", {set}, ground_part));
  if (p_.return_right > 0) add_return(false, 0, -1, 0, add_group("ground, right return", {set}, ground_part));
}

void WallInSpace::add_sides() {
  const auto side = [this](const std::string& name, int axis, bool far, int plane, bool covered = false) {
    m_.sides.push_back({add_set(m_.facet_sets, name), axis, far, plane, covered, 0});
  };
  side("base", 2, false, 0, true);
  side("top", 2, true, p_.courses * p_.cells_up);
  side("left", 0, false, 0);
  side("right", 0, true, columns());
  side("front", 1, false, 0);
  side("back", 1, true, p_.cells_across);
  if (p_.ground_height > 0) add_ground_sides(m_, "ground", ground_part);
  if (p_.return_left > 0) side("return left inside", 0, true, half());
  if (p_.return_right > 0) side("return right inside", 0, false, columns() - half());
  if (!has_returns()) return;
  const int ends = add_set(m_.facet_sets, "return ends");
  const bool back = p_.returns_to == ReturnsTo::back;
  for (const int stones : std::set<int>{p_.return_left, p_.return_right})
    if (stones > 0) m_.sides.push_back({ends, 1, back, back ? rows(stones) : p_.cells_across - rows(stones), false, 0});
}

Masonry WallInSpace::masonry() && {
  for (int course = 0; course < p_.courses; ++course) add_set(m_.block_sets, "course " + std::to_string(course));
  const auto set = [this](bool there, const char* name) { return there ? add_set(m_.block_sets, name) : -1; };
  const int ground = set(p_.ground_height > 0, "ground");
  CourseSets sets{0, set(has_returns(), "facade"), set(p_.return_left > 0, "return left"),
                  set(p_.return_right > 0, "return right"), set(!openings_.lintels.empty(), "lintels")};
  if (ground >= 0) add_ground(ground);
  for (sets.course = 0; sets.course < p_.courses; ++sets.course) add_course(sets.course, sets);
  add_sides();
  const int depth = std::max(p_.cells_across, rows(std::max(p_.return_left, p_.return_right)));
  const bool back = p_.returns_to == ReturnsTo::back;
  m_.low = {0, back ? 0 : p_.cells_across - depth, -1};
  m_.high = {columns(), back ? depth : p_.cells_across, p_.courses * p_.cells_up};
  m_.place = [p = p_](const LatticeIndex& at) {
    return Vector<3>{p.block_length * at[0] / p.cells_along, p.thickness * at[1] / p.cells_across,
                     at[2] < 0 ? -p.ground_height : p.block_height * at[2] / p.cells_up};
  };
  return std::move(m_);
}

void validate_returns(const WallInSpaceParameters& p) {
  const std::string wall = "wall in space > ";
  const std::string key = wall + (p.return_left > 0 ? "return left" : "return right");
  const std::string value = std::to_string(std::max(p.return_left, p.return_right)) + " [-]";
  if (p.bond == WallBond::stack)
    refuse_mesh(key, value, "is bonded into the wall course by course, which bond = stack has no room for.",
                "Give bond = running, or return left and return right 0.");
  // The corner stone of an odd course takes half a stone of the wall, and its bond goes on behind it. Round-off of
  // lengths that are written as decimals is below this share.
  if (!(std::abs(p.block_length - 2 * p.thickness) <= 1e-9 * p.block_length))
    refuse_mesh(wall + "thickness", in_words(p.thickness) + " [m]",
                "must be half a block, " + in_words(p.block_length / 2) +
                    " m, in a wall with returns (corner stones lie along the wall and along the return in turn).",
                "Give it, or block length " + in_words(2 * p.thickness) + ".");
  if (p.blocks_per_course < 2 && p.return_left > 0 && p.return_right > 0)
    refuse_mesh(wall + "blocks per course", std::to_string(p.blocks_per_course) + " [-]",
                "leaves no stone between the corner stones of two returns.", "Give 2 or more.");
}

void validate(const WallInSpaceParameters& p) {
  const std::string wall = "wall in space > ";
  require_at_least(wall + "courses", p.courses, 1);
  require_at_least(wall + "blocks per course", p.blocks_per_course, 1);
  require_positive(wall + "block length", p.block_length, "m");
  require_positive(wall + "block height", p.block_height, "m");
  require_positive(wall + "thickness", p.thickness, "m");
  require_at_least(wall + "cells along", p.cells_along, p.bond == WallBond::running ? 2 : 1);
  require_at_least(wall + "cells up", p.cells_up, 1);
  require_at_least(wall + "cells across", p.cells_across, 1);
  require_at_least(wall + "return left", p.return_left, 0);
  require_at_least(wall + "return right", p.return_right, 0);
  if (p.bond == WallBond::running && p.cells_along % 2 != 0)
    refuse_mesh(wall + "cells along", std::to_string(p.cells_along) + " [-]",
                "must be even in running bond (a half block has half of the cells, so that nodes of two courses meet).",
                "Give " + std::to_string(p.cells_along + 1) + ", or bond = stack.");
  if (p.ground_height != 0) require_positive(wall + "ground height", p.ground_height, "m");
  const double longest = std::max(p.return_left, p.return_right);
  const double blocks = (p.blocks_per_course + p.return_left + p.return_right + 1.0) * (p.courses + 1.0);
  require_countable(wall + "courses", p.courses, blocks,
                    std::max({p.blocks_per_course * double(p.cells_along), p.courses * double(p.cells_up),
                              2 * longest * p.cells_across,
                              (p.cells_along + 1.0) * (p.cells_up + 1.0) * (2 * p.cells_across + 1.0)}));
  if (p.return_left > 0 || p.return_right > 0) validate_returns(p);
}

}  // namespace

std::unique_ptr<BlockSource<3>> make_wall_in_space(const WallInSpaceParameters& parameters) {
  validate(parameters);
  return make_lattice_in_space(WallInSpace(parameters).masonry());
}

}  // namespace voussoir
