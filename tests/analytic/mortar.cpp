// Joints with mortar: springs in series with contact, against closed forms.
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "results/effect_costs.hpp"
#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// Newton stops at 1e-8 of the largest force; displacements add up over a few joints.
constexpr double tolerance = 1e-7;
constexpr double gravity = 9.81, density = 2000, modulus = 10e9;

/// Stones on top of each other, without Poisson's ratio: bars. Odd courses are two halves.
Scene column(int courses, double normal, double tangential) {
  Scene scene = wall_scene(courses);
  scene.mesh.wall.blocks_per_course = 1;
  scene.materials[0].parameters.poisson_ratio = 0;
  scene.joints[0].parameters.normal_stiffness = normal;
  scene.joints[0].parameters.tangential_stiffness = tangential;
  scene.loads.resize(1);
  apply_all_loads(scene);
  return scene;
}

/// Displacement of the top of a column: what the stones give, and what each bed joint gives under what lies on it.
double top_by_hand(const Scene& scene, int courses) {
  const double height = scene.mesh.wall.block_height, weight = density * gravity * height;
  double sinks = weight * height / modulus * courses * courses / 2;
  const double joint = weight / scene.joints[0].parameters.normal_stiffness;
  for (int above = courses - 1; above > 0; --above) sinks += above * joint;
  return -sinks;
}

double wrong_at_the_top(const Solution& s, double expected) {
  double top = 0, worst = 0;
  for (const auto& x : s.position) top = std::max(top, x[1]);
  for (std::size_t i = 0; i < s.position.size(); ++i)
    if (s.position[i][1] > top - 1e-9) worst = std::max(worst, std::abs(s.displacement[i][1] - expected));
  return worst / std::abs(expected);
}

TEUCHOS_UNIT_TEST(Mortar, AColumnShortensByItsStonesAndByEachOfItsJoints) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive})
    for (const double stiffness : {1e9, 1e11, 1e13})
      for (const int courses : {2, 5}) {
        Scene scene = column(courses, stiffness, stiffness);
        scene.selection.mode = mode;
        const auto s = solved(scene);
        TEST_COMPARE(wrong_at_the_top(s, top_by_hand(scene, courses)), <, tolerance);
      }
}

TEUCHOS_UNIT_TEST(Mortar, TheStifferTheLessItMatters) {
  const auto without = solved(column(4, JointLawParameters::infinity, JointLawParameters::infinity));
  double before = 1;
  for (const double stiffness : {1e11, 1e12, 1e13}) {
    const double now = difference(solved(column(4, stiffness, stiffness)), without);
    TEST_FLOATING_EQUALITY(now / before, before == 1 ? now : 0.1, 1e-3);  // mortar's share goes as its compliance
    before = now;
  }
}

// Forces follow lengths to the second power here (thickness stays), moduli and weights go with them as they please.
TEUCHOS_UNIT_TEST(Mortar, AnswersDoNotDependOnUnits) {
  Scene scene = wall_scene(3);
  auto& law = scene.joints[0].parameters;
  law.normal_stiffness = 2e11;
  law.tangential_stiffness = 5e10;
  const auto metres = solved(scene);
  // The same wall in millimetres, tonnes and seconds: stresses in MPa, stiffness in MPa/mm.
  Scene other = scene;
  auto& wall = other.mesh.wall;
  wall.block_length *= 1e3;
  wall.block_height *= 1e3;
  other.materials[0].parameters.young_modulus *= 1e-6;
  other.materials[0].parameters.density *= 1e-12;
  other.model.thickness *= 1e3;
  other.joints[0].parameters.normal_stiffness *= 1e-9;
  other.joints[0].parameters.tangential_stiffness *= 1e-9;
  for (auto& load : other.loads) {
    if (auto* weight = load_as<SelfWeightParameters>(load)) weight->gravity *= 1e3;
    if (auto* push = load_as<AccelerationParameters>(load)) push->ax *= 1e3, push->ay *= 1e3;
  }
  const auto millimetres = solved(other);
  double worst = 0;
  for (std::size_t i = 0; i < metres.displacement.size(); ++i)
    worst = std::max(worst, norm(1e-3 * millimetres.displacement[i] - metres.displacement[i]));
  // Some points slip, and slips are known to the tolerance of Newton over the stiffness of what slides: 1e-6.
  TEST_COMPARE(worst / metres.largest_displacement(), <, 1e-6);
}

/// The law at every point of a wall under its weight, then pushed: what is wrong with it relative to the largest force.
struct LawErrors {
  double pressure = 0, cone = 0, shear = 0;
};

