// Resultants of loads in space against closed forms, on any number of ranks; a box of 1.5 x 0.4 x 1 m.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "blocks/supports.hpp"
#include "loads/load.hpp"
#include "mesh/generators.hpp"
#include "mesh/partition.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double density = 2000, length = 1.5, thickness = 0.4, height = 1;
constexpr double mass = density * length * thickness * height;

/// Force and moment about the origin, over all ranks.
struct Resultant {
  Vector<3> force{}, moment{};
};

struct Wall {
  std::unique_ptr<BlockSource<3>> source;
  Structure<3> structure;

  Wall() : source(make_wall_in_space(parameters())), structure(structure_of(*source)) {}
  static WallInSpaceParameters parameters() {
    WallInSpaceParameters p;
    p.courses = 4;
    p.blocks_per_course = 3;
    p.block_length = length / 3;
    p.block_height = height / 4;
    p.thickness = thickness;
    return p;
  }
  static Structure<3> structure_of(const BlockSource<3>& source) {
    return Structure<3>(
        source, share_out(source, *everyone()), {},
        [](const Block<3>&) {
          return Material{1e9, 0.2, density};
        },
        everyone());
  }

  template <class Parameters>
  Resultant of(const Parameters& parameters, double factor = 1) const {
    LoadParameters load;
    load.kind = parameters;
    BlockForces all(structure);
    std::vector<double> prescribed(all.of_nodes.size(), 0.0);
    make_load(load, LoadSite<3>{structure, *source, {}, "scene > loads > tested"})
        ->add({{0.0, factor}}, all, prescribed);
    const auto& force = all.of_nodes;
    Resultant r;
    for (int i = 0; i < structure.owned_nodes(); ++i) {
      const Vector<3> f{force[3 * i], force[3 * i + 1], force[3 * i + 2]};
      r.force = r.force + f;
      r.moment = r.moment + cross(structure.position()[i], f);
    }
    for (int c = 0; c < 3; ++c) {
      r.force[c] = sum_over_ranks(*everyone(), r.force[c]);
      r.moment[c] = sum_over_ranks(*everyone(), r.moment[c]);
    }
    return r;
  }
};

const Vector<3> middle{length / 2, thickness / 2, height / 2};

/// A force and its moment where it acts; some hundred terms of one sign, or that cancel to their round-off.
void compare(const Resultant& found, const Vector<3>& force, const Vector<3>& at, Teuchos::FancyOStream& out,
             bool& success) {
  TEST_COMPARE(norm(found.force - force), <=, 1e-13 * norm(force));
  TEST_COMPARE(norm(found.moment - cross(at, force)), <=, 1e-13 * norm(force) * norm(at));
}

TEUCHOS_UNIT_TEST(SelfWeightInSpace, PullsDownAtTheMiddle) {
  SelfWeightParameters weight;
  weight.gravity = 9.5;
  compare(Wall().of(weight, 0.5), {0, 0, -0.5 * mass * 9.5}, middle, out, success);
}

TEUCHOS_UNIT_TEST(AccelerationInSpace, PushesInItsOwnDirection) {
  AccelerationParameters push;
  push.ax = 1.5;
  push.ay = -2;
  push.az = 0.5;
  compare(Wall().of(push), mass * Vector<3>{1.5, -2, 0.5}, middle, out, success);
}

TEUCHOS_UNIT_TEST(TractionInSpace, IsForcePerAreaAndPressureAgainstTheNormal) {
  TractionParameters dead;
  dead.on = "back";
  dead.tx = 3;
  dead.ty = 4;
  dead.tz = -5;
  const Vector<3> at{middle[0], thickness, middle[2]};
  compare(Wall().of(dead), length * height * Vector<3>{3, 4, -5}, at, out, success);
  TractionParameters wind;
  wind.on = "front";
  wind.pressure = 700;
  compare(Wall().of(wind), {0, 700 * length * height, 0}, {middle[0], 0, middle[2]}, out, success);
  wind.on = "top";
  compare(Wall().of(wind), {0, 0, -700 * length * thickness}, {middle[0], middle[1], height}, out, success);
}

TEUCHOS_UNIT_TEST(SupportsInSpace, HoldTheComponentsTheyName) {
  const Wall wall;
  const auto count = [&](const std::string& components) {
    SupportParameters support;
    support.on = "base";
    support.components = components;
    std::vector<char> held(3 * wall.structure.nodes(), 0);
    hold(wall.structure, support, facet_set(*wall.source, {"base", ""}), held);
    std::array<double, 3> of{};
    for (int i = 0; i < 3 * wall.structure.owned_nodes(); ++i) of[i % 3] += held[i];
    for (double& c : of) c = sum_over_ranks(*everyone(), c);
    return of;
  };
  const double nodes = 3 * 3 * 3;  // three blocks, each with copies of its own
  TEST_ASSERT((count("all") == std::array<double, 3>{nodes, nodes, nodes}));
  TEST_ASSERT((count("z") == std::array<double, 3>{0, 0, nodes}));
  TEST_ASSERT((count("xz") == std::array<double, 3>{nodes, 0, nodes}));
  TEST_ASSERT((count("xy") == std::array<double, 3>{nodes, nodes, 0}));
}

