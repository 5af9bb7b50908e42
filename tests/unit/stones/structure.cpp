// From drawn stones to all that is known before they are meshed, and what a user is told.
#include "stones/solid.hpp"
#include "stones/stone_structure.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "stones/filled_stones.hpp"
#include "stones/overlaps.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

bool warns(const StoneStructure& s, const std::string& what) {
  return std::any_of(s.warnings.begin(), s.warnings.end(), [&](const auto& w) { return w.what == what; });
}

bool tells(const StoneStructure& s, const std::string& part) {
  return std::any_of(s.report.begin(), s.report.end(), [&](const auto& line) { return holds(line, part); });
}

TEUCHOS_UNIT_TEST(Overlaps, DepthIsTheDistanceToTheSurface) {
  const auto cube = box("cube", {0, 0, 0}, {1, 1, 1});
  TEST_FLOATING_EQUALITY(Solid(cube).depth({0.5, 0.5, 0.75}), 0.25, 1e-14);
  TEST_FLOATING_EQUALITY(Solid(cube).depth({0.5, 0.5, 1.75}), -0.75, 1e-14);
  TEST_FLOATING_EQUALITY(Solid(cube).depth({2, 2, 0.5}), -std::sqrt(2.0), 1e-14);
  const auto bent = corner()[0];
  TEST_FLOATING_EQUALITY(Solid(bent).depth({0.5, 1.5, 0.5}), 0.5, 1e-14);
  TEST_FLOATING_EQUALITY(Solid(bent).depth({1.5, 1.5, 0.5}), -0.5, 1e-14);
}

TEUCHOS_UNIT_TEST(Overlaps, OfEveryKindAreFoundAndTouchingStonesHaveNone) {
  const auto cube = box("cube", {0, 0, 0}, {1, 1, 1});
  const auto depth = [&](const StoneSurface& other) {
    const auto found = overlaps({cube, other}, 1e-3);
    return found.empty() ? 0.0 : found[0].depth;
  };
  TEST_FLOATING_EQUALITY(depth(box("end face inside", {0.98, 0, 0}, {2, 1, 1})), 0.02, 1e-10);
  TEST_FLOATING_EQUALITY(depth(box("corner inside", {0.9, 0.9, 0.9}, {2, 2, 2})), 0.1, 1e-10);
  TEST_COMPARE(depth(box("through", {0.4, 0.4, -1}, {0.6, 0.6, 2})), >, 0.05);
  TEST_COMPARE(depth(box("crossing", {-1, 0.4, 0.4}, {2, 0.6, 1.6})), >, 0.1);
  TEST_COMPARE(depth(cube), >, 0.4);
  TEST_COMPARE(depth(box("within", {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3})), >, 0.1);
  TEST_EQUALITY(depth(box("beside", {1, 0, 0}, {2, 1, 1})), 0);
  TEST_EQUALITY(depth(box("half a millimetre", {0.9995, 0, 0}, {2, 1, 1})), 0);
  TEST_ASSERT(overlaps(corner(), 1e-3).empty() && overlaps(running_bond(), 1e-3).empty() &&
              overlaps(arch(9), 1e-3).empty());
}

// No corner, no edge and no middle of a face of either lies in the other, but in the planes of its faces.
TEUCHOS_UNIT_TEST(Structure, StonesThatRunThroughEachOtherAreFound) {
  const auto a = box("a", {0, 4, 0}, {10, 5, 1});
  for (const auto& b : {box("crossing", {4, 0, 0}, {5, 10, 1}), box("off the middle", {1, 0, 0}, {2, 7, 1}),
                        box("thin", {3, 0, 0}, {3.02, 10, 1})}) {
    const auto found = overlaps({a, b}, 1e-3);
    TEST_EQUALITY(found.size(), 1u);
    if (found.empty()) continue;
    TEST_COMPARE(found[0].depth, >, b.name == "thin" ? 0.01 : 0.9);
    TEST_COMPARE(found[0].depth, <=, 1.0);
  }
  // The depth of a quoin that goes far into its neighbour is told, not how far it was looked for.
  const auto quoin =
      overlaps({box("wall", {0, 0, 0}, {2, 0.4, 1}), box("quoin", {1.85, -0.1, 0}, {2.5, 0.5, 1})}, 1e-3);
  TEST_EQUALITY(quoin.size(), 1u);
  TEST_FLOATING_EQUALITY(quoin.at(0).depth, 0.15, 1e-9);
}

