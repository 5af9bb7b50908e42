// What happens within a step, while it does: counted, told to those who print, and judged by those who may end it.
//
// A judge is asked after every linear solve, when all have been told of it, and ends the step by throwing: what it
// throws is its own, and so is catching it. Judges are asked on every rank and come to the same answer there. Those who
// print have no say.
#pragma once

#include <functional>
#include <list>
#include <utility>

#include "nonlinear/newton_report.hpp"

namespace voussoir {

class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  std::function<void(const NewtonProgress&)> print;
  /// The error estimate is NaN where it was not computed.
  std::function<void(int round, long long selected, double error_estimate)> print_round;

  /// Has a judge asked as long as this lives.
  class Judging {
   public:
    Judging(Progress& progress, std::function<void()> judge) : judges_(progress.judges_) {
      judges_.push_back(std::move(judge));
      mine_ = std::prev(judges_.end());
    }
    ~Judging() { judges_.erase(mine_); }
    Judging(const Judging&) = delete;
    Judging& operator=(const Judging&) = delete;

   private:
    std::list<std::function<void()>>& judges_;
    std::list<std::function<void()>>::iterator mine_;
  };

  /// Linear solves so far, each correction by patches counted as one.
  int solves() const { return solves_; }

  /// A linear solve was done. Collective.
  void solved(const NewtonProgress& solve) {
    ++solves_;
    if (print) print(solve);
    for (const auto& judge : judges_) judge();
  }
  /// A selection was looked at.
  void looked(int round, long long selected, double error_estimate) const {
    if (print_round) print_round(round, selected, error_estimate);
  }

 private:
  int solves_ = 0;
  std::list<std::function<void()>> judges_;
};

}  // namespace voussoir
