// Masonry in space that generators make: walls with returns and openings, prisms, domes and barrel vaults. Matching
// nodes, graphs, joints, volumes of polyhedra in closed form, sets that close the surface, refusals.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "mesh/generators.hpp"
#include "support/input_error.hpp"
#include "unit/mesh/masonry_facts.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

const double pi = std::acos(-1.0);
// Sums of up to some thousand terms, each right to 1e-16 of the size.
constexpr double round_off = 1e-12;

/// The dry walls of the field: stones of 0.4 x 0.2 x 0.2 m, 10 courses, a facade of 2.4 m.
WallInSpaceParameters field_wall(int left, int right) {
  WallInSpaceParameters p;
  p.courses = 10;
  p.blocks_per_course = 6;
  p.block_length = 0.4;
  p.block_height = p.thickness = 0.2;
  p.cells_up = p.cells_across = 1;
  p.ground_height = 0.2;
  p.return_left = left;
  p.return_right = right;
  return p;
}

const std::set<std::string> outside_of_walls{
    "base", "top", "left", "right", "front", "back", "return left inside", "return right inside", "return ends"};

/// The sets are a closed surface round the blocks: areas cancel, and it encloses their volume.
void check_surface(const BlockSource<3>& source, const std::set<std::string>& sets, double expected,
                   Teuchos::FancyOStream& out, bool& success) {
  const auto sums = sums_over(source, sets);
  TEST_COMPARE(norm(sums.area), <=, round_off * expected);
  TEST_FLOATING_EQUALITY(sums.volume, expected, round_off);
  TEST_FLOATING_EQUALITY(volume(source), expected, round_off);
}

TEUCHOS_UNIT_TEST(Masonry, WallsWithReturnsAreThoseOfTheField) {
  // Stones and joints as counted by hand: 6 or 7 stones of the facade, 3 of each return, and those on the ground.
  const auto straight = make_wall_in_space(field_wall(0, 0)), l = make_wall_in_space(field_wall(3, 0));
  TEST_EQUALITY(straight->block_count() - int(blocks_of(*straight, "ground").size()), 65);
  TEST_EQUALITY(joints(*straight) - 5, 169);  // the ground's own
  TEST_EQUALITY(l->block_count() - int(blocks_of(*l, "ground").size()), 90);
  TEST_EQUALITY(joints(*l) - 8, 242);
  check_source(*l, out, success);
  for (const auto to : {ReturnsTo::back, ReturnsTo::front})
    for (const auto& [left, right] : {std::pair(3, 0), std::pair(0, 2), std::pair(3, 3), std::pair(1, 2)}) {
      auto p = field_wall(left, right);
      p.returns_to = to;
      p.ground_height = 0;
      p.cells_across = 2;
      p.cells_along = 4;
      const auto source = make_wall_in_space(p);
      check_source(*source, out, success);
      const double returns = (left > 0 ? 0.4 * left - 0.2 : 0) + (right > 0 ? 0.4 * right - 0.2 : 0);
      check_surface(*source, outside_of_walls, (2.4 + returns) * 0.2 * 2, out, success);
    }
}

TEUCHOS_UNIT_TEST(Masonry, CornersOfReturnsBelongToWallAndReturnInTurn) {
  auto p = field_wall(3, 3);
  p.ground_height = 0;
  for (const auto to : {ReturnsTo::back, ReturnsTo::front}) {
    p.returns_to = to;
    const auto source = make_wall_in_space(p);
    for (BlockId b = 0; b < source->block_count(); ++b) {
      const auto block = source->block(b);
      const bool corner = std::any_of(block.position.begin(), block.position.end(), [&](const auto& x) {
        return x[0] == 0 && x[1] == (to == ReturnsTo::back ? 0 : 0.2);
      });
      if (!corner) continue;
      const bool odd = block.sets[0] % 2 == 1;
      TEST_EQUALITY(source->block_sets()[block.sets[1]], odd ? "return left" : "facade");
    }
    const auto inside = sums_over(*source, {"return left inside"}).area;
    TEST_COMPARE(norm(inside - Vector<3>{2.0, 0, 0}), <=, round_off);  // 1 m behind the wall, 2 m high
    const double way = to == ReturnsTo::back ? 1 : -1;
    TEST_COMPARE(norm(sums_over(*source, {"return ends"}).area - Vector<3>{0, way * 2 * 0.4, 0}), <=, round_off);
    const double front = to == ReturnsTo::back ? 2.4 : 2.0;  // without what returns cover
    TEST_COMPARE(norm(sums_over(*source, {"front"}).area - Vector<3>{0, -2 * front, 0}), <=, round_off);
  }
}

