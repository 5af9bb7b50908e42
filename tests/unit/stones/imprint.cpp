// Facets cut by joints: stones have the same cells where they touch, and stay closed.
#include "stones/imprint.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

Imprint cut(const std::vector<StoneSurface>& stones, double tolerance, double weld) {
  const auto faceted = facets_of(stones, tolerance);
  return imprinted(faceted, find_joints(faceted, tolerance), weld);
}

double shared_area(const Imprint& imprint) {
  double sum = 0;
  for (std::size_t c = 0; c < imprint.cells.size(); ++c)
    if (imprint.other[c] >= 0) sum += imprint.cells[c].area / 2;
  return sum;
}

int shared_cells(const Imprint& imprint) {
  return static_cast<int>(std::count_if(imprint.other.begin(), imprint.other.end(), [](int c) { return c >= 0; })) / 2;
}

TEUCHOS_UNIT_TEST(Imprint, BricksOfABondHaveAFaceForEachNeighbour) {
  const auto imprint = cut(running_bond(), 1e-3, 3e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(shared_cells(imprint), 5);
  TEST_FLOATING_EQUALITY(shared_area(imprint), 0.2, 1e-12);
  // 4 boxes of 6 faces; the tops of a and b and the bottom of c are halves.
  TEST_EQUALITY(imprint.cells.size(), 27u);
  // 3, 5 and 3 places along the wall at the heights 0, 0.2 and 0.4, on either face.
  TEST_EQUALITY(imprint.points.size(), 22u);
  TEST_FLOATING_EQUALITY(imprint.shortest_edge, 0.2, 1e-12);
}

TEUCHOS_UNIT_TEST(Imprint, PointsInsideFacetsAreNone) {
  auto stones = running_bond();
  const auto drawn = cut(stones, 1e-3, 3e-3);
  // The top of the first stone as four triangles about a point a millimetre beside the head joint of those above.
  const auto top = stones[0].faces.back();
  stones[0].faces.pop_back();
  stones[0].points.push_back({0.201, 0.1, 0.2});
  for (std::size_t k = 0; k < 4; ++k) stones[0].faces.push_back({top[k], top[(k + 1) % 4], 8});
  const auto triangles = cut(stones, 1e-3, 3e-3);
  TEST_ASSERT(triangles.faults.none());
  TEST_EQUALITY(triangles.points.size(), drawn.points.size());
  TEST_EQUALITY(triangles.cells.size(), drawn.cells.size());
}

TEUCHOS_UNIT_TEST(Imprint, AFaceAroundASmallerStoneHasAHole) {
  const auto imprint = cut({box("slab", {0, 0, 0}, {3, 3, 1}), box("post", {1, 1, 1}, {2, 2, 2})}, 1e-3, 3e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(shared_cells(imprint), 1);
  const auto ring =
      std::find_if(imprint.cells.begin(), imprint.cells.end(), [](const auto& c) { return !c.holes.empty(); });
  TEST_ASSERT(ring != imprint.cells.end());
  TEST_FLOATING_EQUALITY(ring->area, 8.0, 1e-12);
}

TEUCHOS_UNIT_TEST(Imprint, StonesThatAreNotConvexAreCutByTheWholeJoint) {
  const auto imprint = cut(corner(), 1e-3, 3e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(shared_cells(imprint), 4);
  TEST_FLOATING_EQUALITY(shared_area(imprint), 6.0, 1e-12);
}

TEUCHOS_UNIT_TEST(Imprint, HoldsTurnedMovedInOtherUnitsAndMeasured) {
  const std::vector<std::vector<StoneSurface>> cases{arch(9), corner(), running_bond()};
  for (const auto& stones : cases) {
    const auto here = cut(stones, 1e-3, 3e-3);
    for (const double scale : {1.0, 1e3, 1e-3}) {
      const auto there = cut(turned(stones, scale, scale * Vector<3>{20, -10, 3}), 1e-3 * scale, 3e-3 * scale);
      TEST_ASSERT(there.faults.none());
      TEST_EQUALITY(there.cells.size(), here.cells.size());
      TEST_FLOATING_EQUALITY(shared_area(there), scale * scale * shared_area(here), 1e-10);
    }
    for (const double noise : {1e-4, 5e-4, 2e-3}) {
      const auto as_measured = cut(measured(stones, noise), 4 * noise, 12 * noise);
      TEST_ASSERT(as_measured.faults.none());
      TEST_EQUALITY(shared_cells(as_measured), shared_cells(here));
      TEST_FLOATING_EQUALITY(shared_area(as_measured), shared_area(here), 20 * noise);
    }
  }
}

TEUCHOS_UNIT_TEST(Imprint, AWeldBelowTheGapIsRefusedWithWhatToDo) {
  // The joint is found, but the corners of its two sides are 1 mm apart and stay apart.
  std::vector<StoneSurface> stones{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.001, 0, 0}, {2, 1, 1})};
  const auto faceted = facets_of(stones, 2e-3);
  const auto imprint = imprinted(faceted, find_joints(faceted, 2e-3), 1e-4);
  TEST_ASSERT(!imprint.faults.none());
  const auto error = input_error([&] { refuse_faults(imprint, faceted, 2e-3, 1e-4); });
  TEST_ASSERT(holds(error, "joint tolerance = 0.002 [m] and weld = 1e-4 [m]"));
  TEST_ASSERT(holds(error, "stone \"a\""));
  const auto welded = imprinted(faceted, find_joints(faceted, 2e-3), 4e-3);
  TEST_ASSERT(welded.faults.none());
  TEST_EQUALITY(shared_cells(welded), 1);
}

// Stacks whose stones lie beside each other by about as much as points may that are one, and turned a little.
TEUCHOS_UNIT_TEST(Imprint, OffsetsOfAboutTheWeldAreCutOrClosed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-0.01, 0.01), turn(-0.005, 0.005);
  for (int drawn = 0; drawn < 60; ++drawn) {
    std::vector<StoneSurface> stones{box("base", {-0.5, -0.5, -1}, {1.5, 1.5, 0})};
    for (int k = 0; k < 3; ++k) {
      stones.push_back(box("stone " + std::to_string(k), {0, 0, double(k)}, {1, 1, k + 1.0}));
      const double x = drawn == 0 ? 0.005 * (k == 1) : offset(random), y = drawn == 0 ? x : offset(random),
                   angle = drawn == 0 ? 0 : turn(random);
      for (auto& p : stones.back().points)
        p = {std::cos(angle) * p[0] - std::sin(angle) * p[1] + x, std::sin(angle) * p[0] + std::cos(angle) * p[1] + y,
             p[2]};
    }
    const auto imprint = cut(stones, 2e-3, 6e-3);
    TEST_ASSERT(imprint.faults.none());
    TEST_COMPARE(shared_cells(imprint), >=, 3);
    TEST_COMPARE(std::abs(shared_area(imprint) - 3), <=, 0.05);
  }
}

