// Resultants of every load against closed forms, on any number of ranks.
#include "loads/loads.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "unit/loads/load_cases.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::unique_ptr<BlockSource<2>> wall() {  // 2 m x 1 m
  WallParameters p;
  p.courses = p.blocks_per_course = 4;
  return make_wall(p);
}

Structure<2> thin(const BlockSource<2>& source) {
  return structure_of(source, everyone(), {Plane::stress, thickness}, {1e9, 0.2, density});
}

int set_number(const BlockSource<2>& source, const std::string& name) {
  const auto& sets = source.facet_sets();
  return static_cast<int>(std::find(sets.begin(), sets.end(), name) - sets.begin());
}

TractionParameters traction(double tx, double ty, double pressure) {
  TractionParameters t;
  t.tx = tx;
  t.ty = ty;
  t.pressure = pressure;
  return t;
}

// Sums of some hundred positive terms: 1e-13 is far above their round-off. Sums that vanish are compared with the size
// of their terms.
constexpr double round_off = 1e-13;

TEUCHOS_UNIT_TEST(SelfWeight, IsTheWeightOfTheWallAtItsCentre) {
  const auto source = wall();
  const auto s = thin(*source);
  BlockForces force(s);
  SelfWeightParameters load;
  load.gravity = 9.5;
  add_self_weight(s, load, 0.5, force);
  const double half_weight = 0.5 * density * 9.5 * 2 * 1 * thickness;
  const auto r = resultant(s, force.of_nodes);
  TEST_FLOATING_EQUALITY(r.y, -half_weight, round_off);
  TEST_EQUALITY(r.x, 0.0);
  TEST_FLOATING_EQUALITY(r.moment, -half_weight * 1.0, round_off);  // the middle is at x = 1 m
}

TEUCHOS_UNIT_TEST(InertiaForce, IsMassTimesAccelerationAndIsAdded) {
  const auto source = wall();
  const auto s = thin(*source);
  BlockForces force(s);
  add_inertia_force<2>(s, {1.5, 0}, 1.0, force);
  add_inertia_force<2>(s, {0, 2.5}, -2.0, force);
  const double mass = density * 2 * 1 * thickness;
  const auto r = resultant(s, force.of_nodes);
  TEST_FLOATING_EQUALITY(r.x, 1.5 * mass, round_off);
  TEST_FLOATING_EQUALITY(r.y, -5.0 * mass, round_off);
}

TEUCHOS_UNIT_TEST(InertiaForce, KnowsTheDensityOfEachBlock) {
  const auto source = wall();
  const Structure<2> s(
      *source, share_out(*source, *everyone()), {Plane::stress, thickness},
      [](const Block<2>& b) {
        return Material{1e9, 0.2, b.id < 4 ? 3000.0 : 1000.0};
      },
      everyone());
  BlockForces force(s);
  add_inertia_force<2>(s, {1, 0}, 1.0, force);
  // The lowest of four courses is heavy.
  TEST_FLOATING_EQUALITY(resultant(s, force.of_nodes).x, (3000 * 0.25 + 1000 * 0.75) * 2 * thickness, round_off);
}

TEUCHOS_UNIT_TEST(Traction, IsTheTractionTimesTheAreaOfTheFacets) {
  const auto source = wall();
  const auto s = thin(*source);
  BlockForces force(s);
  add_traction(s, traction(300, -700, 0), set_number(*source, "top"), 2.0, force);
  const auto r = resultant(s, force.of_nodes);
  TEST_FLOATING_EQUALITY(r.x, 2 * 300 * 2 * thickness, round_off);
  TEST_FLOATING_EQUALITY(r.y, -2 * 700 * 2 * thickness, round_off);
  TEST_FLOATING_EQUALITY(r.moment, r.y * 1.0 - r.x * 1.0, round_off);  // at (1, 1)
  for (int i = 0; i < s.nodes(); ++i)
    if (s.position()[i][1] < 1) TEST_EQUALITY(force.of_nodes[2 * i + 1], 0.0);
}

