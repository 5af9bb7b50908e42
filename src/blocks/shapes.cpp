#include "blocks/shapes.hpp"

#include <utility>

#include "blocks/assembly.hpp"
#include "blocks/condensed_edges.hpp"

namespace voussoir {

template <int dim>
BlockMatrices StiffnessOfShapes::of(Block<dim> block, const Material& material) {
  const auto first = block.position.front();
  for (auto& x : block.position) x = x - first;
  std::vector<double> shape{material.young_modulus, material.poisson_ratio, material.thickness,
                            static_cast<double>(block.position.size())};
  for (const auto& x : block.position) shape.insert(shape.end(), x.begin(), x.end());
  for (const auto& cell : block.cells) {
    shape.push_back(cell.count);
    shape.insert(shape.end(), cell.node.begin(), cell.node.begin() + cell.count);
  }
  for (const auto& edge : block.curved) shape.insert(shape.end(), edge.begin(), edge.end());
  auto& known = known_[std::move(shape)];
  if (known.stiffness) return known;
  known.sparse = known.stiffness = std::make_shared<const LocalCsr>(block_stiffness(block, material, model_));
  if (!block.curved.empty()) {
    known.edges = std::make_shared<const CondensedEdges>(block, material, model_);
    known.stiffness = std::make_shared<const LocalCsr>(known.edges->stiffness(*known.sparse));
  }
  return known;
}

template BlockMatrices StiffnessOfShapes::of(Block<2>, const Material&);
template BlockMatrices StiffnessOfShapes::of(Block<3>, const Material&);

}  // namespace voussoir