/// Cubes of a grid, put together at random to `count` stones that fill it; none where two of a stone meet in an edge.
std::vector<StoneSurface> of_cubes(std::mt19937& random, int count, double& joints) {
  const std::array<int, 3> n{3, 3, 3};
  std::array<std::array<std::array<int, 3>, 3>, 3> stone;
  for (auto& plane : stone)
    for (auto& row : plane) row.fill(-1);
  const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  for (int k = 0, left = 27; left > 0;) {
    const int i = any(3), j = any(3), l = any(3);
    if (stone[i][j][l] >= 0) continue;
    int beside = -1;
    if (k < count) {
      beside = k++;
    } else {
      const int axis = any(3), step = 2 * any(2) - 1;
      std::array<int, 3> at{i, j, l};
      at[axis] += step;
      if (at[axis] >= 0 && at[axis] < n[axis]) beside = stone[at[0]][at[1]][at[2]];
    }
    if (beside < 0) continue;
    stone[i][j][l] = beside;
    --left;
  }
  const std::array<std::vector<double>, 3> place{{{0, 0.7, 1.2, 2.1}, {0, 0.45, 1.3, 1.9}, {0, 0.6, 1.5, 2.2}}};
  std::vector<StoneSurface> stones(static_cast<std::size_t>(count));
  std::vector<std::map<std::array<int, 3>, int>> number(stones.size());
  joints = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int l = 0; l < 3; ++l)
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> next{i, j, l}, low{i, j, l};
            next[axis] += 2 * side - 1;
            low[axis] += side;
            const bool outside = next[axis] < 0 || next[axis] > 2;
            const int mine = stone[i][j][l];
            if (!outside && stone[next[0]][next[1]][next[2]] == mine) continue;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            std::vector<int> face;
            for (const auto& [du, dv] : std::array<std::array<int, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
              auto at = low;
              at[u] += du;
              at[v] += dv;
              auto& points = stones[mine].points;
              const auto [known, is_new] = number[mine].emplace(at, static_cast<int>(points.size()));
              if (is_new) points.push_back({place[0][at[0]], place[1][at[1]], place[2][at[2]]});
              face.push_back(known->second);
            }
            if (side == 0) std::reverse(face.begin(), face.end());
            stones[mine].faces.push_back(face);
            if (!outside)
              joints += (place[u][low[u] + 1] - place[u][low[u]]) * (place[v][low[v] + 1] - place[v][low[v]]) / 2;
          }
  for (std::size_t k = 0; k < stones.size(); ++k) stones[k].name = std::to_string(k);
  const bool fit = std::all_of(stones.begin(), stones.end(), [](const auto& s) { return open_edges(s).none(); });
  return fit ? stones : std::vector<StoneSurface>{};
}

