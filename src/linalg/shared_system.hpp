// A symmetric system of which every rank holds a part: parts are added up on the owners of rows and solved there.
//
// A rank knows the unknowns of its own and some of its neighbours', and nothing of others: what is added up, the right
// side and the solution go between neighbours. Small systems are factored on the first rank. Instead of a solution of
// large ones there is a cycle of levels, linear and symmetric, or where that does not converge factors spread over all.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "linalg/body_levels.hpp"
#include "linalg/direct_preconditioner.hpp"
#include "linalg/distributed_lu.hpp"
#include "linalg/parcels.hpp"
#include "linalg/shared_system_parameters.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {

/// What stands for the solution of a system: levels, or factors, also where levels were built and did not converge.
enum class SolvedBy : int { factors, levels, factors_for_levels };

class SharedSystem {
 public:
  /// What a rank calls 0, 1, ...: the owned ones first.
  struct Unknowns {
    std::vector<GlobalOrdinal> number;  ///< in the whole: without gaps in the order of ranks, the owned ones ascending
    std::vector<int> owner;             ///< rank
    int owned = 0;
  };
  /// What is known of owned unknowns that are motions of bodies.
  struct Bodies {
    int of_a_body = 0;                       ///< unknowns, one after the other; none: there are no levels
    std::vector<std::vector<double>> rigid;  ///< what hardly strains the whole, column by column
    std::vector<std::vector<double>> place;  ///< of each body [m], direction by direction
  };
  /// Collective, as are all others but bytes.
  SharedSystem(Unknowns, const Bodies&, const Teuchos::RCP<const Teuchos::Comm<int>>&,
               const SharedSystemParameters& = {});
  ~SharedSystem();

  /// However large it is. Before anything is factored.
  void factor_on_first_rank() { numbers_.most_on_first = std::numeric_limits<long long>::max(); }
  /// Adds up the parts and factors the sum, positive definite or singular by rigid motions, or builds levels of it.
  /// @param part  upper triangle in this rank's numbers, of the same pattern every time
  SolvedBy factor(const LocalCsr& part);
  /// Adds up parts of the right side and solves, or does a cycle. Where that fails not a number, or SolverFailure.
  /// @param right     of this rank's unknowns
  /// @param solution  of all of them; may be `right`
  void solve(const std::vector<double>& right, std::vector<double>& solution) const;
  long long size() const { return size_; }
  long long bytes() const;
  /// Of the cycle that stands for the solution, from the finest to the coarsest; none where factors do.
  std::vector<MultigridLevel> levels() const;

 private:
  class Sum;

  bool may_have_levels() const;
  bool build_levels(const TpetraMatrix&);
  void factor_directly(const TpetraMatrix&);

  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Unknowns unknowns_;
  SharedSystemParameters numbers_;
  long long size_ = 0;
  BodyMotions bodies_;
  std::unique_ptr<Sum> sum_;               ///< on several ranks
  std::unique_ptr<SparseCholesky> alone_;  ///< on one
  std::unique_ptr<BodyLevels> levels_;     ///< or one of those below
  std::unique_ptr<DirectPreconditioner> on_first_;
  std::unique_ptr<DistributedLu> spread_;
};

}  // namespace voussoir
