// Direct solution of systems of any symmetry that are spread over ranks: MUMPS behind a wall.
#pragma once

#include <memory>

#include "linalg/linear_solver.hpp"
#include "linalg/preconditioner.hpp"

namespace voussoir {

/// Where factors are: spread over the ranks, or on the first one alone. MUMPS adds up what ranks send each other in the
/// order in which it arrives, so spread ones differ by round-off from run to run; those of one rank do not.
enum class FactorsAre { spread, on_first_rank };

/// LU factors of a distributed matrix, or L D L^T of a symmetric one. No rank holds a right side or a solution whole
/// but the first where it factors alone. A pattern is ordered once for all matrices that have it.
class DistributedLu : public Preconditioner {
 public:
  /// Every rank calls this, factor, apply and the destructor. Global numbers may have gaps.
  /// @param map  of rows, as of all matrices to come
  explicit DistributedLu(const Teuchos::RCP<const TpetraMap>& map, FactorsAre = FactorsAre::spread,
                         Symmetry = Symmetry::none);
  ~DistributedLu() override;

  /// Factors a matrix, of the pattern of the first one given. Where it is singular rows that say nothing are left out.
  /// Whatever else MUMPS objects to is a SolverFailure on all ranks.
  /// @return false on all ranks where one has no room
  [[nodiscard]] bool factor(const TpetraMatrix& a);
  /// What factors of a matrix will be, of all ranks, as the order of its pattern tells.
  struct Expected {
    double bytes;       ///< infinite where there is no room to order it
    double operations;  ///< additions and multiplications
  };
  /// Of a matrix of the pattern of the first one given. Collective, and fails likewise.
  [[nodiscard]] Expected expected(const TpetraMatrix& a);
  /// z = A^-1 r, exact but for round-off. There must have been room for what was factored last. Fails likewise.
  void apply(const TpetraVector& r, TpetraVector& z) const override;
  /// Of this rank, the room MUMPS worked in included.
  long long bytes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace voussoir
