#include "step/scene_fit.hpp"

#include "base/error.hpp"
#include "scene/scene_reader.hpp"

namespace voussoir {
namespace {

template <int dim>
bool has_material(const Scene& scene, const BlockSource<dim>& source, const Block<dim>& block) {
  for (const auto& [name, material] : scene.materials)
    if (in_set(source, block, material.blocks)) return true;
  return false;
}

}  // namespace

template <int dim>
void check_fit(const Scene& scene, const BlockSource<dim>& source) {
  check_names(scene, source.block_sets(), source.facet_sets());
  bool material_for_all = false, law_for_all = false;
  for (const auto& [name, material] : scene.materials) material_for_all |= material.blocks == "all";
  for (const auto& [name, law] : scene.joints) law_for_all |= law.between == "all" && law.and_ == "all";
  if (material_for_all && law_for_all) return;
  std::vector<Block<dim>> blocks;
  for (BlockId b = 0; b < source.block_count(); ++b) blocks.push_back(source.block(b));
  for (const auto& block : blocks)
    if (!has_material(scene, source, block))
      throw InputError(scene.file + ": scene > materials: no material for " + block.name +
                       ".\n  Every block needs one: no material names a set this block is in.\n"
                       "  Add one with blocks = \"all\" first; later ones override it.");
  const auto& graph = source.graph();
  for (const auto& block : blocks)
    for (int k = graph.start[block.id]; k < graph.start[block.id + 1]; ++k) {
      const auto& other = blocks[graph.neighbour[k]];
      if (graph.shared_vertices[k] < dim || family_of(scene, source, block, other) >= 0) continue;
      throw InputError(scene.file + ": scene > joints: no law for the joint between " + block.name + " and " +
                       other.name +
                       ".\n  Every joint needs one: no family names the sets of these blocks.\n"
                       "  Add one with between = \"all\" and = \"all\" first; later ones override it.");
    }
}

template void check_fit<2>(const Scene&, const BlockSource<2>&);

}  // namespace voussoir
