// Four hexahedral stones in space through selection, estimate, release and recorder, in statics and in time.
//
// Set-up    Cubes of 1 m on top of each other under weight W each. Statics: all are pushed along x and y by 0.096 and
//           0.064 of their weight. Bed k carries m = 3 - k stones, whose force passes m / 2 (0.096, 0.064) m off its
//           middle. The core of a square of 4 x 4 points with their shares of the area ends where x + y = 11/54 m, so
//           the corner away from the push opens at the lowest bed alone.
//           Time: the topmost stone slides by a given velocity, or flies.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "linalg/reduce.hpp"
#include "results/largest_mover.hpp"
#include "results/recorder.hpp"
#include "results/support_reactions.hpp"
#include "run/appraisal.hpp"
#include "step/adaptive_step.hpp"
#include "support/stack_in_space.hpp"
#include "time/dynamic_step.hpp"
#include "unit/output/folders.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double push_x = 0.096, push_y = 0.064;  // [-] of the weight, 0.115 together
const Vector<3> pushed{push_x * stack_gravity, push_y* stack_gravity, -stack_gravity};

/// What passes through a bed, on the upper stone, the same on every rank.
struct Bed {
  Vector<3> force{};    ///< [N]
  double x = 0, y = 0;  ///< [m] where the normal force passes, from the middle
  long long selected = 0, open = 0;
};

struct Stack {
  Scene scene;
  std::unique_ptr<BlockSource<3>> source = stack_of_cubes();
  SpaceModel model;
  AdaptiveStep step;
  ContactState state;
  std::vector<double> load, prescribed;

  explicit Stack(double friction, SelectionMode mode, const Vector<3>& velocity = {})
      : Stack(stack_scene(friction, mode, velocity)) {}
  explicit Stack(Scene s)
      : scene(std::move(s)), model(scene, *source, Tpetra::getDefaultComm()), step(model), state(step.initial_state()) {
    model.loads({}, 0.0, load, prescribed);
  }
  StepReport stand(const Vector<3>& acceleration) {
    model.loads({{"x", acceleration[0]}, {"y", acceleration[1]}, {"z", acceleration[2]}}, 0.0, load, prescribed);
    return advance(step, state, {load, prescribed});
  }
  Bed bed(int lower) const {
    std::array<double, 7> mine{};
    const auto gap = step.gaps(state.displacement);
    for (int k = 0; k < model.points().owned(); ++k) {
      if (model.points().joint_of(k).block_i != lower) continue;
      const auto& p = model.points().points()[k];
      const auto x = model.points().at(k).place(Side::i, model.structure());
      for (int c = 0; c < 3; ++c)
        for (int a = 0; a < 3; ++a) mine[c] += state.lambda[3 * k + a] * p.axis[a][c];
      const double normal = state.lambda[3 * k] * p.axis[0][2];
      mine[3] += normal * (x[0] - 0.5);
      mine[4] += normal * (x[1] - 0.5);
      mine[5] += state.selected[k];
      mine[6] += state.selected[k] && state.lambda[3 * k] == 0 && gap[3 * k] > 0;
    }
    const auto all = total_of_each(*model.structure().comm(), mine);
    return {{all[0], all[1], all[2]}, all[3] / all[2], all[4] / all[2], std::lround(all[5]), std::lround(all[6])};
  }
  /// Mean of a field on the nodes of a stone by their masses, the same on every rank.
  Vector<3> mean(const std::vector<double>& field, int stone) const {
    const auto volume = model.structure().nodal_volumes();
    std::array<double, 3> mine{};
    for (int n = 0; n < model.structure().owned_nodes(); ++n) {
      if (model.structure().blocks()[model.structure().block_of_node()[n]].mesh.id != stone) continue;
      for (int c = 0; c < 3; ++c) mine[c] += volume[n] * field[3 * n + c];
    }
    return total_of_each(*model.structure().comm(), mine);
  }
};

void check_statics(const Stack& stack, Teuchos::FancyOStream& out, bool& success) {
  const double round_off = 1e-5 * stack_weight;
  for (int lower = 0; lower < stones_of_stack - 1; ++lower) {
    const double above = stones_of_stack - 1 - lower;
    const auto bed = stack.bed(lower);
    out << "bed " << lower << ": force " << bed.force[0] << " " << bed.force[1] << " " << bed.force[2] << " N at "
        << bed.x << ", " << bed.y << " m, " << bed.selected << " points selected, " << bed.open << " open\n";
    TEST_COMPARE(std::abs(bed.force[0] + push_x * above * stack_weight), <, round_off);
    TEST_COMPARE(std::abs(bed.force[1] + push_y * above * stack_weight), <, round_off);
    TEST_COMPARE(std::abs(bed.force[2] - above * stack_weight), <, round_off);
    TEST_COMPARE(std::abs(bed.x - push_x * above / 2), <, 1e-5);
    TEST_COMPARE(std::abs(bed.y - push_y * above / 2), <, 1e-5);
    TEST_EQUALITY(bed.open > 0, above * (push_x + push_y) / 2 > 11.0 / 54);
  }
}

