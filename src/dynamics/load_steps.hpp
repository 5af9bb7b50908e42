// The way through the stages of a scene: equal increments, halved where they do not converge, or steps of time.
#pragma once

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "dynamics/load_step_parameters.hpp"

namespace voussoir {

class LoadSteps {
 public:
  LoadSteps(const std::vector<StageParameters>& stages, const LoadStepParameters& parameters)
      : stages_(stages), parameters_(parameters) {
    for (const auto& stage : stages) {
      VOUSSOIR_EXPECT((stage.dynamic() ? stage.duration > 0 : stage.increments > 0) && "a stage has steps");
      planned_ += weight(stage);
    }
  }

  bool finished() const { return stage_ == stages_.size(); }
  const std::vector<StageParameters>& stages() const { return stages_; }
  /// Stages that are over.
  std::size_t passed() const { return stage_; }
  const std::string& stage() const { return stage_parameters().name; }
  const StageParameters& stage_parameters() const {
    VOUSSOIR_EXPECT(!finished() && "a stage is left");
    return stages_[stage_];
  }
  bool dynamic() const { return stage_parameters().dynamic(); }
  /// The time step of a stage with duration [s]; must be set before its steps.
  void set_time_step(double time_step) {
    VOUSSOIR_EXPECT(time_step > 0 && "time step: positive");
    time_step_ = time_step;
  }
  /// Share of the stage that the next step ends at, 0 < . <= 1.
  double target() const {
    const auto& stage = stage_parameters();
    VOUSSOIR_EXPECT((!stage.dynamic() || time_step_ > 0) && "the time step is set before its steps");
    const double step = stage.dynamic() ? time_step_ / stage.duration : 1.0 / stage.increments / (1 << halvings_);
    return reached_ + step > 1 - step / 1e6 ? 1.0 : reached_ + step;
  }
  /// Share of the stage reached so far.
  double reached() const { return reached_; }
  /// Time of stages with duration since the start, at a share of this stage [s].
  double time(double share) const { return time_before_ + (finished() ? 0 : share * stages_[stage_].duration); }
  double time() const { return time(finished() ? 0 : reached_); }
  /// Factors of the loads at a share of this stage.
  std::map<std::string, double> factors(double share) const {
    VOUSSOIR_EXPECT(share >= 0 && share <= 1 && "a share of a stage");
    auto factors = before_;
    const double part = dynamic() && stages_[stage_].at_once ? 1.0 : share;
    for (const auto& [load, end] : stages_[stage_].factors) {
      const double start = before_.count(load) ? before_.at(load) : 0.0;
      factors[load] = start + part * (end - start);
    }
    return factors;
  }
  /// Factors at the end of this stage of the loads that act in it.
  std::map<std::string, double> acting() const {
    auto all = factors(1);
    const auto first = factors(0);
    for (auto it = all.begin(); it != all.end();) {
      const auto start = first.find(it->first);
      const bool acts = it->second != 0 || (start != first.end() && start->second != 0);
      it = acts ? std::next(it) : all.erase(it);
    }
    return all;
  }
  /// Factors of the loads at the end of the next step.
  std::map<std::string, double> factors() const { return factors(target()); }

  /// The step was solved: go on.
  void accept() {
    reached_ = target();
    if (halvings_ > 0 && ++successes_ == 2) {  // two steps in a row: try the larger one again
      --halvings_;
      successes_ = 0;
    }
    if (reached_ < 1) return;
    for (const auto& [load, end] : stages_[stage_].factors) before_[load] = end;
    time_before_ += stages_[stage_].duration;
    ++stage_;
    reached_ = stage_ == stages_.size() ? 1 : 0;
    halvings_ = 0;
  }
  /// True when the last step ended a stage.
  bool stage_reached() const { return finished() || reached_ == 0; }
  /// Factors where the last step ended.
  std::map<std::string, double> last_factors() const { return stage_reached() ? before_ : factors(reached_); }
  /// The load step failed: halve it. False when it has been halved often enough.
  bool halve() {
    VOUSSOIR_EXPECT(!finished() && "a step of a stage has failed");
    if (halvings_ >= parameters_.largest_halvings) return false;
    ++halvings_;
    successes_ = 0;
    return true;
  }
  int halvings() const { return halvings_; }
  /// Names what a checkpoint keeps (output/checkpoint.hpp). Restored, what was before follows from the stages passed.
  template <class Archive>
  void keep(Archive& archive) {
    auto stage = static_cast<int>(stage_);
    archive.within("load_steps.stage", stage, 0, static_cast<double>(stages_.size()));
    archive.within("load_steps.reached", reached_, 0, 1);
    archive.within("load_steps.halvings", halvings_, 0, LoadStepParameters::most_halvings);
    archive.within("load_steps.successes", successes_, 0, 1);
    stage_ = static_cast<std::size_t>(stage);
    if (!finished() && reached_ == 1) reached_ = 0;  // it was at its end, and the scene has a further stage
    before_.clear();
    time_before_ = 0;
    for (std::size_t k = 0; k < std::min(stage_, stages_.size()); ++k) {
      for (const auto& [load, end] : stages_[k].factors) before_[load] = end;
      time_before_ += stages_[k].duration;
    }
  }
  /// Share of the way done, for the remaining time.
  double progress() const {
    double done = 0;
    for (std::size_t k = 0; k < stage_; ++k) done += weight(stages_[k]);
    return finished() ? 1 : (done + reached_ * weight(stages_[stage_])) / planned_;
  }

 private:
  // A stage of time has hundreds of steps where one of loads has a few.
  static double weight(const StageParameters& stage) { return stage.dynamic() ? 100.0 : stage.increments; }

  const std::vector<StageParameters>& stages_;
  LoadStepParameters parameters_;
  std::map<std::string, double> before_;
  std::size_t stage_ = 0;
  int halvings_ = 0;
  int successes_ = 0;  ///< steps solved since the last halving or doubling
  double planned_ = 0, reached_ = 0, time_step_ = 0, time_before_ = 0;
};

/// True when a scene has stages and all of them have a duration: no static equilibrium is ever sought.
inline bool only_time(const std::vector<StageParameters>& stages) {
  for (const auto& stage : stages)
    if (!stage.dynamic()) return false;
  return !stages.empty();
}

/// True when a stage of a scene has a duration.
inline bool any_time(const std::vector<StageParameters>& stages) {
  for (const auto& stage : stages)
    if (stage.dynamic()) return true;
  return false;
}

}  // namespace voussoir
