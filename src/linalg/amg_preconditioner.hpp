// Algebraic multigrid for elasticity: MueLu behind a wall.
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <vector>

#include "linalg/preconditioner.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {

struct MultigridLevel {
  long long rows = 0, entries = 0;
  int ranks = 0;  ///< that hold rows of it
};

/// MueLu's parameters of a smoother: Gauss-Seidel forwards down and backwards up.
void smooth_by_gauss_seidel(Teuchos::ParameterList&, int sweeps);

/// One V-cycle of smoothed aggregation, in space of prolongators of least energy.
class AmgPreconditioner : public Preconditioner {
 public:
  /// @param a            symmetric positive definite; rows dim * node + component, nodes contiguous on a rank
  /// @param coordinates  one row per node [m], dim columns
  /// @param near_null    rigid motions at the nodes, 3 (2D) or 6 (3D) columns, on the map of a
  /// @param overrides    MueLu parameters of the user, put over the program's own
  /// @param sent_for     what messages of a cycle are counted as
  AmgPreconditioner(const Teuchos::RCP<TpetraMatrix>& a, const Teuchos::RCP<TpetraMultiVector>& coordinates,
                    const Teuchos::RCP<TpetraMultiVector>& near_null, int dim, const Teuchos::ParameterList& overrides,
                    TrafficOf sent_for = TrafficOf::continuum);
  ~AmgPreconditioner() override;
  void apply(const TpetraVector& r, TpetraVector& z) const override;
  /// From the finest to the coarsest. Collective.
  std::vector<MultigridLevel> levels() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
  TrafficOf sent_for_;
};

}  // namespace voussoir