TEUCHOS_UNIT_TEST(Structure, DistancesAreThoseOfCrossingEdgesToo) {
  // Roofs of two prisms, one along x with its ridge up, one along y with its ridge down.
  const auto low = prism("low", {{-0.5, -1}, {0.5, -1}, {0, 0}}, -3, 3, 1, 2);
  const auto high = prism("high", {{0, 0.005}, {0.5, 1}, {-0.5, 1}}, -3, 3, 0, 2);
  TEST_FLOATING_EQUALITY(Solid(low).distance(Solid(high), 1.0), 0.005, 1e-12);
}

TEUCHOS_UNIT_TEST(Structure, OverlappingStonesAreRefusedByNameAndPlace) {
  auto stones = running_bond();
  for (auto& x : stones[2].points) x[2] -= 0.02;
  const auto error = input_error([&] { structure_of(stones, {}); });
  TEST_ASSERT(holds(error, "2 pairs of stones lie in each other"));
  TEST_ASSERT(holds(error, "stone \"a\" (drawn) and stone \"c\" (drawn) by 0.02 m"));
  stones = running_bond();
  stones.push_back(stones[1]);
  TEST_ASSERT(holds(input_error([&] { structure_of(stones, {}); }), "1 pair of stones lies in each other"));
}

TEUCHOS_UNIT_TEST(Structure, OverlapsWithinTheToleranceAreToldByPair) {
  const auto a = box("a", {0, 0, 0}, {1, 1, 1}), b = box("b", {0.9995, 0, 0}, {2, 1, 1});
  const auto c = box("c", {0, 0, 1}, {1, 1, 2}), above = box("above", {1, 0, 0.9992}, {2, 1, 2});
  const auto s = structure_of({a, b, c, above}, {});
  TEST_ASSERT(tells(s,
                    "2 joints of stones that lie in each other, stone \"b\" (drawn) and stone \"above\" (drawn)"
                    " most, by 0.0008 m"));
  TEST_ASSERT(s.warnings.empty());
  TEST_ASSERT(!tells(structure_of(arch(9), {}), "lie in each other"));
}

TEUCHOS_UNIT_TEST(Structure, ChoosesNumbersByTheSizeOfStonesAndTellsWhatItFinds) {
  const auto s = structure_of(arch(9), {});
  const double size = std::cbrt(volume(s.stones[0]));
  TEST_FLOATING_EQUALITY(s.tolerance, 2e-3 * size, 1e-12);
  TEST_FLOATING_EQUALITY(s.weld, 6e-3 * size, 1e-12);
  TEST_FLOATING_EQUALITY(s.hexahedron_size, 0.25 * size, 1e-12);
  TEST_FLOATING_EQUALITY(s.tetrahedron_size, 0.4 * size, 1e-12);
  TEST_ASSERT(tells(s, "9 stones"));
  TEST_ASSERT(tells(s, "8 joints of 8 pairs of stones, 4.8 m2"));
  TEST_ASSERT(tells(s, "one neighbour: voussoir 0, voussoir 8"));
  TEST_ASSERT(s.warnings.empty());
}

TEUCHOS_UNIT_TEST(Structure, JointsLeftOpenForMortarAreTold) {
  const auto s = structure_of({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.01, 0, 0}, {2, 1, 1})}, {});
  TEST_ASSERT(warns(s, "open_joints") && warns(s, "stones_without_joint"));
  StonesParameters wide;
  wide.joint_tolerance = 0.015;
  const auto touching = structure_of({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.01, 0, 0}, {2, 1, 1})}, wide);
  TEST_EQUALITY(touching.joints.joints.size(), 1u);
  TEST_ASSERT(touching.warnings.empty());
}

TEUCHOS_UNIT_TEST(Structure, FacesWithAStoneBetweenThemAreNotOpen) {
  const auto s = structure_of(
      {box("a", {0, 0, 0}, {1, 1, 1}), box("slab", {0, 0, 1}, {1, 1, 1.04}), box("b", {0, 0, 1.04}, {1, 1, 2})}, {});
  TEST_ASSERT(!warns(s, "open_joints"));
  TEST_EQUALITY(s.joints.joints.size(), 2u);
}

TEUCHOS_UNIT_TEST(Structure, WhatWeldingDoesToVolumesIsTold) {
  StonesParameters p;
  p.weld = 0.06;
  const auto s = structure_of({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.05, 0, 0}, {2, 1, 1})}, p);
  TEST_ASSERT(warns(s, "welded_volumes"));
  TEST_ASSERT(tells(s, "corners made one have moved by up to 0.05 m, volumes from 1.95 to 2 m3"));
}