TEUCHOS_UNIT_TEST(Masonry, OpeningsAreCutAtHalfStonesAndBridgedByLintels) {
  auto p = field_wall(3, 0);
  p.openings["door"] = {0.8, 1.4, 0.0, 1.2};
  p.openings["window"] = {1.8, 2.2, 0.8, 2.0};  // to the top: nothing to bear
  const auto source = make_wall_in_space(p);
  check_source(*source, out, success);
  const double stones = (2.4 + 1.0) * 2 - 0.6 * 1.2 - 0.4 * 1.2, ground = 3.4 * 0.2;
  TEST_FLOATING_EQUALITY(volume(*source), (stones + ground) * 0.2, round_off);
  TEST_EQUALITY(blocks_of(*source, "lintels").size(), 1u);
  TEST_ASSERT(holds(blocks_of(*source, "lintels").at(0), "(course 6, lintel of door, stone 2)"));
  for (BlockId b = 0; b < source->block_count(); ++b) {
    const auto block = source->block(b);
    Vector<3> low = block.position.front(), high = block.position.back();
    const bool lintel = holds(block.name, "lintel");
    TEST_FLOATING_EQUALITY(high[2] - low[2], 0.2, round_off);
    const double length = std::max(high[0] - low[0], high[1] - low[1]);
    TEST_ASSERT(std::abs(length - (lintel ? 1.0 : 0.4)) < round_off || std::abs(length - 0.2) < round_off);
    for (const auto& named : p.openings) {
      const auto& o = named.second;
      const double x = (low[0] + high[0]) / 2, z = (low[2] + high[2]) / 2;
      TEST_ASSERT(!(o.x_from < x && x < o.x_to && o.z_from < z && z < o.z_to && low[1] < 0.1));
    }
  }
}

TEUCHOS_UNIT_TEST(Masonry, OpeningsThatCannotBeAreRefusedInWords) {
  const auto said = [](const std::map<std::string, OpeningInSpace>& openings, int left = 0) {
    auto p = field_wall(left, 0);
    p.openings = openings;
    return input_error([&] { make_wall_in_space(p); });
  };
  TEST_ASSERT(said({{"door", {0.8, 1.4, 0.0, 1.2}}}).empty());
  TEST_ASSERT(holds(said({{"door", {0.8, 1.5, 0.0, 1.2}}}),
                    "mesh > wall in space > openings > door > x to = 1.5 [m]\n  must be a multiple of 0.2 m, half a"));
  TEST_ASSERT(holds(said({{"door", {0.8, 1.5, 0.0, 1.2}}}), "Give 1.4 or 1.6."));
  TEST_ASSERT(holds(said({{"door", {0.8, 1.4, 0.0, 1.1}}}), "z to = 1.1 [m]\n  must be a multiple of 0.2 m, a course"));
  TEST_ASSERT(holds(said({{"door", {0.0, 0.4, 0.0, 1.2}}}), "x from = 0 [m]\n  leaves no half stone"));
  TEST_ASSERT(said({{"door", {0.2, 0.6, 0.0, 1.2}}}).empty());
  TEST_ASSERT(holds(said({{"door", {0.2, 0.6, 0.0, 1.2}}}, 3), "lie between 0.4 and 2.2 m"));
  TEST_ASSERT(holds(said({{"door", {0.8, 1.4, 0.0, 2.2}}}), "z to = 2.2 [m]\n  is outside the wall"));
  TEST_ASSERT(holds(said({{"a", {0.4, 0.8, 0.0, 1.2}}, {"b", {1.0, 1.4, 0.4, 1.2}}}), "meets the lintel of \"b\""));
  TEST_ASSERT(said({{"a", {0.4, 0.8, 0.0, 1.2}}, {"b", {1.2, 1.6, 0.4, 1.2}}}).empty());
  TEST_ASSERT(holds(said({{"a", {0.4, 0.8, 0.0, 1.2}}, {"b", {0.6, 1.6, 0.4, 1.2}}}), "meets the opening of \"b\""));
}

