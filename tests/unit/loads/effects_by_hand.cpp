// Loads on edges, of water, of axles and of heat against computations by hand, on any number of ranks.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "loads/ground_motion.hpp"
#include "mesh/curved_edges.hpp"
#include "unit/loads/load_cases.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// Sums of some hundred terms of one sign: 1e-13 is far above their round-off.
constexpr double round_off = 1e-13;

TEUCHOS_UNIT_TEST(PointLoad, ActsOnceAtTheNearestNode) {
  const LoadCase wall;  // 2 m x 1 m
  PointLoadParameters p;
  p.x = 1.01;  // where two stones of the top course meet: four copies of one vertex share it or lie near it
  p.y = 1.0;
  p.fx = 30;
  p.fy = -500;
  const auto r = wall.resultant(p);
  TEST_EQUALITY(r.x, 30.0);
  TEST_EQUALITY(r.y, -500.0);
  TEST_FLOATING_EQUALITY(r.moment, -500 * 1.0 - 30 * 1.0, round_off);  // at (1, 1)
}

TEUCHOS_UNIT_TEST(PointLoad, SaysHowFarTheNearestNodeIs) {
  const LoadCase wall;
  PointLoadParameters p;
  p.x = 1.0;
  p.y = 1.5;
  p.fy = -1;
  p.tolerance = 0.25;
  std::string said;
  try {
    wall.resultant(p);
  } catch (const InputError& error) {
    said = error.what();
  }
  TEST_EQUALITY(said,
                "scene > loads > tested > tolerance = 0.25 [m]\n  is exceeded: the node nearest to (1, 1.5) m is 0.5 m "
                "away.\n  Move the point to the outside of the structure, or give a larger tolerance.");
}

TEUCHOS_UNIT_TEST(Crowd, StandsOnItsPartOfTheEdgeOnly) {
  const LoadCase wall;
  CrowdParameters p;
  p.on = "top";
  p.intensity = 4e3;
  p.x_from = 0.3;  // within a cell at either end
  p.x_to = 1.45;
  const auto r = wall.resultant(p);
  const double total = 4e3 * 1.15 * thickness;
  TEST_EQUALITY(r.x, 0.0);
  TEST_FLOATING_EQUALITY(r.y, -total, round_off);
  TEST_FLOATING_EQUALITY(r.moment, -total * (0.3 + 1.45) / 2, round_off);
}

TEUCHOS_UNIT_TEST(Crowd, WeighsByHorizontalArea) {
  ArchParameters arch;  // 5 m to the middle line, 1 m thick
  arch.voussoirs = 7;
  const LoadCase on_arch(make_arch(arch));
  CrowdParameters p;
  p.on = "extrados";
  p.intensity = 1000;
  TEST_FLOATING_EQUALITY(on_arch.resultant(p).y, -1000 * 11 * thickness, round_off);  // the span, whatever the slope
}

TEUCHOS_UNIT_TEST(EarthPressure, HasCoulombsCoefficients) {
  EarthPressureParameters p;
  p.friction_angle = 30;
  TEST_FLOATING_EQUALITY(p.coefficient(), 0.5, 1e-15);
  p.state = EarthPressureParameters::State::active;
  TEST_FLOATING_EQUALITY(p.coefficient(), 1.0 / 3, 1e-15);
  p.state = EarthPressureParameters::State::passive;
  TEST_FLOATING_EQUALITY(p.coefficient(), 3.0, 1e-15);
}

TEUCHOS_UNIT_TEST(EarthPressure, GrowsWithDepthBelowItsSurface) {
  const LoadCase wall;
  EarthPressureParameters p;
  p.on = "left";
  p.unit_weight = 18e3;
  p.surface = 0.8;  // 0.2 m below the top, within a cell
  p.surcharge = 2e3;
  p.state = EarthPressureParameters::State::active;
  const auto r = wall.resultant(p);
  // A triangle at a third of the depth and a rectangle at its half.
  const double triangle = 18e3 * 0.8 * 0.8 / 2 / 3 * thickness, rectangle = 2e3 * 0.8 / 3 * thickness;
  TEST_FLOATING_EQUALITY(r.x, triangle + rectangle, round_off);
  TEST_EQUALITY(r.y, 0.0);
  TEST_FLOATING_EQUALITY(r.moment, -(triangle * 0.8 / 3 + rectangle * 0.4), round_off);
  p.on = "right";
  TEST_FLOATING_EQUALITY(wall.resultant(p).x, -(triangle + rectangle), round_off);
}