// Stones of many corners on straight edges, and joints of many pieces: each is cut as it is drawn, and no face is a
// joint by welding alone. Turned and written in six digits, so that corners of pieces lie beside each other.
TEUCHOS_UNIT_TEST(Imprint, WhateverStonesFillABoxTheirJointsAreAllTheyShare) {
  std::mt19937 random(1);
  for (int drawn = 0; drawn < 60;) {
    double area = 0;
    auto stones = of_cubes(random, 2 + drawn % 6, area);
    if (stones.empty()) continue;
    ++drawn;
    if (drawn % 2 == 0) stones = turned(stones, 1, {});
    for (auto& stone : stones)
      for (auto& x : stone.points)
        for (double& c : x) c = std::round(1e6 * c) / 1e6;
    auto imprint = cut(stones, 2e-3, 6e-3);
    TEST_ASSERT(imprint.faults.none());
    TEST_FLOATING_EQUALITY(shared_area(imprint), area, 1e-5);
    TEST_EQUALITY(welded_joints(imprint, facets_of(stones, 2e-3), 1000).size(), 0u);
  }
}

// A plane face of many cells is as good as one: its points inside and on straight edges are none.
TEUCHOS_UNIT_TEST(Imprint, PointsOnStraightEdgesAreNone) {
  const auto of_cells = [](int n) {
    StoneSurface stone;
    stone.name = "of cells";
    std::map<std::array<int, 3>, int> number;
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, n})
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            std::vector<int> face;
            for (const auto& [di, dj] : std::array<std::array<int, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
              std::array<int, 3> at{};
              at[axis] = side;
              at[(axis + 1) % 3] = i + di;
              at[(axis + 2) % 3] = j + dj;
              const auto [known, is_new] = number.emplace(at, static_cast<int>(stone.points.size()));
              if (is_new) stone.points.push_back({at[0] / double(n), at[1] / double(n), at[2] / double(n)});
              face.push_back(known->second);
            }
            if (side == 0) std::reverse(face.begin(), face.end());
            stone.faces.push_back(face);
          }
    return stone;
  };
  const auto imprint = cut({of_cells(8), box("above", {0.25, 0, 1}, {1.25, 1, 2})}, 2e-3, 6e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(imprint.points.size(), 16u);
  TEST_FLOATING_EQUALITY(imprint.shortest_edge, 0.25, 1e-12);
  // A rim that no other edge meets keeps its corners.
  std::vector<Vector<2>> round;
  for (int k = 0; k < 24; ++k)
    round.push_back({std::cos(k * std::acos(-1.0) / 12), std::sin(k * std::acos(-1.0) / 12)});
  TEST_EQUALITY(cut({prism("drum", round, 0, 1)}, 2e-3, 6e-3).points.size(), 48u);
}

}  // namespace