TEUCHOS_UNIT_TEST(Structure, StonesThatMeetAtAnEdgeAreToldSo) {
  const auto s = structure_of({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1, 0, 1}, {2, 1, 2})}, {});
  TEST_EQUALITY(s.warnings.size(), 1u);
  TEST_EQUALITY(s.warnings[0].what, "stones_without_joint");
  TEST_ASSERT(holds(s.warnings[0].text, "touches the next in no face"));
}

TEUCHOS_UNIT_TEST(Structure, JointsThatWeldingClosesAreJointsAndAreTold) {
  // Joints by default are 0.002 of the stones, which have a size of 1; corners are one up to 0.006.
  const auto a = box("a", {0, 0, 0}, {1, 1, 1}), b = box("b", {1.005, 0, 0}, {2.005, 1, 1}),
             below = box("below", {0, 0, -0.5}, {2.005, 1, 0});
  for (const bool alone : {true, false}) {
    const auto stones = alone ? std::vector<StoneSurface>{a, b} : std::vector<StoneSurface>{a, b, below};
    const std::size_t beds = alone ? 0 : 2;
    const auto welded = structure_of(stones, {});
    TEST_EQUALITY(welded.joints.joints.size(), beds + 1);
    TEST_ASSERT(welded.joints.joints.back().welded);
    TEST_FLOATING_EQUALITY(welded.joints.joints.back().farthest, 0.005, 1e-9);
    TEST_FLOATING_EQUALITY(welded.joints.joints.back().opening, 0.005, 1e-9);
    TEST_FLOATING_EQUALITY(welded.joints.joints.back().area, 1.0, 1e-9);
    TEST_ASSERT(warns(welded, "welded_joints"));
    TEST_ASSERT(!warns(welded, "open_joints") && !warns(welded, "stones_without_joint"));
    StonesParameters apart;
    apart.weld = 0.003;
    const auto open = structure_of(stones, apart);
    TEST_EQUALITY(open.joints.joints.size(), beds);
    TEST_ASSERT(warns(open, "open_joints") && !warns(open, "welded_joints"));
    for (const auto* s : {&welded, &open}) {  // blocks touch where joints are told, and nowhere else
      const auto meshes = mesh_stones(*s);
      std::set<std::array<BlockId, 2>> touching, told;
      for (const auto& joint : s->joints.joints) told.insert({joint.stone[0], joint.stone[1]});
      for (const auto& first : meshes.list.blocks)
        for (const auto& second : meshes.list.blocks) {
          std::vector<VertexId> of_first = first.vertex, of_second = second.vertex, both;
          std::sort(of_first.begin(), of_first.end());
          std::sort(of_second.begin(), of_second.end());
          std::set_intersection(of_first.begin(), of_first.end(), of_second.begin(), of_second.end(),
                                std::back_inserter(both));
          if (first.id < second.id && both.size() >= 4) touching.insert({first.id, second.id});
        }
      TEST_ASSERT(touching == told);
    }
  }
}

/// A ring of chords and a peg in it; corners of the peg are turned by a share of its chord.
std::vector<StoneSurface> peg_in_ring(int chords_of_ring, int chords_of_peg, double turned) {
  const auto round = [](int chords, double radius, double by) {
    std::vector<Vector<2>> corners;
    for (int k = 0; k < chords; ++k) {
      const double angle = 2 * std::acos(-1.0) * (k + by) / chords;
      corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return corners;
  };
  auto ring = prism("ring", round(chords_of_ring, 0.6, 0), 0, 0.3);
  const auto hole = prism("hole", round(chords_of_ring, 0.3, 0), 0, 0.3);
  const int n = chords_of_ring, first = 2 * n;
  ring.points.insert(ring.points.end(), hole.points.begin(), hole.points.end());
  ring.faces.resize(static_cast<std::size_t>(n));  // without its two ends, which have the hole
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    ring.faces.push_back({first + k, first + n + k, first + n + next, first + next});
    ring.faces.push_back({k, first + k, first + next, next});
    ring.faces.push_back({n + k, n + next, first + n + next, first + n + k});
  }
  return {ring, prism("peg", round(chords_of_peg, 0.3, turned), 0, 0.3)};
}

double area_of_joints(const StoneStructure& s) {
  double area = 0;
  for (const auto& joint : s.joints.joints) area += joint.area;
  return area;
}

