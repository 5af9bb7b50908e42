// What a run says while it goes.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "results/recorder.hpp"

namespace voussoir {

class Narrator {
 public:
  /// @param seconds  that the run has taken before it begins to step
  Narrator(std::ostream& say, bool verbose, double seconds);
  void begin(int step, const std::string& stage, double target, double progress);
  void solve(const NewtonProgress&);
  void round(int round, long long selected, double error_estimate);
  void end(const StepReport&, double seconds, const RunSummary&, bool tell = true);
  void say(const std::string& line);
  /// What is known so far, for the lines that are said while a step takes long.
  void know(const std::string& words) { known_ = words; }
  void warn(const Warning&);
  void failed(const StepReport&, const std::string& stage, double target);

 private:
  std::ostream& say_;
  bool verbose_;
  double spent_ = 0, progress_ = 0, told_ = 0;
  double first_progress_ = -1;  ///< where this run began, which need not be the beginning
  int step_ = 0, solves_ = 0;
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_, told_at_ = Clock::now();  ///< the run; when it last said something
  double target_ = 0;
  std::string stage_, known_;
};

}  // namespace voussoir
