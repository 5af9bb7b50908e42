// What a run says while it goes.
#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "results/recorder.hpp"

namespace voussoir {

class Narrator {
 public:
  Narrator(std::ostream& say, bool verbose);
  void begin(int step, const std::string& stage, double target, double progress);
  void solve(const NewtonProgress&);
  void round(int round, long long selected, double error_estimate);
  void end(const StepReport&, double seconds, const RunSummary&, bool tell = true);
  void say(const std::string& line);
  void warn(const Warning&);
  void failed(const StepReport&, const std::string& stage, double target);

 private:
  std::ostream& say_;
  bool verbose_;
  double spent_ = 0, progress_ = 0, told_ = 0;
  double first_progress_ = -1;  ///< where this run began, which need not be the beginning
  int step_ = 0, solves_ = 0;
  std::chrono::steady_clock::time_point told_at_ = std::chrono::steady_clock::now();  ///< when it last said something
  double target_ = 0;
  std::string stage_;
};

}  // namespace voussoir