TEUCHOS_UNIT_TEST(Masonry, ReturnsThatCannotBeBondedAreRefusedInWords) {
  const auto said = [](const auto& change) {
    auto p = field_wall(3, 3);
    change(p);
    return input_error([&] { make_wall_in_space(p); });
  };
  TEST_ASSERT(
      holds(said([](auto& p) { p.thickness = 0.25; }),
            "mesh > wall in space > thickness = 0.25 [m]\n  must be half a block, 0.2 m, in a wall with returns"));
  TEST_ASSERT(holds(said([](auto& p) { p.bond = WallBond::stack; }), "return left = 3 [-]\n  is bonded into the wall"));
  TEST_ASSERT(holds(said([](auto& p) { p.blocks_per_course = 1; }), "blocks per course = 1 [-]\n  leaves no stone"));
}

TEUCHOS_UNIT_TEST(Masonry, PrismsAreStacksOfBoxes) {
  PrismParameters p;
  p.stones = 3;
  for (const double ground : {0.0, 0.5}) {
    p.ground_height = ground;
    const auto source = make_prism(p);
    check_source(*source, out, success);
    TEST_FLOATING_EQUALITY(volume(*source), 0.6 * (2 + ground), round_off);
    TEST_EQUALITY(source->block_count(), ground > 0 ? 4 : 3);
    TEST_EQUALITY(joints(*source), source->block_count() - 1);
    const auto sums = sums_over(*source, {"base", "top", "left", "right", "front", "back"});
    TEST_COMPARE(norm(sums.area), <=, round_off);
    TEST_FLOATING_EQUALITY(sums.volume, 1.2, round_off);
  }
}

/// Stones between two radii whose corners lie on rays through the centre are differences of pyramids: over a plane face
/// between two circles of latitude, det / 6 of the corners.
double dome_volume(const DomeParameters& p) {
  const bool plane = p.faces == StoneFaces::plane;
  const int round = p.lunes * (!plane ? p.cells_round : p.bond == WallBond::running ? 2 : 1);
  const int up = p.courses * (plane ? 1 : p.cells_up);
  const double outer = p.radius + p.thickness / 2, inner = p.radius - p.thickness / 2;
  const double step = (p.springing - p.oculus) / up * pi / 180;
  double sines = 0;
  for (int k = 0; k < up; ++k)
    for (const int ring : {k, k + 1}) sines += std::sin(p.springing * pi / 180 - ring * step);
  return (std::pow(outer, 3) - std::pow(inner, 3)) / 6 * std::sin(step) * std::sin(2 * pi / round) * round * sines;
}

TEUCHOS_UNIT_TEST(Masonry, DomesAreOfPolyhedraRoundTheirAxis) {
  DomeParameters p;
  p.lunes = 8;
  p.courses = 3;
  for (const auto bond : {WallBond::running, WallBond::stack})
    for (const auto faces : {StoneFaces::round, StoneFaces::plane})
      for (const double springing : {90.0, 60.0, 110.0}) {
        p.bond = bond;
        p.faces = faces;
        p.springing = springing;
        p.cells_up = 3;
        p.cells_round = bond == WallBond::stack ? 3 : 4;
        p.ground_height = 0;
        const auto source = make_dome(p);
        check_source(*source, out, success);
        check_surface(*source, {"base", "oculus", "intrados", "extrados"}, dome_volume(p), out, success);
        // Beds of stones that lie half on each other are joints with both, heads close each course.
        const int beds = bond == WallBond::running ? 2 : 1;
        TEST_EQUALITY(joints(*source), 3 * 8 + 2 * beds * 8);
        p.ground_height = 0.4;
        const auto on_ground = make_dome(p);
        check_source(*on_ground, out, success);
        TEST_EQUALITY(joints(*on_ground), joints(*source) + 8 + 8);
      }
  p = DomeParameters();
  p.lunes = 3;  // the fewest
  p.faces = StoneFaces::plane;
  check_source(*make_dome(p), out, success);
}

