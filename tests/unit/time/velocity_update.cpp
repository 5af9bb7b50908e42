// Velocities after joints have closed: what impulses must keep and what they must end.
//
// Set-up    Two courses of a wall that float in space: the upper one flies down onto the lower one, 1 m/s, or along it.
#include "time/velocity_update.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "blocks/assembly.hpp"
#include "model/plane/plane_model.hpp"
#include "support/scenes.hpp"
#include "unit/time/floating_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double time_step = 1e-4;  // [s]
constexpr double resting = 1e-6;    // [m/s]

class Flight {
 public:
  Flight()
      : experiment_(in_flight(wall_scene(2))),
        at_rest_(experiment_.model()),
        mass_(at_rest_.structure().with_matrices([this](int b) {
          const auto& block = at_rest_.structure().blocks()[b];
          return block_mass(block.mesh, block.material.density, 1.0, Mass::consistent);
        })),
        step_(at_rest_.of_time_step(mass_, MidpointRule{time_step, 0, 0}, 1e-11)),
        update_(at_rest_, mass_),
        state(experiment_.state()) {
    state.velocity.assign(state.displacement.size(), 0.0);
    std::fill(state.selected.begin(), state.selected.end(), 1);
  }

  /// Velocity of the blocks of the upper course; every bed joint presses with 1000 N.
  void push_upper_course(double vx, double vy) {
    const auto& s = at_rest_.structure();
    for (const auto& b : s.blocks()) {
      double height = 0;
      for (const auto& x : b.mesh.position) height = std::max(height, x[1]);
      if (height < 0.3) continue;  // courses are 0.25 m high
      for (std::size_t i = 0; i < b.mesh.position.size(); ++i) {
        state.velocity[2 * (b.first_local + i)] = vx;
        state.velocity[2 * (b.first_local + i) + 1] = vy;
      }
    }
    for (int k = 0; k < at_rest_.points().size(); ++k)
      if (bed(k)) state.lambda[2 * k] = 1000;
  }
  /// Ties all points of bed joints, as they move.
  void tie_beds() {
    for (int k = 0; k < at_rest_.points().size(); ++k) state.selected[k] = !bed(k);
  }
  double settle() { return update_.settle(state, resting).friction; }
  bool calm(double energy) const {
    const auto all = update_.calm(state, energy, resting);
    const bool mine = std::all_of(all.begin(), all.end(), [](char is_calm) { return is_calm != 0; });
    int everywhere = 0;
    Teuchos::reduceAll(*mass_.comm(), Teuchos::REDUCE_MIN, static_cast<int>(mine), Teuchos::outArg(everywhere));
    return everywhere != 0;
  }
  double apply() { return update_.apply(*step_, state, 0.0, resting, {time_step, 0.0}).friction; }

  bool bed(int k) const { return std::abs(at_rest_.points().points()[k].axis[0][1]) > 0.5; }
  /// Largest relative velocity at bed points, normal (0) or tangential (1) [m/s].
  double relative(int axis) const {
    double mine = 0, all = 0;
    for (int k = 0; k < at_rest_.points().size(); ++k) {
      const double speed = at_rest_.points().at(k).motion(state.velocity)[axis];
      if (bed(k)) mine = std::max(mine, std::abs(speed));
    }
    Teuchos::reduceAll(*mass_.comm(), Teuchos::REDUCE_MAX, mine, Teuchos::outArg(all));
    return all;
  }
  double kinetic_energy() const { return update_.kinetic_energy(state.velocity); }
  /// Momentum along x and y, moment of momentum about the origin.
  std::array<double, 3> momentum() const {
    std::vector<double> mv;
    mass_.apply_stiffness(state.velocity, mv);
    std::array<double, 3> mine{}, all{};
    for (int i = 0; i < mass_.owned_nodes(); ++i) {
      const auto& x = mass_.position()[i];
      mine[0] += mv[2 * i];
      mine[1] += mv[2 * i + 1];
      mine[2] += x[0] * mv[2 * i + 1] - x[1] * mv[2 * i];
    }
    Teuchos::reduceAll(*mass_.comm(), Teuchos::REDUCE_SUM, 3, mine.data(), all.data());
    return all;
  }

 private:
  Experiment experiment_;
  const PlaneModel& at_rest_;
  Structure<2> mass_;
  std::unique_ptr<Model> step_;
  VelocityUpdate update_;