// Chords with corners of their own lie in each other by the height of the arc over one. What is advised helps, and what
// helps against other overlaps does not.
TEUCHOS_UNIT_TEST(Structure, ChordsOfRoundFacesThatDifferAreRefusedAsSuch) {
  const std::string of_chords = "as chords of round faces do", advice = "with the same chords, corner on corner";
  for (const auto& [chords, turned] : {std::pair(24, 0.0), std::pair(16, 0.5), std::pair(12, 0.3)}) {
    const auto error = input_error([&, n = chords, by = turned] { structure_of(peg_in_ring(16, n, by), {}); });
    TEST_ASSERT(holds(error, of_chords) && holds(error, advice));
  }
  const auto alike = structure_of(peg_in_ring(16, 16, 0), {});
  const double all = 16 * 0.3 * 2 * 0.3 * std::sin(std::acos(-1.0) / 16);
  TEST_FLOATING_EQUALITY(area_of_joints(alike), all, 1e-9);
  StonesParameters wide;
  wide.joint_tolerance = 0.012;
  TEST_COMPARE(area_of_joints(structure_of(peg_in_ring(16, 24, 0), wide)), <, 0.9 * all);
  TEST_COMPARE(area_of_joints(structure_of(peg_in_ring(16, 16, 0.5), wide)), <, 0.1 * all);
  // Deeper than chords are, and stones that are not round.
  auto sunk = peg_in_ring(16, 16, 0);
  for (auto& x : sunk[1].points) x[0] += 0.05;
  for (const auto& stones : {sunk, {box("a", {0, 0, 0}, {1, 1, 1}), box("b", {0, 0, 0.99}, {1, 1, 2})}}) {
    const auto error = input_error([&] { structure_of(stones, {}); });
    TEST_ASSERT(holds(error, "in each other") && !holds(error, of_chords) && !holds(error, advice));
  }
}

TEUCHOS_UNIT_TEST(Structure, AStoneThinnerThanTheWeldIsRefusedAsSuch) {
  const std::vector<StoneSurface> stones{box("low", {0, 0, 0}, {1, 1, 1}), box("slip", {0, 0, 1}, {1, 1, 1.004}),
                                         box("high", {0, 0, 1.004}, {1, 1, 2})};
  StonesParameters p;
  p.joint_tolerance = 1e-3;
  p.weld = 5e-3;
  TEST_ASSERT(holds(input_error([&] { structure_of(stones, p); }),
                    "stone \"slip\" (drawn) is 0.004 m thick, thinner than weld"));
  p.weld = 3e-3;
  TEST_EQUALITY(structure_of(stones, p).joints.joints.size(), 2u);
}

TEUCHOS_UNIT_TEST(Structure, ATolerancePlainlyBelowTheNoiseOfAFileIsTold) {
  StonesParameters fine;
  fine.joint_tolerance = 2e-4;
  fine.weld = 4e-3;  // corners come together all the same
  const auto stones = measured(arch(9), 3e-4);
  try {
    TEST_ASSERT(warns(structure_of(stones, fine), "joint_tolerance"));
  } catch (const InputError& error) {  // or the stones do not fit together, which says the same
    TEST_ASSERT(holds(error.what(), "Raise joint tolerance") || holds(error.what(), "raise joint tolerance"));
  }
}

TEUCHOS_UNIT_TEST(Structure, AFileIsReadInItsUnitAndTurnedUpright) {
  std::ofstream file("upright.obj");
  const auto stone = box("tall", {0, 0, 0}, {300, 100, 200});
  for (const auto& x : stone.points) file << "v " << x[0] << " " << x[1] << " " << x[2] << "\n";
  for (const auto& face : stone.faces) {
    file << "f";
    for (const int point : face) file << " " << point + 1;
    file << "\n";
  }
  file.close();
  StonesParameters p;
  p.file = "upright.obj";
  p.unit = 1e-3;
  const auto height = [&](UpAxis up) {
    p.up = up;
    const auto s = structure_of(p);
    TEST_FLOATING_EQUALITY(volume(s.stones[0]), 6e-3, 1e-12);
    return s.faceted[0].box.high[2] - s.faceted[0].box.low[2];
  };
  TEST_FLOATING_EQUALITY(height(UpAxis::x), 0.3, 1e-12);
  TEST_FLOATING_EQUALITY(height(UpAxis::y), 0.1, 1e-12);
  TEST_FLOATING_EQUALITY(height(UpAxis::z), 0.2, 1e-12);
}

}  // namespace
