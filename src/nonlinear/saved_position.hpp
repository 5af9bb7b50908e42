// A position to come back to, whatever is carried meanwhile.
#pragma once

#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

class SavedPosition {
 public:
  SavedPosition(const NonlinearProblem& problem, const TpetraVector& x) : problem_(problem), whole_(x, Teuchos::Copy) {
    if (const auto* carried = problem.carried()) whole_.update(1.0, *carried, 1.0);
  }

  void restore(TpetraVector& x) const {
    Tpetra::deep_copy(x, whole_);
    if (const auto* carried = problem_.carried()) x.update(-1.0, *carried, 1.0);
  }

  /// Largest component of the way from there to x [m]. Collective.
  double distance(const TpetraVector& x) const {
    TpetraVector way(x, Teuchos::Copy);
    way.update(-1.0, whole_, 1.0);
    if (const auto* carried = problem_.carried()) way.update(1.0, *carried, 1.0);
    return way.normInf();
  }

 private:
  const NonlinearProblem& problem_;
  TpetraVector whole_;  // [m] x and what was carried
};

}  // namespace voussoir