LawErrors law_errors(const Solution& s, const JointLawParameters& law) {
  LawErrors e;
  const double largest = s.largest_force();
  for (const auto& p : s.points) {
    const double kn = law.normal_stiffness * p.area, kt = law.tangential_stiffness * p.area;
    e.pressure = std::max(e.pressure, std::abs(p.normal_force - std::max(0.0, -kn * p.gap)) / largest);
    const double bound = law.friction_coefficient * p.normal_force;
    e.cone = std::max(e.cone, (std::abs(p.tangential_force) - bound) / largest);
    // Where friction holds in the first and only step, shear is that of the spring.
    if (std::abs(p.tangential_force) < bound - 1e-6 * largest)
      e.shear = std::max(e.shear, std::abs(p.tangential_force + kt * p.slip) / largest);
  }
  return e;
}

TEUCHOS_UNIT_TEST(Mortar, EveryPointOfAPushedWallIsASpringThatOpensAndSlips) {
  for (const double stiffness : {1e10, 1e11}) {
    Scene scene = wall_scene(4);
    auto& law = scene.joints[0].parameters;
    law.normal_stiffness = stiffness;
    law.tangential_stiffness = 0.4 * stiffness;
    apply_all_loads(scene);
    const auto s = solved(scene);
    const auto wrong = law_errors(s, law);
    // Springs turn the tolerance of forces into one of the same size: ten times it, for both sides of a joint.
    TEST_COMPARE(wrong.pressure, <, tolerance);
    TEST_COMPARE(wrong.cone, <, tolerance);
    TEST_COMPARE(wrong.shear, <, tolerance);
    long long open = 0, slipping = 0;
    for (const auto& p : s.points) {
      open += p.gap > 0;
      const double bound = law.friction_coefficient * p.normal_force;
      slipping += p.normal_force > 0 && std::abs(p.tangential_force) > 0.999999 * bound;
    }
    TEST_COMPARE(open, >, 0);  // or nothing was tested
    TEST_COMPARE(slipping, >, 0);
  }
}

/// A stiff stone 1.0 x 0.5 m on a bed that is held, pushed sideways by a share of its weight.
Scene stone_on_bed(double normal, double tangential, double friction, double share) {
  Scene scene = gmsh_scene(repository("/meshes/incline.geo"), 0.1, CellType::quadrilateral);
  scene.mesh.gmsh.geometry = {{"slope", 0}, {"width", 1.0}, {"height", 0.5}};
  scene.materials[0].parameters.young_modulus = 1e13;
  scene.joints[0].parameters.friction_coefficient = friction;
  scene.joints[0].parameters.normal_stiffness = normal;
  scene.joints[0].parameters.tangential_stiffness = tangential;
  add_support(scene, "ground", "xy");
  add_gravity(scene, share * gravity, -gravity);
  return scene;
}

TEUCHOS_UNIT_TEST(Mortar, AStiffStoneShiftsAndTurnsLikeARigidBodyOnSprings) {
  const double kn = 1e8, kt = 0.5e8, width = 1.0, height = 0.5, share = 0.1;
  const double weight = density * gravity * width * height;
  Scene scene = stone_on_bed(kn, kt, 0.6, share);
  apply_all_loads(scene);
  const auto s = solved(scene);
  double turning = 0;  // [m3] second moment of the points as they share the joint
  for (const auto& p : s.points) turning += p.area * std::pow(p.position[0] - width / 2, 2);
  const double sinks = weight / (kn * width), shifts = share * weight / (kt * width),
               turns = share * weight * height / 2 / (kn * turning);
  double worst = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    if (s.block_of_node[i] == 0) continue;
    const auto& x = s.position[i];
    const Vector<2> expected{shifts + turns * x[1], -sinks - turns * (x[0] - width / 2)};
    worst = std::max(worst, norm(s.displacement[i] - expected));
  }
  // Stone and bed give 1e8 Pa/m x 0.5 m / 1e13 Pa = 5e-6 of what the mortar gives.
  TEST_COMPARE(worst / sinks, <, 1e-4);
}

