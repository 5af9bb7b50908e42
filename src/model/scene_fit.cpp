#include "model/scene_fit.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "linalg/agree.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "linalg/refused_list.hpp"
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

/// What members of construction say of the blocks that a rank reads.
struct ToldOfBlocks {
  std::map<std::pair<int, int>, std::vector<std::string>> shared;  ///< names of stones of two members that differ
  std::vector<char> some;                                          ///< per stage: a block is there
};

template <int dim>
ToldOfBlocks told_of_blocks(const Scene& scene, const BlockSource<dim>& source, const BlockSpan& read) {
  ToldOfBlocks told;
  told.some.assign(scene.stages.size(), 0);
  const auto& members = scene.construction;
  for (BlockId n = read.from; n < read.to; ++n) {
    const auto block = source.block(n);
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        const auto &a = members[i].parameters, &b = members[j].parameters;
        const bool alike = a.appears == b.appears && a.disappears == b.disappears;
        if (!alike && in_set(source, block, a.blocks) && in_set(source, block, b.blocks))
          told.shared[{static_cast<int>(i), static_cast<int>(j)}].push_back(block.name);
      }
    for (std::size_t stage = 0; stage < told.some.size(); ++stage)
      if (!told.some[stage]) told.some[stage] = is_there(scene, source, block, stage);
  }
  return told;
}

/// A block has one time of being there. Collective.
void check_times(const Scene& scene, const ToldOfBlocks& told, const Teuchos::Comm<int>& comm) {
  const auto& members = scene.construction;
  const int count = static_cast<int>(members.size()), none = count * count;
  const auto first_pair =
      told.shared.empty() ? none : told.shared.begin()->first.first * count + told.shared.begin()->first.second;
  const int pair = least_over_ranks(comm, first_pair);
  if (pair == none) return;
  const auto found = told.shared.find({pair / count, pair % count});
  const auto stones = found == told.shared.end() ? std::vector<std::string>() : found->second;
  constexpr std::size_t shown = 5;
  const auto first = first_texts(comm, stones, shown);
  const auto all = total_over_ranks(comm, static_cast<long long>(stones.size()));
  const auto &a = members[pair / count], &b = members[pair % count];
  throw InputError(
      scene.file + ": scene > construction > " + b.name + "\n  says that its stones are there " +
      words_of(b.parameters) + ", where scene > construction > " + a.name + " says " + words_of(a.parameters) +
      ". Both hold " + list_of(first) +
      (all > static_cast<long long>(shown) ? " and " + std::to_string(all - shown) + " more" : "") +
      ", and a stone is there from one stage to another once.\n  Give appears and disappears of a stone in "
      "one member, or sets that share no stones.");
}

/// Every stage has a block. Collective.
void check_stages_have_blocks(const Scene& scene, const ToldOfBlocks& told, const Teuchos::Comm<int>& comm) {
  for (std::size_t stage = 0; stage < scene.stages.size(); ++stage) {
    if (any_of_ranks(comm, told.some[stage] != 0)) continue;
    std::vector<std::string> members;
    for (const auto& member : scene.construction) members.push_back(member.name);
    throw InputError(scene.file + ": scene > steps > stages > " + scene.stages[stage].name +
                     "\n  has no block: all have disappeared or have not appeared yet (scene > construction: " +
                     list_of(members) + ").\n  Leave the stage out, or let some blocks be there.");
  }
}

template <int dim>
void check_materials(const Scene& scene, const BlockSource<dim>& source, const BlockSpan& read) {
  for (BlockId b = read.from; b < read.to; ++b)
    if (const auto block = source.block(b); !has_material(scene, source, block))
      throw InputError(scene.file + ": scene > materials: no material for " + block.name +
                       ".\n  Every block needs one: no material names a set this block is in.\n"
                       "  Add one with blocks = \"all\" first; later ones override it.");
}

template <int dim>
void check_laws(const Scene& scene, const BlockSource<dim>& source, const BlockSpan& read) {
  for (BlockId b = read.from; b < read.to; ++b) {
    const auto block = source.block(b);
    for (const auto& beside : source.neighbours(b)) {
      if (beside.shared_vertices < dim) continue;
      const auto other = source.block(beside.block);
      if (family_of(scene, source, block, other) >= 0) continue;
      throw InputError(scene.file + ": scene > joints: no law for the joint between " + block.name + " and " +
                       other.name +
                       ".\n  Every joint needs one: no family names the sets of these blocks.\n"
                       "  Add one with between = \"all\" and = \"all\" first; later ones override it.");
    }
  }
}

/// Sets of a scene are sets of the mesh. Collective.
template <int dim>
void check_sets(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  const auto named = block_sets_named(scene);
  std::vector<int> there;
  for (const auto& name : named) there.push_back(name == "all" || source.block_sets().number_of(name) >= 0);
  there = largest_of_list(comm, there, WhyWhole{"sets of blocks that a scene names"});
  if (std::count(there.begin(), there.end(), 0) == 0) return check_names(scene, named, source.facet_sets());
  const auto all = names_of_block_sets(source, comm);
  on_first_rank(comm, [&] { check_names(scene, all, source.facet_sets()); });
}

/// Lists for libraries are such as these take. The same on every rank.
void check_lists(const Scene& scene, int dim) {
  if (const auto refused = refused_list(scene.solver, dim))
    throw InputError(scene.file + ": scene > solver > " + refused->key + "\n  is refused by " + refused->library +
                     ": " + refused->why +
                     "\n  Names, types and values are those of its manual; leave out what is not needed.");
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
void check_fit(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  check_lists(scene, dim);
  check_sets(scene, source, comm);
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  if (!scene.construction.empty()) {
    const auto told = told_of_blocks(scene, source, read);
    check_times(scene, told, comm);
    check_stages_have_blocks(scene, told, comm);
  }
  bool material_for_all = false, law_for_all = false;
  for (const auto& [name, material] : scene.materials) material_for_all |= material.blocks == "all";
  for (const auto& [name, law] : scene.joints) law_for_all |= law.between == "all" && law.and_ == "all";
  if (!material_for_all) agree(comm, [&] { check_materials(scene, source, read); });
  if (!law_for_all) {
    bring_neighbours(source, read, comm);
    agree(comm, [&] { check_laws(scene, source, read); });
  }
}

template void check_fit(const Scene&, const BlockSource<2>&, const Teuchos::Comm<int>&);
template void check_fit(const Scene&, const BlockSource<3>&, const Teuchos::Comm<int>&);
template bool is_there(const Scene&, const BlockSource<2>&, const Block<2>&, std::size_t);
template bool is_there(const Scene&, const BlockSource<3>&, const Block<3>&, std::size_t);

}  // namespace voussoir