TEUCHOS_UNIT_TEST(Masonry, TheDomeStandsLevelOnTheGroundThatHoldsIt) {
  DomeParameters p;
  p.ground_height = 0.25;
  const auto source = make_dome(p);
  std::set<int> held;
  for (BlockId b = 0; b < 2 * p.lunes; ++b) {
    const auto block = source->block(b);
    const bool ground = b < p.lunes;
    TEST_EQUALITY(block.sets.at(0), ground ? p.courses : 0);
    held.clear();
    for (const auto& facet : block.facets)
      if (source->facet_sets()[facet.set] == "ground") held.insert(facet.node.begin(), facet.node.end());
    TEST_EQUALITY(held.size(), ground ? block.position.size() : 0u);
    double lowest = 1;
    for (const auto& x : block.position) lowest = std::min(lowest, x[2]);
    TEST_EQUALITY(lowest, ground ? -0.25 : 0.0);
  }
}

TEUCHOS_UNIT_TEST(Masonry, BarrelVaultsAreArchesDrawnOut) {
  BarrelVaultParameters p;
  p.cells_round = 2;
  p.cells_along = 2;
  for (const auto bond : {WallBond::running, WallBond::stack})
    for (const auto faces : {StoneFaces::round, StoneFaces::plane})
      for (const double embrace : {180.0, 120.0}) {
        p.bond = bond;
        p.faces = faces;
        p.embrace = embrace;
        p.ground_height = 0;
        const auto source = make_barrel_vault(p);
        check_source(*source, out, success);
        const int edges = p.voussoirs * (faces == StoneFaces::round ? 2 : 1);
        const double ring = (3.2 * 3.2 - 2.8 * 2.8) / 2 * std::sin(embrace / edges * pi / 180) * edges;
        check_surface(*source, {"springing left", "springing right", "intrados", "extrados", "front", "back"}, ring * 4,
                      out, success);
        const bool running = bond == WallBond::running;
        TEST_EQUALITY(joints(*source), running ? 8 * 3 + 7 * 4 + 14 * 8 : 15 * 3 + 14 * 4);
        p.ground_height = 0.5;
        const auto on_ground = make_barrel_vault(p);
        check_source(*on_ground, out, success);
        TEST_EQUALITY(joints(*on_ground), joints(*source) + 2 * (3 + 4));
        TEST_FLOATING_EQUALITY(volume(*on_ground) - volume(*source), 2 * 0.5 * 0.4 * 4, 1e-10);
      }
}

/// How many hexahedra there are, and the longest edge of any [m].
std::pair<int, double> counted(const BlockSource<3>& source) {
  int cells = 0;
  double longest = 0;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    cells += static_cast<int>(block.cells.size());
    for (const auto& cell : block.cells)
      for (const auto& face : faces_of_hexahedron)
        for (int i = 0; i < 4; ++i)
          longest = std::max(longest,
                             norm(block.position[cell.node[face[i]]] - block.position[cell.node[face[(i + 1) % 4]]]));
  }
  return {cells, longest};
}

