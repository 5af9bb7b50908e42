// Values that live on one rank and are read on others: ghost copies kept up to date.
#pragma once

#include <vector>

#include "linalg/types.hpp"

namespace voussoir {

/// Numbered items, each owned by one rank; a rank also holds ghosts of items of others.
class Exchange {
 public:
  /// @param local   ids of the items this rank holds, the owned ones first
  /// @param owned   how many of them it owns; every id is owned by exactly one rank
  Exchange(const std::vector<long long>& local, int owned, const Teuchos::RCP<const Teuchos::Comm<int>>&);

  /// Overwrites the ghosts' rows of values [local items x columns, row-major] with their owners'.
  void update(std::vector<double>& values, int columns) const;
  /// The same for whole numbers up to 2^53.
  void update(std::vector<long long>& values) const;

  const Teuchos::Comm<int>& comm() const { return *comm_; }
  int owned() const { return owned_; }

 private:
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Teuchos::RCP<const TpetraMap> owned_map_, local_map_;  ///< none on one rank, which has nothing to exchange
  Teuchos::RCP<const TpetraImport> import_;
  int owned_;
};

}  // namespace voussoir
