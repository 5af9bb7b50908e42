// Stiffness by shape: blocks that are alike have one matrix, a wall in running bond four.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "blocks/material.hpp"
#include "linalg/local_csr.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

class CondensedEdges;

/// As NodesOfBlock has them.
struct BlockMatrices {
  std::shared_ptr<const LocalCsr> stiffness, sparse;
  std::shared_ptr<const CondensedEdges> edges;
};

/// Two blocks are alike when their materials, cells and curved edges are equal and their nodes lie alike around their
/// first ones, to the last bit: the matrix of a block does not depend on the blocks it is alike to, and so not on
/// ranks. Round-off of places makes some shapes of one, tens in a wall; what is rounded to share more would strain
/// stones that only turn.
class StiffnessOfShapes {
 public:
  explicit StiffnessOfShapes(const ModelParameters& model) : model_(model) {}
  template <int dim>
  BlockMatrices of(Block<dim>, const Material&);

 private:
  ModelParameters model_;
  std::map<std::vector<double>, BlockMatrices> known_;
};

}  // namespace voussoir