TEUCHOS_UNIT_TEST(WaterPressure, IsDensityGravityDepthAgainstTheNormal) {
  const LoadCase wall;
  WaterPressureParameters p;
  p.on = "left";
  p.level = 0.7;
  const double total = 1000 * 9.81 * 0.7 * 0.7 / 2 * thickness;
  auto r = wall.resultant(p);
  TEST_FLOATING_EQUALITY(r.x, total, round_off);
  TEST_FLOATING_EQUALITY(r.moment, -total * 0.7 / 3, round_off);
  p.on = "base";  // full depth on the whole base: uplift
  r = wall.resultant(p);
  TEST_FLOATING_EQUALITY(r.y, 1000 * 9.81 * 0.7 * 2 * thickness, round_off);
  TEST_COMPARE(std::abs(r.x), <=, round_off * total);
}

TEUCHOS_UNIT_TEST(Buoyancy, IsTheWeightOfTheDisplacedWaterAtTheMiddleOfThePartBelow) {
  for (const auto cells : {CellType::quadrilateral, CellType::triangle}) {
    WallParameters p;
    p.courses = p.blocks_per_course = 4;
    p.cells = cells;
    const LoadCase wall(make_wall(p));
    BuoyancyParameters water;
    water.level = 0.6;  // within a cell
    const double total = 1000 * 9.81 * 2 * 0.6 * thickness;
    const auto r = wall.resultant(water);
    TEST_FLOATING_EQUALITY(r.y, total, round_off);
    TEST_FLOATING_EQUALITY(r.moment, total * 1.0, round_off);
    water.level = -1;
    TEST_EQUALITY(wall.resultant(water).y, 0.0);
    water.level = 5;
    TEST_FLOATING_EQUALITY(wall.resultant(water).y, 1000 * 9.81 * 2 * thickness, round_off);
  }
}

TEUCHOS_UNIT_TEST(Buoyancy, LiftsTheBlocksItNames) {
  const LoadCase wall;
  BuoyancyParameters water;
  water.blocks = "course 1";
  water.level = 5;
  TEST_FLOATING_EQUALITY(wall.resultant(water).y, 1000 * 9.81 * 2 * 0.25 * thickness, round_off);
}

MovingTrainParameters train() {
  MovingTrainParameters p;
  p.on = "top";
  p.axle_load = {1000, 300, 200};
  p.behind = {0, 0.5, 0.75};
  p.position = -0.1;
  p.speed = 2;
  return p;
}

TEUCHOS_UNIT_TEST(MovingTrain, CarriesEachAxleWhereItIsAndNothingBesideTheDeck) {
  const LoadCase wall;
  const auto at = [&](double time) { return wall.resultant(train(), 1.0, time); };
  TEST_EQUALITY(at(0).y, 0.0);  // all three before the deck
  TEST_EQUALITY(at(0.1).y, -1000.0);
  TEST_FLOATING_EQUALITY(at(0.1).moment, -1000 * 0.1, round_off);
  TEST_FLOATING_EQUALITY(at(0.5).y, -1500.0, round_off);
  TEST_FLOATING_EQUALITY(at(0.5).moment, -(1000 * 0.9 + 300 * 0.4 + 200 * 0.15), round_off);
  TEST_FLOATING_EQUALITY(at(1.2).moment, -(300 * 1.8 + 200 * 1.55), round_off);  // the first has left
  TEST_EQUALITY(at(2).y, 0.0);
}

// Where two stones meet the axle stands on one of them, not on both.
TEUCHOS_UNIT_TEST(MovingTrain, ActsOnceAtEveryNodeOfTheDeck) {
  const LoadCase wall;
  MovingTrainParameters p = train();
  p.axle_load = {1000};
  p.behind = {0};
  p.speed = 0;
  for (int k = 0; k <= 16; ++k) {
    p.position = k * 0.125;
    TEST_EQUALITY(wall.resultant(p).y, -1000.0);
  }
}

