// A scene of xml/ moved through its stages in process, watched after every time step.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "dynamics/energy_book.hpp"
#include "dynamics/load_steps.hpp"
#include "mesh/block_source.hpp"
#include "model/plane/plane_model.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir::test {

class Motion {
 public:
  /// @param overrides  "path=value" as on the command line
  Motion(const std::string& scene, const std::vector<std::string>& overrides)
      : scene_(read_scene(repository("/xml/") + scene + ".xml", overrides)),
        source_(make_block_source<2>(scene_.mesh, *Tpetra::getDefaultComm())),
        model_(scene_, *source_, Tpetra::getDefaultComm()),
        load_step_(model_),
        state_(load_step_.initial_state()) {}
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;

  /// All stages with their fixed time steps; false when a step does not converge.
  bool run(const std::function<void()>& watch) {
    LoadSteps steps(scene_.stages, scene_.load_steps);
    DynamicStep in_time(model_);
    std::vector<double> load, prescribed;
    while (!steps.finished()) {
      if (!steps.dynamic()) {
        model_.loads(steps.factors(), 0.0, load, prescribed);
        if (!advance(load_step_, state_, {load, prescribed}).converged()) return false;
        book_static();
        steps.accept();
        continue;
      }
      if (state_.velocity.empty()) book_.give(in_time.begin(state_));
      const double time_step = steps.stage_parameters().time_step;
      steps.set_time_step(time_step);
      in_time.set_time_step(time_step);
      loads_of_time_step(model_, steps, load, prescribed);
      report = advance(in_time, state_, {load, prescribed});
      if (report.step.newton.outcome != NewtonOutcome::converged) return false;
      steps.accept();
      time = steps.time();
      book_.advance(
          {report.elastic, report.kinetic, report.external_work, report.friction, report.fracture, report.damping},
          true);
      largest_energy = std::max(largest_energy, report.elastic + report.kinetic);
      largest_imbalance = std::max(largest_imbalance, std::abs(book_.imbalance_in_time()));
      least_friction = std::min(least_friction, report.friction);
      watch();
    }
    return true;
  }

  /// Mean displacement of the nodes of a block at x (both components within 1e-9 m), or of all where `at` says so. One
  /// rank.
  Vector<2> displacement(BlockId block, const std::function<bool(const Vector<2>&)>& at) const {
    Vector<2> sum{};
    int count = 0;
    const auto& s = model_.structure();
    for (const auto& b : s.blocks())
      for (std::size_t i = 0; b.mesh.id == block && i < b.mesh.position.size(); ++i)
        if (at(b.mesh.position[i])) {
          for (int c = 0; c < 2; ++c) sum[c] += state_.displacement[2 * (b.first_local + i) + c];
          ++count;
        }
    return (1.0 / count) * sum;
  }
  /// Sum of normal forces [N] and least gap [m] of all points. One rank.
  double normal_force() const {
    double sum = 0;
    for (int k = 0; k < model_.points().owned(); ++k) sum += state_.lambda[2 * k];
    return sum;
  }
  double least_gap() const {
    double least = 0;
    const auto gap = model_.gaps(state_.displacement);
    for (int k = 0; k < model_.points().owned(); ++k) least = std::min(least, gap[2 * k]);
    return least;
  }

  const PlaneModel& model() const { return model_; }
  const ContactState& state() const { return state_; }
  const EnergyBook& book() const { return book_; }

  TimeStepReport report;
  double time = 0;                                   ///< [s]
  double largest_energy = 0, largest_imbalance = 0;  ///< [J] of all steps
  double least_friction = 0;                         ///< [J] taken in one step

 private:
  /// Energy that load steps have stored; they keep no book here.
  void book_static() {
    const auto& s = model_.structure();
    std::vector<double> ku;
    s.apply_stiffness(state_.displacement, ku);
    double mine = 0, elastic = 0;
    for (int i = 0; i < 2 * s.owned_nodes(); ++i) mine += state_.displacement[i] * ku[i] / 2;
    Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(elastic));
    book_.advance({elastic, 0, elastic - book_.elastic(), 0, 0, 0});
  }

  Scene scene_;
  std::unique_ptr<BlockSource<2>> source_;
  PlaneModel model_;
  AdaptiveStep load_step_;
  ContactState state_;
  EnergyBook book_;
};

}  // namespace voussoir::test
