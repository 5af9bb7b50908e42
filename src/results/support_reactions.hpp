// What each support of a scene bears.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/plane/plane_model.hpp"
#include "output/result_json.hpp"

namespace voussoir {

/// A node of this rank that a support holds.
struct HeldNode {
  int node;
  double length;    ///< [m] of the support's edges there
  Vector<2> share;  ///< by component, of the force that the node bears: one where no other support holds it
};

/// By support, in the order of the scene. Local.
std::vector<std::vector<HeldNode>> held_nodes(const std::vector<Named<SupportParameters>>&, const BlockSource<2>&,
                                              const Structure<2>&);

/// Force of each support on the structure, and a point on its line of action: the one nearest to the support's middle.
/// A force belongs, component by component, to the support that holds the component. Where two hold the same one of a
/// node they bear it in the proportion of their edges there, in whichever order the scene names them. Collective.
/// @param residual  [N] on node copies, what is left of equilibrium without supports
std::map<std::string, ReactionSummary> support_reactions(const PlaneModel&, const std::vector<double>& residual);

}  // namespace voussoir
