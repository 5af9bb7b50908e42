// Points between two blocks of the plane whose meshes do not match along their joint: mortar with dual functions.
//
// The side with more edges has the points, one per node a. With shape functions N, all integrals over what both faces
// cover, and functions psi_a linear on each of its edges,
//
//   integral psi_a N_c = 0 for a != c,  integral psi_a N_a = D_a = integral N_a,  sum of psi_a = 1,
//   w_ab = integral psi_a N_b / D_a      for every node b of the other side
//
// node a moves against the sum of w_ab u_b, and bears forces of its own alone. The weights of a point sum to one, some
// may be negative. Linear motions of both faces leave no gap, and a uniform pressure p gives every node of either side
// p times the integral of its shape function: it passes exactly, whatever the meshes are.
//
// Theory  B. I. Wohlmuth, SIAM J. Numer. Anal. 38 (2000) 989-1012 (dual functions);
//         A. Popp, A. Seitz, M. W. Gee, W. A. Wall, Comput. Methods Appl. Mech. Eng. 264 (2013) 67-80 (edges of which
//         the other face covers a part).
#pragma once

#include "joints/contact_points.hpp"

namespace voussoir {

/// Points of a joint, ascending by the vertex of the node that has them; pairs of coincident nodes where all edges of
/// the joint match. Only edges that lie on each other meet: faces that are curved and divided in two ways do not.
std::vector<FoundPoint> mortar_points(const BlockWithBorder<2>& i, const BlockWithBorder<2>& j);

}  // namespace voussoir
