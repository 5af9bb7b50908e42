// Direct solution around the points that a selection lets go.
//
// Where few joints are resolved the bonded continuum is the structure itself, but for the nodes that have parted: what
// it does not know lies within a few layers of cells around them. The first rank gathers these unknowns of all and
// factors them, friction included.
#pragma once

#include <vector>

#include "homogenisation/coarse_operator_parameters.hpp"
#include "homogenisation/system_matrix.hpp"
#include "linalg/sparse_lu.hpp"

namespace voussoir {

class ReleasedRegion {
 public:
  /// Collective.
  ReleasedRegion(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
                 const CoarseOperatorParameters& = {});

  /// Unknowns of all ranks; 0 where no two nodes have parted.
  long long size() const { return size_; }
  /// Whether so few unknowns lie in the region that to factor it is worth its time; where not, layers are missing.
  bool pays() const { return pays_; }
  /// Factors the region's part of H. Returns whether it is regular, the same on all ranks. Collective.
  [[nodiscard]] bool update(const SystemMatrix& h);
  /// z += E (H_EE)^-1 E^T r, E the unknowns of the region. Not a number where that fails. Collective.
  void add(const TpetraVector& r, TpetraVector& z) const;
  /// On this rank.
  long long bytes() const;

 private:
  void number(const std::vector<char>& inside);
  void set_pattern(const OwnedRows& h);
  void solve(const double* right, double* solution) const;

  const MergedSpace& space_;
  std::vector<int> unknown_;  ///< owned ones of the region, ascending
  long long size_ = 0;        ///< of all ranks, numbered rank by rank
  long long first_ = 0;       ///< number of the first owned one
  bool pays_ = false;
  std::vector<std::size_t> entry_;  ///< of the owned rows: where in H each entry of the region stands
  bool known_ = false;              ///< the pattern is
  LocalCsr matrix_;                 ///< of all ranks, on the first
  SparseLu factor_;
  Teuchos::RCP<const TpetraImport> from_first_;  ///< of unknowns of the region; none on one rank
};

}  // namespace voussoir
