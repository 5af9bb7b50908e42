// What happens within a step, while it does: counted, told to those who print, and asked of those who may end it.
//
// Whoever may want no more of a step is asked after every linear solve, when all have been told of it. Where one says
// no the step ends as stopped, an outcome like others: the state is that before it, and who said no knows why. The
// question is put on every rank and answered alike there. Those who print have no say.
#pragma once

#include <functional>
#include <list>
#include <utility>

#include "linalg/types.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/point_field.hpp"

namespace voussoir {

class ContactProblem;

/// A contact problem that was hard (newton_report.hpp), and how its solver has left it.
struct HardProblem {
  ContactProblem& problem;
  const TpetraVector& x;     ///< [m] its unknowns
  const PointField& lambda;  ///< [N] forces of points
  const NewtonReport& report;
  int linear_solves;  ///< that it took
};

class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  std::function<void(const NewtonProgress&)> print;
  /// The error estimate is NaN where it was not computed.
  std::function<void(int round, long long selected, double error_estimate)> print_round;
  /// Whoever keeps contact problems that were hard; mostly nobody. Collective.
  std::function<void(const HardProblem&)> keep;

  /// Asked after every linear solve whether the step goes on, as long as this lives.
  class Question {
   public:
    Question(Progress& progress, std::function<GoOn()> ask) : questions_(progress.questions_) {
      questions_.push_back(std::move(ask));
      mine_ = std::prev(questions_.end());
    }
    ~Question() { questions_.erase(mine_); }
    Question(const Question&) = delete;
    Question& operator=(const Question&) = delete;

   private:
    std::list<std::function<GoOn()>>& questions_;
    std::list<std::function<GoOn()>>::iterator mine_;
  };

  /// Linear solves so far, each correction by patches counted as one.
  int solves() const { return solves_; }

  /// A linear solve was done. The first who says no is the last who is asked. Collective.
  GoOn solved(const NewtonProgress& solve) {
    ++solves_;
    if (print) print(solve);
    for (const auto& ask : questions_)
      if (ask() == GoOn::no) return GoOn::no;
    return GoOn::yes;
  }
  /// A selection was looked at.
  void looked(int round, long long selected, double error_estimate) const {
    if (print_round) print_round(round, selected, error_estimate);
  }

 private:
  int solves_ = 0;
  std::list<std::function<GoOn()>> questions_;
};

}  // namespace voussoir