// What is told before the first block is made. Chords are shorter than arcs: by 6 % over 60 degrees.
TEUCHOS_UNIT_TEST(Masonry, CellsAreCountedBeforeTheyAreMade) {
  const auto check = [&](const MasonryParameters& p, const BlockSource<3>& source) {
    const auto [cells, longest] = counted(source);
    TEST_FLOATING_EQUALITY(p.cell_count(), double(cells), 1e-12);
    TEST_COMPARE(longest, <=, p.longest_edge() * (1 + 1e-12));
    TEST_COMPARE(longest, >=, p.longest_edge() * 0.94);
  };
  auto wall = field_wall(3, 2);
  wall.openings["door"] = {0.8, 1.4, 0.0, 1.2};
  wall.cells_along = 4;
  check(wall, *make_wall_in_space(wall));
  PrismParameters prism;
  prism.stones = 2;
  prism.ground_height = 0.1;
  check(prism, *make_prism(prism));
  for (const double springing : {90.0, 60.0}) {
    DomeParameters dome;
    dome.springing = springing;
    dome.ground_height = 0.1;
    check(dome, *make_dome(dome));
  }
  BarrelVaultParameters vault;
  vault.ground_height = 0.1;
  check(vault, *make_barrel_vault(vault));
  vault.coarsen(2);
  TEST_EQUALITY(vault.cells_along, 2);  // halves of stones have cells of their own
  TEST_EQUALITY(vault.cells_radial, 1);
}

// Nodes of the front are those of the arch in the plane, to the rounding of sines.
TEUCHOS_UNIT_TEST(Masonry, TheFrontOfABarrelVaultIsTheArchOfThePlane) {
  ArchParameters flat;
  flat.radius = 3;
  flat.thickness = 0.4;
  flat.voussoirs = 15;
  flat.cells_radial = flat.cells_along = 2;
  BarrelVaultParameters p;
  p.cells_round = 2;
  p.stones_along = p.cells_along = 1;
  p.bond = WallBond::stack;
  const auto vault = make_barrel_vault(p);
  const auto arch = make_arch(flat);
  TEST_EQUALITY(vault->block_count(), arch->block_count());
  for (BlockId b = 0; b < arch->block_count(); ++b) {
    const auto solid = vault->block(b);
    const auto plane = arch->block(b);
    for (int ray = 0; ray <= 2; ++ray)
      for (int line = 0; line <= 2; ++line) {
        const auto& x = solid.position[ray * 6 + line];
        const auto& y = plane.position[ray * 3 + line];
        TEST_EQUALITY(x[1], 0.0);
        TEST_COMPARE(std::hypot(x[0] - y[0], x[2] - y[1]), <=, 4 * 2.3e-16 * 3);
      }
  }
}

TEUCHOS_UNIT_TEST(Masonry, RoundMasonryThatCannotBeIsRefusedInWords) {
  const auto dome = [](const auto& change) {
    DomeParameters p;
    change(p);
    return input_error([&] { make_dome(p); });
  };
  TEST_ASSERT(dome([](auto&) {}).empty());
  TEST_ASSERT(holds(dome([](auto& p) { p.oculus = 0; }), "mesh > dome > oculus = 0 [degree]\n  must be a finite"));
  TEST_ASSERT(holds(dome([](auto& p) { p.oculus = 90; }), "mesh > dome > springing = 90 [degree]\n  must lie between"));
  TEST_ASSERT(holds(dome([](auto& p) { p.cells_round = 3; }), "dome > cells round = 3 [-]\n  must be even"));
  TEST_ASSERT(holds(dome([](auto& p) { p.lunes = 2; }), "dome > lunes = 2 [-]\n  must be >= 3"));
  TEST_ASSERT(holds(dome([](auto& p) { p.thickness = 10; }), "dome > thickness = 10 [m]\n  must be < 2 x radius"));
  const auto vault = [](const auto& change) {
    BarrelVaultParameters p;
    change(p);
    return input_error([&] { make_barrel_vault(p); });
  };
  TEST_ASSERT(vault([](auto&) {}).empty());
  TEST_ASSERT(holds(vault([](auto& p) { p.embrace = 360; }), "barrel vault > embrace = 360 [degree]\n  must be < 360"));
  TEST_ASSERT(holds(vault([](auto& p) { p.cells_along = 3; }), "barrel vault > cells along = 3 [-]\n  must be even"));
  TEST_ASSERT(
      holds(vault([](auto& p) { p.voussoirs = 2; }), "barrel vault > voussoirs = 2 [-]\n  makes edges over 90"));
}

}  // namespace
