// Resultants of loads in space against closed forms, on any number of ranks; a box of 1.5 x 0.4 x 1 m.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

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
    const std::vector<double> weight(source.block_count(), 1.0);
    return Structure<3>(
        source, partition(source.graph(), weight, *everyone()), {},
        [](const Block<3>&) {
          return Material{1e9, 0.2, density};
        },
        everyone());
  }

  template <class Parameters>
  Resultant of(const Parameters& parameters, double factor = 1) const {
    LoadParameters load;
    load.kind = parameters;
    std::vector<double> force(3 * structure.nodes(), 0.0), prescribed(force.size(), 0.0);
    make_load(load, LoadSite<3>{structure, *source, {}, "scene > loads > tested"})
        ->add({{0.0, factor}}, force, prescribed);
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

// The list says what acts in space; what does not is refused where a scene is read.
TEUCHOS_UNIT_TEST(LoadsInSpace, AreThoseThatSayIt) {
  const auto words = load_words_in_space();
  TEST_ASSERT((words == std::vector<std::string>{"self weight", "acceleration", "traction"}));
}

}  // namespace
