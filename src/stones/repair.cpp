#include "stones/repair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/facets.hpp"
#include "stones/solid.hpp"
#include "stones/welded_points.hpp"

namespace voussoir {
namespace {

/// A face at an edge, and whether it runs from the lower point to the higher one.
struct Use {
  int face;
  bool upward;
};

std::map<std::pair<int, int>, std::vector<Use>> uses_of_edges(const StoneSurface& stone) {
  std::map<std::pair<int, int>, std::vector<Use>> uses;
  for (std::size_t f = 0; f < stone.faces.size(); ++f) {
    const auto& face = stone.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      uses[std::minmax(a, b)].push_back({static_cast<int>(f), a < b});
    }
  }
  return uses;
}

/// Per face the shell it belongs to: an ascending number.
std::vector<int> shell_of_face(const StoneSurface& stone) {
  DisjointSets sets(stone.faces.size());
  for (const auto& [edge, uses] : uses_of_edges(stone))
    for (const Use& use : uses) sets.unite(use.face, uses[0].face);
  std::map<int, int> number;
  std::vector<int> shell;
  for (std::size_t f = 0; f < stone.faces.size(); ++f)
    shell.push_back(number.emplace(sets.root(static_cast<int>(f)), static_cast<int>(number.size())).first->second);
  return shell;
}

/// Where one of the closed surfaces of a stone lies in another, as that of a cavity does; "" where none does.
std::string cavity_of(const StoneSurface& stone, const std::vector<StoneSurface>& shells) {
  std::vector<Box<3>> boxes;
  for (const auto& shell : shells) boxes.push_back(box_of(shell.points));
  const Solids solids(shells);
  for (std::size_t outer = 0; outer < shells.size(); ++outer)
    for (std::size_t inner = 0; inner < shells.size(); ++inner) {
      bool within = inner != outer;
      for (int i = 0; i < 3; ++i)
        within = within && boxes[outer].low[i] < boxes[inner].low[i] && boxes[inner].high[i] < boxes[outer].high[i];
      const auto& place = shells[inner].points[0];
      if (within && solids[outer].depth(place) > same_point * extent(stone.points))
        return "has a closed surface within another, at " + place_in_words(place) +
               ": of a cavity, or of a stone in a stone. A hollow stone has to be cut into parts without cavity, or "
               "given as a volume of gmsh";
    }
  return "";
}

/// What is wrong with a mended stone, or nothing.
std::string fault_of(const StoneSurface& stone) {
  if (stone.faces.empty()) return "has no face with an area";
  const auto edges = open_edges(stone);
  if (edges.crowded > 0)
    return "has " + counted(edges.crowded, "edge") + " of more than two faces, one at " + place_in_words(edges.place) +
           ": two stones in one group, or an inner face left over";
  if (edges.open > 0)
    return "is not closed: " + counted(edges.open, "edge") + " of one face only, one at " +
           place_in_words(edges.place) +
           ": a face is missing, or neighbouring faces do not share their corners (give mesh > stones > weld where "
           "these "
           "are only nearly in one place)";
  const double size = extent(stone.points);
  // A sheet folded onto itself has the volume of its round-off.
  if (!(volume(stone) > 1e-9 * size * size * size)) return "holds no volume";
  return "";
}

void tell(Warnings& warnings, const StoneSurface& stone, const Repair& repair) {
  const auto add = [&](const std::string& what, int number, const std::string& text) {
    if (number > 0) add_warning(warnings, {what, stone.name, "", double(number), in_words(stone) + " " + text});
  };
  add("faces_doubled", repair.doubled, "has " + counted(repair.doubled, "face") + " twice; each counts once");
  add("faces_turned", repair.turned,
      "has " + counted(repair.turned, "face") +
          " turned outward that looked inward: look whether the stone is as meant");
  add("faces_curved", stone.curved,
      "has " + counted(stone.curved, "curved face") +
          ", here in chords: joints between such faces are found where these are alike on both sides");
  add("faces_without_area", repair.no_area, "has " + counted(repair.no_area, "face") + " without area, left out");
}

}  // namespace

Repair weld(StoneSurface& stone, double within) {
  Repair repair;
  const double size = extent(stone.points);
  if (!(size > 0)) {
    repair.no_area = static_cast<int>(stone.faces.size());
    stone.faces.clear();
    return repair;
  }
  WeldedPoints<3> welded(std::max(within, same_point * size));
  std::vector<int> number;
  for (const auto& x : stone.points) number.push_back(welded.add(x));
  repair.welded = static_cast<int>(stone.points.size() - welded.points().size());
  stone.points = welded.points();
  std::set<std::vector<int>> known;
  std::vector<std::vector<int>> kept;
  std::vector<int> part;
  for (std::size_t f = 0; f < stone.faces.size(); ++f) {
    const auto& face = stone.faces[f];
    std::vector<int> points;
    for (std::size_t k = 0; k < face.size(); ++k)
      if (number[face[k]] != number[face[(k + face.size() - 1) % face.size()]]) points.push_back(number[face[k]]);
    auto corners = points;
    sort_unique(corners);
    if (corners.size() < 3)
      ++repair.no_area;
    else if (!known.insert(corners).second)
      ++repair.doubled;
    else {
      kept.push_back(std::move(points));
      if (!stone.part.empty()) part.push_back(stone.part[f]);
    }
  }
  stone.faces = std::move(kept);
  stone.part = std::move(part);
  return repair;
}