TEUCHOS_UNIT_TEST(MovingTrain, FollowsItsFirstAxleAgainstItsDirection) {
  const LoadCase wall;
  MovingTrainParameters p = train();
  p.position = 1.0;
  p.speed = -2;
  TEST_FLOATING_EQUALITY(wall.resultant(p).moment, -(1000 * 1.0 + 300 * 1.5 + 200 * 1.75), round_off);
}

TEUCHOS_UNIT_TEST(GroundMotion, IsInertiaAgainstTheAccelerationOfTheGround) {
  const LoadCase wall;
  const double mass = density * 2 * 1 * thickness;
  const std::string file = "ground_motion.csv";
  if (everyone()->getRank() == 0) std::ofstream(file) << "t [s], a [g]\n0, 0\n1, 0.2\n3, -0.2\n";
  GroundMotionParameters p;
  p.record_x = file;
  p.unit = AccelerationUnit::g;
  p.ay = 0.5;
  const auto r = wall.resultant(p, 0.5, 1.5);
  TEST_FLOATING_EQUALITY(r.x, -0.5 * mass * 0.1 * 9.80665, round_off);
  TEST_FLOATING_EQUALITY(r.y, -0.5 * mass * 0.5, round_off);
  TEST_EQUALITY(wall.resultant(p, 1.0, 3.5).x, 0.0);  // the record is over
  TEST_INEQUALITY(wall.made(p)->remark().find("the ground ends at"), std::string::npos);
  const auto warnings = wall.made(p)->warnings();
  TEST_EQUALITY(warnings.size(), 1u);
  TEST_EQUALITY(warnings[0].what, "record_ends_moving");
  // Velocities 0.1 and 0.1 g s at 1 and 3 s: it moves as fast as ever.
  TEST_EQUALITY(warnings[0].how_much, 1.0);
  p.corrected = true;
  TEST_EQUALITY(wall.made(p)->warnings().size(), 0u);
  TEST_EQUALITY(wall.made(p)->resolution(), 0.75);  // two intervals of 1.5 s in the mean, two steps in each
}

TEUCHOS_UNIT_TEST(GroundMotion, BringsTheGroundBackWhereTheBaselineIsCorrected) {
  const PiecewiseLinear record({0, 1, 2.5, 4}, {0, 3, -1, 0.5});
  // By hand: velocities 1.5, 3, 2.625; displacements 0.5, 4.625, 8.5625.
  const auto drift = drift_of(record);
  TEST_FLOATING_EQUALITY(drift.velocity, 2.625, 1e-14);
  TEST_FLOATING_EQUALITY(drift.displacement, 8.5625, 1e-14);
  TEST_FLOATING_EQUALITY(drift.peak_velocity, 3.0, 1e-14);
  const auto corrected = drift_of(with_corrected_baseline(record));
  TEST_COMPARE(std::abs(corrected.velocity), <=, 1e-14);  // some ten operations on numbers near 1
  TEST_COMPARE(std::abs(corrected.displacement), <=, 1e-13);
}

TEUCHOS_UNIT_TEST(GroundMotion, LeavesARecordSilentWhereItIs) {
  const PiecewiseLinear record({0, 1, 2, 3.5, 4, 5, 6, 7, 8}, {0, 0, 0, 2, -1, 3, 0, 0, 0});
  const auto corrected = with_corrected_baseline(record);
  for (const std::size_t k : {0, 1, 7, 8}) TEST_EQUALITY(corrected.value()[k], 0.0);
  const auto drift = drift_of(corrected);
  TEST_COMPARE(std::abs(drift.velocity), <=, 1e-14);
  TEST_COMPARE(std::abs(drift.displacement), <=, 1e-13);
  TEST_INEQUALITY(corrected.value()[4], -1.0);
  const PiecewiseLinear silent({0, 1, 2}, {0, 0, 0});
  TEST_COMPARE_ARRAYS(with_corrected_baseline(silent).value(), silent.value());
  const auto peak = drift_of(with_corrected_baseline({{0, 1, 2}, {0, 1, 0}}));  // one value that is not zero
  TEST_COMPARE(std::abs(peak.velocity), <=, 1e-14);
  TEST_COMPARE(std::abs(peak.displacement), <=, 1e-14);
}