TEUCHOS_UNIT_TEST(StackInSpace, BearsWhatStaticsSayAndOpensWhereTensionWouldBe) {
  Stack adaptive(0.6, SelectionMode::adaptive), all(0.6, SelectionMode::all);
  const auto report = adaptive.stand(pushed);
  TEST_ASSERT(report.converged());
  TEST_ASSERT(all.stand(pushed).converged());
  TEST_COMPARE(report.selection_rounds, >=, 1);  // something was released
  check_statics(adaptive, out, success);
  check_statics(all, out, success);
  TEST_EQUALITY(adaptive.bed(0).selected, 16);
  TEST_EQUALITY(adaptive.bed(1).selected + adaptive.bed(2).selected, 0);  // they are pressed all over
  // The adaptive stack is soft where the other is: the topmost stone leans as far.
  const auto there = adaptive.mean(adaptive.state.displacement, 3), here = all.mean(all.state.displacement, 3);
  TEST_COMPARE(norm(there - here), <, 0.02 * norm(here));
}

TEUCHOS_UNIT_TEST(StackInSpace, SupportsBearTheWeightOnTheLineOfTheLoads) {
  Stack stack(0.6, SelectionMode::adaptive);
  TEST_ASSERT(stack.stand(pushed).converged());
  const Appraisal appraisal(stack.model);
  const auto statics = appraisal.statics(stack.step, stack.state, stack.load, "");
  TEST_EQUALITY(statics.components, 3);
  const auto& foot = statics.reactions.at("foot");
  const Vector<3> all = (4 * stack_weight / stack_gravity) * pushed;
  TEST_COMPARE(norm(foot.force + all), <, 1e-5 * stack_weight);
  // All loads pass through the mass centre; of their line the place nearest to the middle of the foot.
  const Vector<3> centre{0.5, 0.5, 2}, middle{0.5, 0.5, 0}, along = (1 / norm(pushed)) * pushed;
  const auto place = centre + dot(middle - centre, along) * along;
  TEST_COMPARE(norm(foot.through - place), <, 1e-5);
  TEST_EQUALITY(largest_mover(stack.model, stack.state.displacement).largest_mover, 3);
}

// What is pushed by more than its friction bears has no equilibrium: the adaptive stack must not stand on its ties.
TEUCHOS_UNIT_TEST(StackInSpace, FallsWhereFrictionIsTooLittle) {
  Stack stack(0.112, SelectionMode::adaptive);
  const auto report = stack.stand(pushed);
  TEST_ASSERT(!report.converged());
  Stack stands(0.119, SelectionMode::adaptive);
  TEST_ASSERT(stands.stand(pushed).converged());
}

/// The last line of a table, by the names of its columns.
std::map<std::string, double> last_row(const std::string& path) {
  std::ifstream file(path);
  std::string heading, line, last;
  std::getline(file, heading);
  while (std::getline(file, line)) last = line;
  std::istringstream names(heading), values(last);
  std::map<std::string, double> row;
  for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');)
    row[name] = std::strtod(value.c_str(), nullptr);
  return row;
}

TEUCHOS_UNIT_TEST(StackInSpace, IsRecordedWithItsReactionsAndItsEnergy) {
  auto scene = stack_scene(0.6, SelectionMode::adaptive);
  ObservationParameters under, top;
  under.place = ObservationParameters::Place::support;
  under.support = "foot";
  top.place = ObservationParameters::Place::mean;
  top.blocks = "top";
  scene.observations = {{"ground", under}, {"crown", top}};
  Stack stack(scene);
  const auto folder = fresh_folder("stack-in-space");
  Recorder recorder(stack.scene, stack.model, stack.step, folder);
  for (const double share : {0.5, 1.0}) {
    const auto before = stack.state;
    const auto load_before = stack.load;
    const LoadStepBook book(stack.model, stack.step, before, load_before);
    const auto report = stack.stand(share * pushed);
    TEST_ASSERT(report.converged());
    recorder.record(book, stack.state, stack.load, report, "push", share, true, 0.0);
  }
  world()->barrier();
  const auto row = last_row(folder + "/history.csv");
  TEST_COMPARE(std::abs(row.at("fz_N of ground") - 4 * stack_weight), <, 1e-5 * stack_weight);
  TEST_COMPARE(std::abs(row.at("fx_N of ground") + 4 * push_x * stack_weight), <, 1e-5 * stack_weight);
  TEST_FLOATING_EQUALITY(row.at("uy_m of crown"), stack.mean(stack.state.displacement, 3)[1], 1e-6);
  const auto& sum = recorder.summary();
  TEST_EQUALITY(sum.blocks, 4);
  TEST_EQUALITY(sum.unknowns, 3 * sum.nodes);
  TEST_EQUALITY(sum.open_points, stack.bed(0).open);
  // Nothing slips, so that what loads do is in the stones but for what opens within a step.
  TEST_COMPARE(sum.energy.elastic, >, 0);
  TEST_FLOATING_EQUALITY(sum.energy.elastic, sum.energy.external_work, 0.05);
}