OpenEdges open_edges(const StoneSurface& stone) {
  OpenEdges edges;
  for (const auto& [edge, uses] : uses_of_edges(stone)) {
    if (uses.size() == 2) continue;
    ++(uses.size() < 2 ? edges.open : edges.crowded);
    if (uses.size() < 2 && edges.crowded > 0) continue;
    edges.place = 0.5 * (stone.points[edge.first] + stone.points[edge.second]);
  }
  return edges;
}

int turn_outward(StoneSurface& stone) {
  struct FaceBeside {
    int face;
    bool against;
  };
  std::vector<std::vector<FaceBeside>> neighbours(stone.faces.size());
  for (const auto& [edge, uses] : uses_of_edges(stone)) {
    if (uses.size() != 2) continue;
    const bool against = uses[0].upward == uses[1].upward;
    neighbours[uses[0].face].push_back({uses[1].face, against});
    neighbours[uses[1].face].push_back({uses[0].face, against});
  }
  enum : signed char { unknown = -1, kept, turned };
  std::vector<signed char> state(stone.faces.size(), unknown);
  int count = 0;
  for (std::size_t first = 0; first < state.size(); ++first) {
    if (state[first] != unknown) continue;
    state[first] = kept;
    std::vector<int> shell{static_cast<int>(first)};
    for (std::size_t k = 0; k < shell.size(); ++k)
      for (const FaceBeside& n : neighbours[shell[k]]) {
        if (state[n.face] != unknown) continue;
        state[n.face] = n.against == (state[shell[k]] == turned) ? kept : turned;
        shell.push_back(n.face);
      }
    StoneSurface alone;
    alone.points = stone.points;
    for (const int f : shell) {
      if (state[f] == turned) std::reverse(stone.faces[f].begin(), stone.faces[f].end());
      alone.faces.push_back(stone.faces[f]);
    }
    const auto of_shell =
        static_cast<int>(std::count_if(shell.begin(), shell.end(), [&](int f) { return state[f] == turned; }));
    const bool inside_out = volume(alone) < 0;
    if (inside_out)
      for (const int f : shell) std::reverse(stone.faces[f].begin(), stone.faces[f].end());
    count += inside_out ? static_cast<int>(shell.size()) - of_shell : of_shell;
  }
  return count;
}

std::vector<StoneSurface> shells_of(const StoneSurface& stone) {
  const auto shell = shell_of_face(stone);
  const int count = shell.empty() ? 0 : *std::max_element(shell.begin(), shell.end()) + 1;
  if (count < 2) return {stone};
  std::vector<StoneSurface> shells;
  for (int s = 0; s < count; ++s) {
    StoneSurface part = stone;
    part.name += " part " + std::to_string(s + 1);
    part.points.clear();
    part.faces.clear();
    part.part.clear();
    std::map<int, int> number;
    for (std::size_t f = 0; f < stone.faces.size(); ++f) {
      if (shell[f] != s) continue;
      part.faces.push_back(stone.faces[f]);
      if (!stone.part.empty()) part.part.push_back(stone.part[f]);
      for (int& point : part.faces.back()) {
        const auto [known, is_new] = number.emplace(point, static_cast<int>(part.points.size()));
        if (is_new) part.points.push_back(stone.points[point]);
        point = known->second;
      }
    }
    shells.push_back(std::move(part));
  }
  return shells;
}

ClosedStones closed(const std::vector<StoneSurface>& drawn, double within) {
  ClosedStones result;
  std::vector<std::string> faults;
  for (StoneSurface stone : drawn) {
    Repair repair = weld(stone);
    if (within > 0 && !open_edges(stone).none()) repair = weld(stone, within);
    repair.turned = turn_outward(stone);
    const auto shells = shells_of(stone);
    std::string fault;
    for (const auto& shell : shells)
      if (fault.empty()) fault = fault_of(shell);
    if (fault.empty()) fault = cavity_of(stone, shells);
    if (!fault.empty() || stone.faces.empty()) {
      faults.push_back(in_words(stone) + " " + fault);
      continue;
    }
    tell(result.warnings, stone, repair);
    if (shells.size() > 1)
      add_warning(result.warnings,
                  {"stones_in_one_group", stone.name, "", double(shells.size()),
                   in_words(stone) + " is " + counted(shells.size(), "closed surface") + " apart; each is a stone"});
    for (const auto& shell : shells) {
      result.stones.push_back(shell);
      result.repairs.push_back(repair);
    }
  }
  if (faults.empty()) return result;
  std::string message = "mesh > stones: " + std::to_string(faults.size()) + " of " + counted(drawn.size(), "stone") +
                        " cannot be meshed:";
  for (std::size_t k = 0; k < std::min<std::size_t>(faults.size(), 5); ++k) message += "\n    " + faults[k];
  throw InputError(message + "\n  Mend them in the program that drew them: every stone is one closed surface.");
}

}  // namespace voussoir
