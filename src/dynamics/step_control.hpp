// Which time step next: base / 2^level, where the base divides the stage equally.
//
// An automatic step grows while its error stays small and shrinks when it does not, or when a load is about to vary
// faster. A step that fails is halved, whoever chose it. Steps grow only where the larger step still ends on its own
// raster, so a stage ends exactly.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace voussoir {

/// What a stage that is left and taken up again must remember of its time step.
struct TimeStepLevel {
  int level = -1;  ///< the time step is base / 2^level; -1 before a stage
  int calm = 0;    ///< steps since it changed
  int failures = 0;
  template <class Archive>
  void keep(Archive& archive) {
    archive.within("time_step.level", level, -1, deepest);
    archive.within("time_step.calm", calm, 0, 1e9);
    archive.within("time_step.failures", failures, 0, deepest);
  }
  static constexpr int deepest = 62;  ///< 2^level is a whole number
};

class StepControl {
 public:
  /// @param duration        [s] of the stage
  /// @param fixed           [s] time step the user wants; 0 = automatic, between the Courant time and the longest
  /// @param now             where the stage stands; outlives the control
  /// @param courant_time    [s] passage of a wave through the smallest cell
  /// @param longest         [s] an automatic step
  /// @param tolerance       [-] error of an automatic step
  StepControl(TimeStepLevel& now, double duration, double fixed, double courant_time, double longest, double tolerance,
              int largest_halvings)
      : now_(now),
        duration_(duration),
        automatic_(fixed == 0),
        tolerance_(tolerance),
        largest_halvings_(largest_halvings) {
    VOUSSOIR_EXPECT(duration > 0 && std::isfinite(duration) && "duration: positive");
    VOUSSOIR_EXPECT(fixed >= 0 && "given time step: positive, or 0");
    VOUSSOIR_EXPECT(courant_time > 0 && "Courant time: positive");
    VOUSSOIR_EXPECT(longest > 0 && "longest step: positive");
    VOUSSOIR_EXPECT(tolerance > 0 && "tolerance: positive");
    VOUSSOIR_EXPECT(largest_halvings >= 0 && "halvings: a count");
    // An automatic stage has at least 20 steps: loads that ramp over it are seen.
    const double largest = automatic_ ? std::min(longest, duration / 20) : fixed;
    base_steps_ = std::max(1LL, static_cast<long long>(std::ceil(duration / largest * (1 - 1e-12))));
    if (automatic_)  // begin at the Courant time: what follows is not known yet
      finest_ = std::max(0, static_cast<int>(std::ceil(std::log2(base() / courant_time) - 1e-9)));
    if (now_.level < 0) now_ = {finest_, 0, 0};
  }

  /// Before a step: an automatic one is no longer than what loads ask for that vary within it, nor shorter than the
  /// shortest.
  /// @param reached     [s] of the stage
  /// @param resolution  (from, to): [s] a time step that sees how loads vary between two times of the stage
  template <class Resolution>
  void look_ahead(double reached, const Resolution& resolution) {
    for (; automatic_ && now_.level < finest_; ++now_.level, now_.calm = 0) {
      const double step = time_step(), off = round_off * step;
      if (step <= resolution(reached + off, reached + step - off) * (1 + uneven)) return;
    }
  }

  double time_step() const { return base() / static_cast<double>(1LL << now_.level); }
  bool automatic() const { return automatic_; }

  /// The step was solved with this error; `reached` [s] is the end of it in the stage.
  /// @return true when the time step changes
  bool accept(double error, double reached) {
    VOUSSOIR_EXPECT(reached >= 0 && reached <= duration_ * (1 + round_off) && "reached: a time of the stage");
    VOUSSOIR_EXPECT(!std::isnan(error) && "error: a number");
    now_.failures = 0;
    ++now_.calm;
    const int before = now_.level;
    if (automatic_ && error > tolerance_ && now_.level < finest_) {
      ++now_.level;
      now_.calm = 0;
    } else if (may_grow(error) && on_raster(reached, now_.level - 1)) {
      --now_.level;
      now_.calm = 0;
    }
    return now_.level != before;
  }

  /// The step was not solved: halve it. False when it has been halved often enough.
  bool halve() {
    if (now_.failures >= largest_halvings_ || now_.level == TimeStepLevel::deepest) return false;
    ++now_.failures;
    ++now_.level;
    now_.calm = 0;
    return true;
  }

 private:
  // Errors fall with the square of the step: one twice as long has four times the error, kept below half the tolerance.
  static constexpr double growing = 0.125;
  static constexpr int patience = 8;         // steps between two changes, since each builds a preconditioner anew
  static constexpr double uneven = 0.1;      // rows of a record whose times are rounded
  static constexpr double round_off = 1e-6;  // of a step: what its end is beyond its raster

  double base() const { return duration_ / static_cast<double>(base_steps_); }
  bool may_grow(double error) const {
    if (now_.level == 0 || now_.calm < patience) return false;
    return !automatic_ || error < growing * tolerance_ || now_.level > finest_;
  }
  bool on_raster(double reached, int level) const {
    const double steps = reached / base() * static_cast<double>(1LL << level);
    return std::abs(steps - std::round(steps)) < round_off;
  }

  TimeStepLevel& now_;
  double duration_;
  bool automatic_;
  double tolerance_;
  int largest_halvings_;
  long long base_steps_ = 1;
  int finest_ = 0;
};

}  // namespace voussoir