/// Time steps under weight alone, from where the stack stands.
struct Moving {
  Stack stack;
  DynamicStep dynamics;
  TimeStepReport last;
  double kinetic = 0, begun = 0;  ///< [J] given at the start; with what is in the stones then
  double friction = 0, work = 0;  ///< [J] taken by friction; of the weight

  Moving(const Vector<3>& velocity, double mu, double time_step)
      : stack(standing(mu, velocity)), dynamics(stack.model) {
    if (!stack.stand({0, 0, -stack_gravity}).converged()) throw std::runtime_error("no equilibrium");
    kinetic = dynamics.begin(stack.state);
    begun = kinetic + stack.model.structure().elastic_energy(stack.state.displacement);
    dynamics.set_time_step(time_step);
  }
  static Stack standing(double mu, const Vector<3>& velocity) { return Stack(mu, SelectionMode::adaptive, velocity); }
  bool go(int steps) {
    for (int k = 0; k < steps; ++k) {
      last = advance(dynamics, stack.state, {stack.load, stack.prescribed});
      if (!last.step.converged()) return false;
      friction += last.friction;
      work += last.external_work;
    }
    return true;
  }
};

// Newton: v = v0 - mu g t along the way of the stone, whatever its direction; friction takes what it loses.
TEUCHOS_UNIT_TEST(StackInSpace, AStoneThatSlidesInTimeIsHeldBackByItsFriction) {
  constexpr double mu = 0.2, time_step = 2.5e-3, seconds = 0.05, speed = 0.5;
  Moving moving({0.6 * speed, 0.8 * speed, 0}, mu, time_step);
  TEST_FLOATING_EQUALITY(moving.kinetic, 2000 * speed * speed / 2, 1e-10);
  const auto before = moving.stack.mean(moving.stack.state.displacement, 3);
  TEST_ASSERT(moving.go(static_cast<int>(std::lround(seconds / time_step))));
  const auto v = moving.stack.mean(moving.stack.state.velocity, 3);
  const auto way = moving.stack.mean(moving.stack.state.displacement, 3) - before;
  const double slower = speed - mu * stack_gravity * seconds;
  const double gone = speed * seconds - mu * stack_gravity * seconds * seconds / 2;
  out << "speed " << v[0] << " " << v[1] << " " << v[2] << ", expected " << slower << "; way " << way[0] << " "
      << way[1] << ", expected " << gone << "; friction " << moving.friction << " J, expected "
      << mu * stack_weight * gone << "\n";
  TEST_COMPARE(std::abs(v[0] - 0.6 * slower), <, 0.02 * speed);
  TEST_COMPARE(std::abs(v[1] - 0.8 * slower), <, 0.02 * speed);
  TEST_COMPARE(std::abs(way[0] - 0.6 * gone), <, 0.02 * gone);
  TEST_COMPARE(std::abs(way[1] - 0.8 * gone), <, 0.02 * gone);
  // What friction does not take of the loss shakes the stack below, which it shears.
  TEST_COMPARE(std::abs(moving.friction - mu * stack_weight * gone), <, 0.1 * mu * stack_weight * gone);
  const double left = moving.last.kinetic + moving.last.elastic + moving.friction;
  TEST_COMPARE(std::abs(moving.begun + moving.work - left), <, 1e-6 * moving.begun);
}

// A stone that is thrown up flies as a mass does, and falls again: the beds below it are none of its business.
TEUCHOS_UNIT_TEST(StackInSpace, AStoneThatIsThrownFliesFreely) {
  constexpr double time_step = 5e-3, seconds = 0.1;
  const Vector<3> thrown{0.2, -0.1, 1.0};
  Moving moving(thrown, 0.6, time_step);
  const auto before = moving.stack.mean(moving.stack.state.displacement, 3);
  TEST_ASSERT(moving.go(static_cast<int>(std::lround(seconds / time_step))));
  const Vector<3> fallen{0, 0, -stack_gravity};
  const auto v = thrown + seconds * fallen, way = seconds * thrown + (seconds * seconds / 2) * fallen;
  TEST_COMPARE(norm(moving.stack.mean(moving.stack.state.velocity, 3) - v), <, 1e-6);
  TEST_COMPARE(norm(moving.stack.mean(moving.stack.state.displacement, 3) - before - way), <, 1e-7);
  TEST_EQUALITY(moving.stack.bed(2).selected, moving.stack.bed(2).open);
}

}  // namespace
