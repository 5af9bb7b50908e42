// A symmetric system of which every rank holds a part: parts are added up on the owners of rows and solved directly.
//
// A rank knows the unknowns of its own and some of its neighbours', and nothing of others: what is added up, the right
// side and the solution go between neighbours. Small systems are factored on the first rank, large ones by all.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "linalg/direct_preconditioner.hpp"
#include "linalg/distributed_lu.hpp"
#include "linalg/parcels.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {

class SharedSystem {
 public:
  /// What a rank calls 0, 1, ...: the owned ones first.
  struct Unknowns {
    std::vector<GlobalOrdinal> number;  ///< in the whole: without gaps in the order of ranks, the owned ones ascending
    std::vector<int> owner;             ///< rank
    int owned = 0;
  };
  /// Collective, as are all others but bytes.
  /// @param most_on_first  unknowns up to which the first rank factors
  SharedSystem(Unknowns, const Teuchos::RCP<const Teuchos::Comm<int>>&, long long most_on_first);
  ~SharedSystem();

  /// However large it is. Before anything is factored.
  void factor_on_first_rank() { most_on_first_ = std::numeric_limits<long long>::max(); }
  /// Adds up the parts and factors the sum, positive definite or singular by rigid motions.
  /// @param part  upper triangle in this rank's numbers, of the same pattern every time
  void factor(const LocalCsr& part);
  /// Adds up parts of the right side and solves. Not a number, or a SolverFailure on all ranks, where that fails.
  /// @param right     of this rank's unknowns
  /// @param solution  of all of them; may be `right`
  void solve(const std::vector<double>& right, std::vector<double>& solution) const;
  long long size() const;
  long long bytes() const;

 private:
  class Sum;

  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Unknowns unknowns_;
  long long size_ = 0, most_on_first_;
  std::unique_ptr<Sum> sum_;               ///< on several ranks
  std::unique_ptr<SparseCholesky> alone_;  ///< on one
  std::unique_ptr<DirectPreconditioner> on_first_;
  std::unique_ptr<DistributedLu> spread_;
};

}  // namespace voussoir
