// The way through the stages of a scene: equal increments, halved where they do not converge.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "dynamics/load_step_parameters.hpp"

namespace voussoir {

class LoadSteps {
 public:
  LoadSteps(const std::vector<StageParameters>& stages, const LoadStepParameters& parameters)
      : stages_(stages), parameters_(parameters) {
    for (const auto& stage : stages) planned_ += stage.increments;
  }

  bool finished() const { return stage_ == stages_.size(); }
  const std::string& stage() const { return stages_[stage_].name; }
  /// Share of the stage that the next step ends at, 0 < . <= 1.
  double target() const {
    const double step = 1.0 / stages_[stage_].increments / (1 << halvings_);
    return reached_ + step > 1 - step / 1e6 ? 1.0 : reached_ + step;
  }
  /// Share of the stage reached so far.
  double reached() const { return reached_; }
  /// Factors of the loads at the end of the next step.
  std::map<std::string, double> factors() const {
    auto factors = before_;
    for (const auto& [load, end] : stages_[stage_].factors) {
      const double start = before_.count(load) ? before_.at(load) : 0.0;
      factors[load] = start + target() * (end - start);
    }
    return factors;
  }

  /// The step was solved: go on.
  void accept() {
    reached_ = target();
    if (halvings_ > 0 && ++successes_ == 2) {  // two steps in a row: try the larger one again
      --halvings_;
      successes_ = 0;
    }
    if (reached_ < 1) return;
    for (const auto& [load, end] : stages_[stage_].factors) before_[load] = end;
    ++stage_;
    reached_ = stage_ == stages_.size() ? 1 : 0;
    halvings_ = 0;
  }
  /// The step failed: halve it. False when it has been halved often enough.
  bool halve() {
    if (halvings_ == parameters_.largest_halvings) return false;
    ++halvings_;
    successes_ = 0;
    return true;
  }
  int halvings() const { return halvings_; }
  /// Names what a checkpoint keeps (output/checkpoint.hpp). After restoring, `before_` follows from the stages passed.
  template <class Archive>
  void keep(Archive& archive) {
    auto stage = static_cast<int>(stage_);
    archive.value("load_steps.stage", stage);
    archive.value("load_steps.reached", reached_);
    archive.value("load_steps.halvings", halvings_);
    archive.value("load_steps.successes", successes_);
    stage_ = static_cast<std::size_t>(stage);
    before_.clear();
    for (std::size_t k = 0; k < std::min(stage_, stages_.size()); ++k)
      for (const auto& [load, end] : stages_[k].factors) before_[load] = end;
  }
  /// Share of the planned increments done, for the remaining time.
  double progress() const {
    double done = 0;
    for (std::size_t k = 0; k < stage_; ++k) done += stages_[k].increments;
    return finished() ? 1 : (done + reached_ * stages_[stage_].increments) / planned_;
  }

 private:
  const std::vector<StageParameters>& stages_;
  LoadStepParameters parameters_;
  std::map<std::string, double> before_;
  std::size_t stage_ = 0;
  int halvings_ = 0, planned_ = 0;
  int successes_ = 0;  ///< steps solved since the last halving or doubling
  double reached_ = 0;
};

}  // namespace voussoir
