#include "model/scene_fit.hpp"

#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/scene_reader.hpp"

namespace voussoir {
namespace {

template <int dim>
bool has_material(const Scene& scene, const BlockSource<dim>& source, const Block<dim>& block) {
  for (const auto& [name, material] : scene.materials)
    if (in_set(source, block, material.blocks)) return true;
  return false;
}

std::size_t number_of(const Scene& scene, const std::string& stage) {
  std::size_t k = 0;
  while (scene.stages[k].name != stage) ++k;  // the check of the scene has found it
  return k;
}

std::string words_of(const ConstructionParameters& c) {
  std::string words = c.appears.empty() ? "from the start" : "from " + in_quotes(c.appears);
  return words + (c.disappears.empty() ? " on" : " until " + in_quotes(c.disappears));
}

/// A block has one time of being there.
template <int dim>
void check_times(const Scene& scene, const std::vector<Block<dim>>& blocks, const BlockSource<dim>& source) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> shared;  // stones of two members that differ
  const auto& members = scene.construction;
  for (const auto& block : blocks)
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        const auto &a = members[i].parameters, &b = members[j].parameters;
        const bool alike = a.appears == b.appears && a.disappears == b.disappears;
        if (!alike && in_set(source, block, a.blocks) && in_set(source, block, b.blocks))
          shared[{i, j}].push_back(block.name);
      }
  if (shared.empty()) return;
  const auto& [pair, stones] = *shared.begin();
  const auto &a = members[pair.first], &b = members[pair.second];
  constexpr std::size_t shown = 5;
  std::vector<std::string> first(stones.begin(), stones.begin() + static_cast<long>(std::min(shown, stones.size())));
  throw InputError(
      scene.file + ": scene > construction > " + b.name + "\n  says that its stones are there " +
      words_of(b.parameters) + ", where scene > construction > " + a.name + " says " + words_of(a.parameters) +
      ". Both hold " + list_of(first) +
      (stones.size() > shown ? " and " + std::to_string(stones.size() - shown) + " more" : "") +
      ", and a stone is there from one stage to another once.\n  Give appears and disappears of a stone in "
      "one member, or sets that share no stones.");
}

/// Every stage has a block.
template <int dim>
void check_stages_have_blocks(const Scene& scene, const std::vector<Block<dim>>& blocks,
                              const BlockSource<dim>& source) {
  for (std::size_t stage = 0; stage < scene.stages.size(); ++stage) {
    bool some = false;
    for (const auto& block : blocks) some |= is_there(scene, source, block, stage);
    if (some) continue;
    std::vector<std::string> members;
    for (const auto& member : scene.construction) members.push_back(member.name);
    throw InputError(scene.file + ": scene > steps > stages > " + scene.stages[stage].name +
                     "\n  has no block: all have disappeared or have not appeared yet (scene > construction: " +
                     list_of(members) + ").\n  Leave the stage out, or let some blocks be there.");
  }
}

template <int dim>
void check_construction(const Scene& scene, const BlockSource<dim>& source) {
  if (scene.construction.empty()) return;
  std::vector<Block<dim>> blocks;
  for (BlockId b = 0; b < source.block_count(); ++b) blocks.push_back(source.block(b));
  check_times(scene, blocks, source);
  check_stages_have_blocks(scene, blocks, source);
}

}  // namespace

template <int dim>
bool is_there(const Scene& scene, const BlockSource<dim>& source, const Block<dim>& block, std::size_t stage) {
  VOUSSOIR_EXPECT(stage < scene.stages.size() && "stage: one of the scene");
  for (const auto& [name, c] : scene.construction) {
    if (!in_set(source, block, c.blocks)) continue;
    if (!c.appears.empty() && stage < number_of(scene, c.appears)) return false;
    if (!c.disappears.empty() && stage >= number_of(scene, c.disappears)) return false;
  }
  return true;
}

template <int dim>
void check_fit(const Scene& scene, const BlockSource<dim>& source) {
  check_names(scene, source.block_sets(), source.facet_sets());
  check_construction(scene, source);
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

template void check_fit(const Scene&, const BlockSource<2>&);
template void check_fit(const Scene&, const BlockSource<3>&);
template bool is_there(const Scene&, const BlockSource<2>&, const Block<2>&, std::size_t);
template bool is_there(const Scene&, const BlockSource<3>&, const Block<3>&, std::size_t);

}  // namespace voussoir