TEUCHOS_UNIT_TEST(SupportsInSpace, HoldAlongTheNormalsOfTheirFacets) {
  const Wall wall;
  SupportParameters base, front;
  base.on = "base";
  front.on = "front";
  base.components = front.components = "normal";
  const auto set = [&](const SupportParameters& p) { return facet_set(*wall.source, {p.on, ""}); };
  const auto held = held_by(wall.structure, {{base, set(base)}, {front, set(front)}});
  for (int i = 0; i < wall.structure.nodes(); ++i) {
    const auto& x = wall.structure.position()[i];
    const bool at_base = std::abs(x[2]) < 1e-9, at_front = std::abs(x[1]) < 1e-9;
    TEST_EQUALITY(held.has_frame(i), at_base || at_front);
    const auto left = held.free_part(i, Vector<3>{1, 2, 3});
    TEST_COMPARE(norm(left - Vector<3>{1, at_front ? 0.0 : 2.0, at_base ? 0.0 : 3.0}), <=, 1e-14);
  }
}

// Water stands at 0.6 m, in the middle of a course of 0.25 m: faces are cut.
TEUCHOS_UNIT_TEST(WaterPressureInSpace, IsThatOfTheDepthOnWhatIsWet) {
  constexpr double level = 0.6;
  WaterPressureParameters water;
  water.on = "front";
  water.level = level;
  const double force = 1000 * 9.81 * level * level / 2 * length;
  compare(Wall().of(water), {0, force, 0}, {middle[0], 0, level / 3}, out, success);
  water.on = "right";
  compare(Wall().of(water, 0.5), {-force / length * thickness / 2, 0, 0}, {length, middle[1], level / 3}, out, success);
  water.on = "top";
  TEST_COMPARE(norm(Wall().of(water).force), <=, 0.0);
}

TEUCHOS_UNIT_TEST(EarthPressureInSpace, IsHorizontalWhereverTheWallFaces) {
  EarthPressureParameters earth;
  earth.on = "back";
  earth.state = EarthPressureParameters::State::given;
  earth.given = 0.4;
  earth.surface = 0.8;
  earth.surcharge = 5e3;
  const double soil = 0.4 * 18e3 * 0.8 * 0.8 / 2 * length, surcharge = 0.4 * 5e3 * 0.8 * length;
  const double height_of_force = (soil * 0.8 / 3 + surcharge * 0.4) / (soil + surcharge);
  compare(Wall().of(earth), {0, -soil - surcharge, 0}, {middle[0], thickness, height_of_force}, out, success);
  earth.on = "base";
  TEST_COMPARE(norm(Wall().of(earth).force), <=, 0.0);
}

TEUCHOS_UNIT_TEST(CrowdInSpace, StandsOnARectangleOfTheDeck) {
  CrowdParameters crowd;
  crowd.on = "top";
  crowd.intensity = 4000;
  crowd.x_from = 0.1;
  crowd.x_to = 1.3;
  compare(Wall().of(crowd), {0, 0, -4000 * 1.2 * thickness}, {0.7, middle[1], height}, out, success);
  crowd.y_from = 0.15;
  crowd.y_to = 0.25;
  compare(Wall().of(crowd), {0, 0, -4000 * 1.2 * 0.1}, {0.7, 0.2, height}, out, success);
  crowd = {};
  crowd.on = "base";  // nobody stands below
  crowd.intensity = 4000;
  TEST_COMPARE(norm(Wall().of(crowd).force), <=, 0.0);
}

TEUCHOS_UNIT_TEST(BuoyancyInSpace, IsTheWeightOfTheWaterThatIsDisplaced) {
  BuoyancyParameters water;
  water.level = 0.6;
  const double lifted = 1000 * 9.81 * length * thickness;
  compare(Wall().of(water), {0, 0, lifted * 0.6}, {middle[0], middle[1], 0.3}, out, success);
  water.blocks = "course 2";
  compare(Wall().of(water), {0, 0, lifted * 0.1}, {middle[0], middle[1], 0.55}, out, success);
}

TEUCHOS_UNIT_TEST(PointLoadInSpace, IsBorneByTheNearestNode) {
  PointLoadParameters point;
  point.x = 0.25;
  point.y = 0.01;
  point.z = 0.98;
  point.fx = 100;
  point.fy = -200;
  point.fz = 300;
  compare(Wall().of(point), {100, -200, 300}, {0.25, 0, 1}, out, success);
  point.z = 1.2;
  TEST_THROW(Wall().of(point), InputError);
}

