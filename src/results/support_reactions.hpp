// What each support of a scene bears.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "output/result_json.hpp"

namespace voussoir {

/// A node of this rank that a support holds.
struct HeldNode {
  int node;
  double size;      ///< [m], in space [m2]: of the support's edges or faces there
  Matrix<3> share;  ///< takes the force that the node bears to that of the support: all of it where no other holds it
};

/// By support, in the order of the scene. Local.
std::vector<std::vector<HeldNode>> held_nodes(const std::vector<Named<SupportParameters>>&, const Model&);

/// Force of each support on the structure, and a point on its line of action: the one nearest to the support's middle.
/// In space the line is the one about which the moment is least. A force belongs, direction by direction, to the
/// support that holds the direction. Where two hold the same one of a node they bear it in the proportion of their
/// edges or faces there, in whichever order the scene names them. Collective.
/// @param residual  [N] on node copies, what is left of equilibrium without supports
std::map<std::string, ReactionSummary> support_reactions(const Model&, const std::vector<double>& residual);

}  // namespace voussoir