TEUCHOS_UNIT_TEST(GroundMotion, IsTheSameInEveryUnitAndColumn) {
  const LoadCase wall;
  const auto written = [](const std::string& file, const std::string& text) {
    if (everyone()->getRank() == 0) std::ofstream(file) << text;
    return file;
  };
  const auto force = [&](AccelerationUnit unit, const std::string& text, int time_column = 0, int column = 0) {
    GroundMotionParameters p;
    p.record_x = written("ground_motion_units.csv", text);
    p.unit = unit;
    p.layout.time_column = time_column;
    p.column_x = column;
    everyone()->barrier();
    return wall.resultant(p, 1, 1).x;
  };
  const double one = -density * 2 * 1 * thickness;  // of 1 m/s2
  TEST_FLOATING_EQUALITY(force(AccelerationUnit::m_per_s2, "0 0\n1 1\n"), one, round_off);
  TEST_FLOATING_EQUALITY(force(AccelerationUnit::cm_per_s2, "0 0\n1 100\n"), one, round_off);
  TEST_FLOATING_EQUALITY(force(AccelerationUnit::gal, "0 0\n1 100\n"), one, round_off);
  TEST_FLOATING_EQUALITY(force(AccelerationUnit::mm_per_s2, "0 0\n1 1000\n"), one, round_off);
  TEST_FLOATING_EQUALITY(force(AccelerationUnit::g, "0 0\n1 1\n"), 9.80665 * one, round_off);
  TEST_FLOATING_EQUALITY(force(AccelerationUnit::m_per_s2, "0 7 0\n1 8 1\n", 1, 3), one, round_off);
  TEST_THROW(force(AccelerationUnit::m_per_s2, "0 0 0\n1 1 1\n"), InputError);
}

TEUCHOS_UNIT_TEST(GroundMotion, SaysWhatItsFileLeavesOpen) {
  const LoadCase wall;
  const auto kinds = [&](const std::string& text, double scale = 1) {
    if (everyone()->getRank() == 0) std::ofstream("ground_motion_doubts.csv") << text;
    GroundMotionParameters p;
    p.record_x = "ground_motion_doubts.csv";
    p.scale = scale;
    everyone()->barrier();
    std::vector<std::string> all;
    for (const auto& warning : wall.made(p)->warnings()) all.push_back(warning.what);
    return all;
  };
  // Velocities 0.5, 0, -0.5, 0 at rest in the end and back: 0 = + - - +.
  const std::string at_rest = "0 0\n1 1\n2 -1\n3 -1\n4 1\n5 0\n";
  TEST_EQUALITY(kinds(at_rest).size(), 0u);
  TEST_COMPARE_ARRAYS(kinds("0 0\n1 1\n2 0\n"), std::vector<std::string>{"record_ends_moving"});
  TEST_COMPARE_ARRAYS(kinds("0 0\n1 1\n2 0\n3 -1\n4 0\n"), std::vector<std::string>{"record_ends_moving"});  // away
  TEST_COMPARE_ARRAYS(kinds("t [s], a [cm/s2]\n" + at_rest), std::vector<std::string>{"record_unit"});
  TEST_EQUALITY(kinds("t [s], a [cm/s2]\n" + at_rest, 0.01).size(), 0u);  // converted by its scale
  std::string numbered;
  for (int k = 1; k <= 40; ++k) numbered += std::to_string(k) + " 0\n";
  TEST_COMPARE_ARRAYS(kinds(numbered), std::vector<std::string>{"row_numbers"});
}

