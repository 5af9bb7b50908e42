// Which tied points to release: the smallest set that holds a given share of the predicted energy decrease.
//
// Releasing point i lowers the incremental energy by about eta_i = r_i^2 / (2 k_i), r_i the distance [N] of its
// force from the admissible cone, k_i the local stiffness [N/m] (design: src/selection/README.md).
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "selection/rest_parameters.hpp"

namespace voussoir {

/// Bulk (Doerfler) marking over all ranks. Collective.
/// @param eta    [J] per owned point, >= 0
/// @param share  in (0, 1]; 1 marks every point with eta > 0
/// @return 1 where marked
std::vector<char> mark_bulk(const std::vector<double>& eta, double share, const Teuchos::Comm<int>&);

}  // namespace voussoir
