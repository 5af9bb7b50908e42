#include "blocks/shapes.hpp"

#include <utility>

#include "blocks/assembly.hpp"

namespace voussoir {

template <int dim>
std::shared_ptr<const LocalCsr> StiffnessOfShapes::of(Block<dim> block, const Material& material) {
  const auto first = block.position.front();
  for (auto& x : block.position) x = x - first;
  std::vector<double> shape{material.young_modulus, material.poisson_ratio, static_cast<double>(block.position.size())};
  for (const auto& x : block.position) shape.insert(shape.end(), x.begin(), x.end());
  for (const auto& cell : block.cells) {
    shape.push_back(cell.count);
    shape.insert(shape.end(), cell.node.begin(), cell.node.begin() + cell.count);
  }
  auto& known = known_[std::move(shape)];
  if (!known) known = std::make_shared<const LocalCsr>(block_stiffness(block, material, model_));
  return known;
}

template std::shared_ptr<const LocalCsr> StiffnessOfShapes::of(Block<2>, const Material&);
template std::shared_ptr<const LocalCsr> StiffnessOfShapes::of(Block<3>, const Material&);

}  // namespace voussoir