TEUCHOS_UNIT_TEST(Traction, PressurePushesAgainstTheOutwardNormalOfEverySide) {
  const auto source = wall();
  const auto s = thin(*source);
  struct Side {
    std::string name;
    double length;
    Vector<2> inwards;
  };
  for (const auto& [name, length, inwards] :
       {Side{"left", 1, {1, 0}}, Side{"right", 1, {-1, 0}}, Side{"top", 2, {0, -1}}, Side{"base", 2, {0, 1}}}) {
    BlockForces force(s);
    add_traction(s, traction(0, 0, 1000), set_number(*source, name), 1.0, force);
    const auto r = resultant(s, force.of_nodes);
    const double total = 1000 * length * thickness;
    TEST_COMPARE(std::abs(r.x - total * inwards[0]), <=, round_off * total);
    TEST_COMPARE(std::abs(r.y - total * inwards[1]), <=, round_off * total);
  }
}

TEUCHOS_UNIT_TEST(Traction, PressureDoesNotCareInWhichOrderAFacetNamesItsNodes) {
  BlockList<2> list;
  list.facet_sets = {"left"};
  list.blocks.push_back(block_of_cells(0, rectangle(0, 0, 2, 2), 0.5));
  auto& block = list.blocks[0];
  const auto node_at = [&block](double x, double y) {
    return int(std::find(block.position.begin(), block.position.end(), Vector<2>{x, y}) - block.position.begin());
  };
  TaggedFacet down, up;
  down.count = up.count = 2;
  down.node = {node_at(0, 0.5), node_at(0, 0)};
  up.node = {node_at(0, 0.5), node_at(0, 1)};
  block.facets = {down, up};
  const auto source = make_source<2>(list);
  const auto s = thin(*source);
  BlockForces force(s);
  add_traction(s, traction(0, 0, 1000), 0, 1.0, force);
  const auto r = resultant(s, force.of_nodes);
  TEST_FLOATING_EQUALITY(r.x, 1000 * thickness, round_off);
  TEST_FLOATING_EQUALITY(r.moment, -500 * thickness, round_off);  // at half the height
}

TEUCHOS_UNIT_TEST(Traction, PressureOnTheExtradosOfAnArchIsPressureTimesSpan) {
  ArchParameters arch;  // 5 m to the middle line, 1 m thick
  arch.voussoirs = 7;
  const auto source = make_arch(arch);
  const auto s = thin(*source);
  BlockForces force(s);
  add_traction(s, traction(0, 0, 1000), set_number(*source, "extrados"), 1.0, force);
  const auto r = resultant(s, force.of_nodes);
  const double total = 1000 * 11 * thickness;  // whatever the line between its ends: 2 x 5.5 m apart
  TEST_FLOATING_EQUALITY(r.y, -total, round_off);
  TEST_COMPARE(std::abs(r.x), <=, round_off * total);
}

TEUCHOS_UNIT_TEST(Settlement, MovesAndTurnsTheHeldComponentsOnceAtEveryNode) {
  const auto source = wall();
  const auto s = thin(*source);
  SettlementParameters load;
  load.support = "ground";
  load.ux = 1e-3;
  load.uy = -2e-3;
  load.turn.rotation = 1e-2;
  load.turn.about[0] = 0.5;
  load.turn.about[1] = -0.25;
  for (const std::string components : {"x", "y", "xy"}) {
    std::vector<double> u(2 * s.nodes(), 0.0);
    const std::vector<std::pair<std::string, SupportParameters>> supports{{"ground", {"base", components}}};
    LoadParameters settlement;
    settlement.kind = load;
    BlockForces force(s);  // added: three quarters in all
    make_load(settlement, LoadSite<2>{s, *source, supports, "scene > loads > tested"})
        ->add({{0, 0.25}, {0, 0.5}}, force, u);
    for (int i = 0; i < s.nodes(); ++i) {
      const auto& x = s.position()[i];
      // Counter-clockwise by 1e-2 about (0.5, -0.25): points right of it rise, points above it go left.
      const Vector<2> full{1e-3 - 1e-2 * (x[1] + 0.25), -2e-3 + 1e-2 * (x[0] - 0.5)};
      for (int c = 0; c < 2; ++c) {
        const bool moves = x[1] == 0 && components.find("xy"[c]) != std::string::npos;
        TEST_COMPARE(std::abs(u[2 * i + c] - (moves ? 0.75 * full[c] : 0.0)), <=, 1e-17);
      }
    }
  }
}

}  // namespace
