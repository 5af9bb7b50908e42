// Do scene and mesh belong together?
#pragma once

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Throws InputError for sets that do not exist, a block without material, a joint without law, a block with two times
/// of being there, a stage without blocks. Each rank looks at the blocks it reads; all throw, or none. Collective.
template <int dim>
void check_fit(const Scene&, const BlockSource<dim>&, const Teuchos::Comm<int>&);

/// True when a block is in the set of that name; "all" holds every block.
template <int dim>
bool in_set(const BlockSource<dim>& source, const Block<dim>& block, const std::string& name) {
  if (name == "all") return true;
  for (int set : block.sets)
    if (source.block_sets()[set] == name) return true;
  return false;
}

/// Whether a block is there in a stage of a scene, counted from 0.
template <int dim>
bool is_there(const Scene&, const BlockSource<dim>&, const Block<dim>&, std::size_t stage);

/// Whether a law names the joint between two blocks.
template <int dim>
bool joins(const BlockSource<dim>& source, const JointLawParameters& law, const Block<dim>& i, const Block<dim>& j) {
  return (in_set(source, i, law.between) && in_set(source, j, law.and_)) ||
         (in_set(source, j, law.between) && in_set(source, i, law.and_));
}

/// Index of the last joint law between two blocks, -1 for none.
template <int dim>
int family_of(const Scene& scene, const BlockSource<dim>& source, const Block<dim>& i, const Block<dim>& j) {
  int family = -1;
  for (std::size_t f = 0; f < scene.joints.size(); ++f) {
    if (joins(source, scene.joints[f].parameters, i, j)) family = static_cast<int>(f);
  }
  return family;
}

extern template void check_fit(const Scene&, const BlockSource<2>&, const Teuchos::Comm<int>&);
extern template void check_fit(const Scene&, const BlockSource<3>&, const Teuchos::Comm<int>&);
extern template bool is_there(const Scene&, const BlockSource<2>&, const Block<2>&, std::size_t);
extern template bool is_there(const Scene&, const BlockSource<3>&, const Block<3>&, std::size_t);

}  // namespace voussoir
