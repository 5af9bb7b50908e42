// Forces that tied points carry, from the equilibrium of each block.
#pragma once

#include <vector>

#include "blocks/held.hpp"
#include "joints/contact_points.hpp"

namespace voussoir {

/// What tied points transmit. At a vertex the nodal residuals of the blocks are divided among the points between
/// them by least squares, weighted by joint area: the forces are differences of a potential, area times
/// (phi_j - phi_i), with the sums at each node prescribed.
///
/// @param cluster   per local node copy; a pair of coincident nodes is tied when both have the same cluster
/// @param held      of local node copies: where an unknown reaction acts
/// @param residual  K u - f of each block alone [N], per local node copy and component
/// @param lambda    forces in the points' axes [N], [points x components]; those of free points are used, those of
///                  tied ones set. Owned points are set; the caller updates ghosts
/// @param before    forces that tied points had: only what was added since is divided. Empty for none
/// @param open      1 where a tied point stands open: it is given what closed ones cannot carry. Empty for none
void recover_tied_forces(const ContactPoints&, const std::vector<int>& cluster, const Held& held,
                         const std::vector<double>& residual, std::vector<double>& lambda,
                         const std::vector<double>& before = {}, const std::vector<char>& open = {});

/// Adds factor B^T lambda to nodal forces, for points that `cluster` does not tie (all points when it is empty).
void add_contact_forces(const ContactPoints&, const std::vector<int>& cluster, const std::vector<double>& lambda,
                        double factor, std::vector<double>& nodal);

}  // namespace voussoir