TEUCHOS_UNIT_TEST(GroundMotionInSpace, IsInertiaAgainstTheMotion) {
  GroundMotionParameters shake;
  shake.ax = 1;
  shake.ay = -2;
  shake.az = 3;
  compare(Wall().of(shake), -mass * Vector<3>{1, -2, 3}, middle, out, success);
}

// What is warmer pushes on nothing but itself; stones alone take the free strain without a force of their neighbours.
TEUCHOS_UNIT_TEST(TemperatureInSpace, HoldsItselfAndBalancesTheFreeStrain) {
  const Wall wall;
  LoadParameters load;
  TemperatureParameters heat;
  heat.change = 20;
  heat.expansion = 1e-5;
  load.kind = heat;
  BlockForces all(wall.structure);
  std::vector<double> prescribed(all.of_nodes.size(), 0.0);
  const auto made = make_load(load, LoadSite<3>{wall.structure, *wall.source, {}, "scene > loads > tested"});
  made->add({{0.0, 1.0}}, all, prescribed);
  const auto& force = all.of_nodes;
  double largest = 0;
  for (const double f : force) largest = std::max(largest, std::abs(f));
  TEST_COMPARE(largest, >, 0);
  std::vector<double> swollen, held;
  for (const auto& x : wall.structure.position())
    for (const double c : x) swollen.push_back(2e-4 * c);
  wall.structure.apply_stiffness(swollen, held);
  for (int i = 0; i < 3 * wall.structure.owned_nodes(); ++i)
    TEST_COMPARE(std::abs(held[i] - force[i]), <=, 1e-11 * largest);
  // One cube that is heated has on each face the stress E / (1 - 2 nu) times the strain, shared out among its nodes.
  double on_right = 0;
  for (int i = 0; i < wall.structure.owned_nodes(); ++i)
    if (wall.structure.position()[i][0] == length) on_right += force[3 * i];
  TEST_FLOATING_EQUALITY(sum_over_ranks(*everyone(), on_right), 1e9 / 0.6 * 2e-4 * thickness * height, 1e-11);
}

TEUCHOS_UNIT_TEST(SettlementInSpace, TurnsAboutAnyAxis) {
  const Wall wall;
  const std::vector<std::pair<std::string, SupportParameters>> supports{{"foot", {"base", "all", ""}}};
  SettlementParameters settlement;
  settlement.support = "foot";
  settlement.uz = -2e-3;
  settlement.turn.rotation = 1e-3;
  settlement.turn.axis = {0, 3, 4};
  const auto moved = [&](const SettlementParameters& p) {
    LoadParameters load;
    load.kind = p;
    BlockForces force(wall.structure);
    std::vector<double> prescribed(force.of_nodes.size(), 0.0);
    make_load(load, LoadSite<3>{wall.structure, *wall.source, supports, "scene > loads > tested"})
        ->add({{0.0, 0.5}}, force, prescribed);
    return prescribed;
  };
  const auto compare_with = [&](const std::vector<double>& u, const Vector<3>& centre) {
    for (int i = 0; i < wall.structure.nodes(); ++i) {
      const auto& x = wall.structure.position()[i];
      const auto turned = 0.5 * (Vector<3>{0, 0, -2e-3} + 1e-3 * cross(Vector<3>{0, 0.6, 0.8}, x - centre));
      for (int c = 0; c < 3; ++c) TEST_COMPARE(std::abs(u[3 * i + c] - (x[2] == 0 ? turned[c] : 0.0)), <=, 1e-17);
    }
  };
  compare_with(moved(settlement), {middle[0], middle[1], 0});
  settlement.turn.about = {1, 2, 3};
  compare_with(moved(settlement), {1, 2, 3});
}

// Wheels at two lines share an axle; where they stand they are borne with their moment, on one stone or between two.
TEUCHOS_UNIT_TEST(MovingTrainInSpace, StandsOnItsTrack) {
  MovingTrainParameters train;
  train.on = "top";
  train.axle_load = {3000, 1000};
  train.behind = {0, 0.4};
  train.position = 0.63;
  train.y = 0.17;
  compare(Wall().of(train), {0, 0, -4000}, {(3000 * 0.63 + 1000 * 0.23) / 4000, 0.17, height}, out, success);
  train.gauge = 0.2;
  compare(Wall().of(train), {0, 0, -4000}, {(3000 * 0.63 + 1000 * 0.23) / 4000, 0.17, height}, out, success);
  train.position = 0.3;  // the second axle is not on the deck yet
  compare(Wall().of(train), {0, 0, -3000}, {0.3, 0.17, height}, out, success);
  train.position = length;  // at its end, along its far side
  train.gauge = 0;
  train.y = thickness;
  compare(Wall().of(train), {0, 0, -4000}, {(3000 * length + 1000 * (length - 0.4)) / 4000, thickness, height}, out,
          success);
  train.y = thickness + 0.01;
  TEST_THROW(Wall().of(train), InputError);
}

}  // namespace