// The forces of a block that may expand freely are those that its stiffness answers with exactly its free expansion.
TEUCHOS_UNIT_TEST(Temperature, ForcesAreTheStiffnessTimesTheFreeExpansion) {
  for (const auto plane : {Plane::stress, Plane::strain}) {
    const LoadCase wall(plane);
    TemperatureParameters p;
    p.blocks = "course 2";
    p.change = 30;
    p.expansion = 1e-5;
    const auto load = wall.made(p);
    BlockForces all(wall.s());
    const auto& force = all.of_nodes;
    std::vector<double> none(force.size(), 0.0), strain(wall.s().blocks().size(), 0.0), answer;
    load->add({{0, 0.5}}, all, none);
    load->add_free_strain(0.5, strain);
    std::vector<double> u(force.size());
    for (int i = 0; i < wall.s().nodes(); ++i)
      for (int c = 0; c < 2; ++c) u[2 * i + c] = strain[wall.s().block_of_node()[i]] * wall.s().position()[i][c];
    wall.s().apply_stiffness(u, answer);
    double largest = 0, wrong = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      largest = std::max(largest, std::abs(force[i]));
      wrong = std::max(wrong, std::abs(force[i] - answer[i]));
    }
    TEST_COMPARE(wrong, <=, 1e-12 * largest);                                    // sums of eight products a row
    const double free = 0.5 * 30 * 1e-5 * (plane == Plane::strain ? 1.2 : 1.0);  // nu = 0.2
    TEST_FLOATING_EQUALITY(*std::max_element(strain.begin(), strain.end()), free, 1e-15);
    TEST_EQUALITY(*std::min_element(strain.begin(), strain.end()), 0.0);  // the other courses stay cold
  }
}

/// Of forces on the stones of a structure: what they add up to at most, their moment and their sum of arms times forces
/// about the centre of mass, which a turn of the stone makes a moment of.
struct OnStones {
  double force = 0, moment = 0, virial = 0, size = 0;

  OnStones(const Structure<2>& s, const std::vector<double>& nodal) {
    const auto volume = s.nodal_volumes();
    for (int b = 0; b < s.owned_blocks(); ++b) {
      const auto& block = s.blocks()[b];
      Vector<2> centre{}, sum{};
      double all = 0, turns = 0;
      std::array<Vector<2>, 2> arms{};
      for (int n = block.first_local; n < block.first_local + block.nodes; ++n) {
        centre = centre + volume[n] * s.position()[n];
        all += volume[n];
      }
      for (int n = block.first_local; n < block.first_local + block.nodes; ++n) {
        const Vector<2> f{nodal[2 * n], nodal[2 * n + 1]}, arm = s.position()[n] - (1 / all) * centre;
        sum = sum + f;
        turns += cross(arm, f);
        for (int a = 0; a < 2; ++a) arms[a] = arms[a] + arm[a] * f;
        size = std::max(size, norm(f));
      }
      force = std::max(force, norm(sum));
      moment = std::max(moment, std::abs(turns));
      virial = std::max({virial, norm(arms[0]), norm(arms[1])});
    }
  }
};

// Weight acts in the centres of stones: no turn of a stone makes a moment of it. What edges that bend hand over of it
// is in balance on each stone, as the forces of heat are.
TEUCHOS_UNIT_TEST(TurningLoads, AreInBalanceOnEachStoneAndLeaveWhatKeepsItsDirection) {
  WallParameters p;
  p.courses = p.blocks_per_course = 2;
  p.cells = CellType::quadratic_triangle;
  const LoadCase wall(with_curved_edges(make_wall(p)));
  TemperatureParameters heat;
  heat.change = 20;
  BuoyancyParameters water;
  water.level = 0.6;
  const std::map<std::string, double> factors{{"tested", 0.75}};
  const auto of = [&](const auto& parameters, bool all) {
    const auto loads = wall.at_work(parameters);
    const auto turning = loads.turning({0, 0, factors, factors}, wall.s());
    TEST_ASSERT(!turning.empty());
    BlockForces on_blocks(wall.s());
    std::vector<double> none(turning.size(), 0.0);
    loads.add(factors, 0, on_blocks, none);
    auto force = handed_over(wall.s(), on_blocks);
    const OnStones inner(wall.s(), turning);
    TEST_COMPARE(inner.size, >, 0);
    TEST_COMPARE(inner.force, <=, 1e-10 * inner.size);  // of solves with the stiffness of edges
    TEST_COMPARE(inner.moment, <=, 1e-10 * inner.size);
    for (std::size_t i = 0; i < force.size(); ++i) force[i] -= turning[i];
    const OnStones rest(wall.s(), force);
    if (all) TEST_COMPARE(rest.virial, <=, 1e-10 * std::max(inner.size, rest.size));
  };
  of(heat, true);
  of(SelfWeightParameters(), true);
  of(water, false);  // what is cut by the level is lifted beside its centre
  LoadCase linear;
  TEST_ASSERT(linear.at_work(SelfWeightParameters()).turning({0, 0, factors, factors}, linear.s()).empty());
}

}  // namespace