TEUCHOS_UNIT_TEST(Mortar, RemembersWhereItsStonesSlipped) {
  Scene scene = stone_on_bed(2e8, 2e8, 0.6, 0.55);
  const double mu = 0.6;
  scene.loads.clear();
  add_gravity(scene, 0, -gravity);
  scene.loads.back().name = "weight";
  add_gravity(scene, 0.55 * gravity, 0);
  scene.loads.back().name = "push";
  apply_all_loads(scene);
  Experiment stone(scene);
  TEST_ASSERT(stone.advance({{"weight", 1.0}, {"push", 1.0}}));
  const auto pushed = stone.solution();
  TEST_ASSERT(stone.advance({{"weight", 1.0}, {"push", 0.0}}));
  const auto freed = stone.solution();
  const double kt = 2e8, largest = pushed.largest_force();
  int slipped = 0;
  double wrong = 0, left = 0;
  for (std::size_t k = 0; k < pushed.points.size(); ++k) {
    const auto& a = pushed.points[k];
    const auto& b = freed.points[k];
    slipped += std::abs(a.tangential_force) > 0.999999 * mu * a.normal_force && a.normal_force > 0;
    if (std::abs(b.tangential_force) > 0.999999 * mu * b.normal_force) continue;
    wrong = std::max(wrong, std::abs(b.tangential_force - a.tangential_force + kt * a.area * (b.slip - a.slip)));
    left = std::max(left, std::abs(b.tangential_force));
  }
  TEST_COMPARE(slipped, >, 0);
  TEST_COMPARE(slipped, <, static_cast<int>(pushed.points.size()));
  TEST_COMPARE(wrong / largest, <, tolerance);
  TEST_COMPARE(left / largest, >, 1e-3);  // shear stays locked in where no load is left
}

// Courses are laid on what has settled: each sinks by what is laid later, under its own weight on fresh mortar too.
TEUCHOS_UNIT_TEST(Mortar, OfAColumnThatIsBuiltBearsWhatIsLaidAfterIt) {
  const double kn = 1e9;
  Scene scene = column(3, kn, kn);
  scene.stages = three_stages();
  scene.construction = {{"second", {"course 1", "second", ""}}, {"third", {"course 2", "third", ""}}};
  Experiment built(scene);
  TEST_ASSERT(built.run());
  const auto s = built.solution();
  const double height = scene.mesh.wall.block_height, weight = density * gravity * height;
  const double stone = weight * height / modulus, joint = weight / kn;
  // Bottom of the second course: its own weight and the third on the joint, both on the first course since then.
  // Bottom of the third: its own weight on two joints and two courses.
  double worst = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    const int course = s.block_of_node[i] == 0 ? 0 : s.block_of_node[i] < 3 ? 1 : 2;  // one, two halves, one
    if (course > 0 && std::abs(s.position[i][1] - course * height) < 1e-9)
      worst = std::max(worst, std::abs(s.displacement[i][1] + 2 * joint + 2 * stone));
  }
  TEST_COMPARE(worst / (2 * joint), <, tolerance);
}

TEUCHOS_UNIT_TEST(Mortar, StoresWhatTheWeightLoses) {
  Experiment standing(column(4, 1e9, 1e9));
  TEST_ASSERT(standing.run());
  const auto& s = standing.model().structure();
  std::vector<double> ku;
  s.apply_stiffness(standing.state().displacement, ku);
  double mine[2] = {standing.model().mortar_energy(standing.state().lambda), 0}, all[2];
  const double mortar = mine[0];
  for (int i = 0; i < 2 * s.owned_nodes(); ++i) {
    mine[0] += standing.state().displacement[i] * ku[i] / 2;
    mine[1] += standing.state().displacement[i] * standing.load()[i] / 2;
  }
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, 2, mine, all);
  TEST_FLOATING_EQUALITY(all[0], all[1], tolerance);
  if (s.comm()->getSize() == 1) TEST_COMPARE(mortar, >, 0.9 * all[0]);  // the stones are stiff
}

TEUCHOS_UNIT_TEST(Mortar, UnnamedHoldsNothing) {
  Experiment bare(column(3, JointLawParameters::infinity, JointLawParameters::infinity));
  TEST_ASSERT(bare.model().compliance().empty());
  TEST_EQUALITY(effect_costs(bare.scene(), bare.model()).at("joint stiffness").bytes, 0);
  TEST_ASSERT(!effect_costs(bare.scene(), bare.model()).at("joint stiffness").in_play);
  Experiment laid(column(3, 1e11, JointLawParameters::infinity));
  TEST_ASSERT(effect_costs(laid.scene(), laid.model()).at("joint stiffness").in_play);
  TEST_EQUALITY(laid.model().compliance().size(), static_cast<std::size_t>(laid.model().points().size()));
  TEST_EQUALITY(laid.model().compliance()[0].tangential, 0.0);
}

}  // namespace