 public:
  ContactState& state;
};

TEUCHOS_UNIT_TEST(VelocityUpdate, AnImpactEndsTheApproachAndKeepsEnergyAndMomentum) {
  Flight wall;
  wall.push_upper_course(0, -1);
  TEST_FLOATING_EQUALITY(wall.relative(0), 1.0, 1e-12);
  const double energy = wall.kinetic_energy();
  const auto momentum = wall.momentum();
  const double lost = wall.apply();
  // Velocities are projected to 1e-11.
  TEST_COMPARE(wall.relative(0), <, 1e-8);
  // What friction takes of the shear that comes with the blow is told, the rest is kept by construction.
  TEST_COMPARE(lost, >=, 0);
  TEST_FLOATING_EQUALITY(wall.kinetic_energy() + lost, energy, 1e-10);
  for (int c = 0; c < 3; ++c)  // linear solves to 1e-8
    TEST_COMPARE(std::abs(wall.momentum()[c] - momentum[c]), <, 1e-6 * std::abs(momentum[1]));
}

TEUCHOS_UNIT_TEST(VelocityUpdate, PointsThatStickLoseTheirSlidingToFriction) {
  Flight wall;
  wall.push_upper_course(1, 0);  // pressed together, but without shear: inside the cone
  const double energy = wall.kinetic_energy();
  const auto momentum = wall.momentum();
  const double lost = wall.apply();
  TEST_COMPARE(wall.relative(1), <=, resting);
  TEST_COMPARE(lost, >, 0);
  TEST_FLOATING_EQUALITY(wall.kinetic_energy() + lost, energy, 1e-10);
  for (int c = 0; c < 3; ++c) TEST_COMPARE(std::abs(wall.momentum()[c] - momentum[c]), <, 1e-6 * std::abs(momentum[0]));
}

// Otherwise the two sides of a tie swing against each other from step to step, and every step looks like an impact.
TEUCHOS_UNIT_TEST(VelocityUpdate, TiedPointsLoseTheirRelativeVelocityToFriction) {
  Flight wall;
  wall.push_upper_course(0.5, 1);
  wall.tie_beds();
  const double energy = wall.kinetic_energy();
  const auto momentum = wall.momentum();
  const double lost = wall.settle();
  TEST_COMPARE(std::max(wall.relative(0), wall.relative(1)), <, 1e-10);
  TEST_COMPARE(lost, >, 0.05 * energy);  // mass is local: the nodes at the joints stop, the stones go on
  TEST_FLOATING_EQUALITY(wall.kinetic_energy() + lost, energy, 1e-12);
  for (int c = 0; c < 3; ++c) TEST_COMPARE(std::abs(wall.momentum()[c] - momentum[c]), <, 1e-9 * std::abs(momentum[1]));
  // What is left is round-off, and stays as it is: conjugate gradients would leave the singular system by it.
  const auto before = wall.state.velocity;
  TEST_EQUALITY(wall.settle(), 0);
  TEST_COMPARE_ARRAYS(wall.state.velocity, before);
}

TEUCHOS_UNIT_TEST(VelocityUpdate, APointIsCalmWhenItsRelativeMotionIsLittleEnergy) {
  Flight wall;
  TEST_ASSERT(wall.calm(0));
  wall.push_upper_course(0, 0.1);
  TEST_ASSERT(!wall.calm(1e-9));
  TEST_ASSERT(wall.calm(1e9));
}

TEUCHOS_UNIT_TEST(VelocityUpdate, LeavesWhatMovesAsOneOrDoesNotPress) {
  Flight wall;
  wall.push_upper_course(1, 2);
  std::fill(wall.state.lambda.begin(), wall.state.lambda.end(), 0.0);
  auto before = wall.state.velocity;
  TEST_EQUALITY(wall.apply(), 0);
  TEST_COMPARE_ARRAYS(wall.state.velocity, before);
  wall.push_upper_course(0, 0);
  std::fill(wall.state.velocity.begin(), wall.state.velocity.end(), 3.0);
  before = wall.state.velocity;
  TEST_EQUALITY(wall.apply(), 0);
  TEST_COMPARE_ARRAYS(wall.state.velocity, before);
}

}  // namespace
