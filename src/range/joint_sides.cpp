#include "range/joint_sides.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "linalg/agree.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {
namespace {

constexpr std::size_t pairs_told = 3;  // a ring has dozens of joints with its fill; three show which set is at fault

/// Joints both sides of which a support or load has.
struct Sides {
  std::vector<std::pair<BlockId, BlockId>> stones;  ///< of those whose lower one this rank reads: ascending, each once
  long long joints = 0;                             ///< of all ranks
  double size = 0;                                  ///< [m] length of all of them, in space [m2] area
};

/// Corners of the box around a facet, as loads ask for them.
template <int dim>
std::pair<Vector<3>, Vector<3>> box_of(const TwoSidedFacet<dim>& facet) {
  constexpr double no_width = 1e-9;  // of its size, as for the facets that loads act on
  const auto in_order = [](const Vector<dim>& x) {
    if constexpr (dim == 2)
      return Vector<3>{x[0], 0, x[1]};
    else
      return x;
  };
  auto low = in_order(facet.x[0]), high = low;
  for (const auto& corner : facet.x) {
    const auto x = in_order(corner);
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], x[c]);
      high[c] = std::max(high[c], x[c]);
    }
  }
  if (dim == 3 && !(std::abs(facet.normal()[dim - 1]) > no_width * facet.size())) high[0] = low[0];
  return {low, high};
}

/// Afterwards a rank can be asked of the stones it has. Collective.
template <int dim>
Sides both_sides(const BlockSource<dim>& source, const FacetsOfLoad& facets, const Teuchos::Comm<int>& comm) {
  Sides sides;
  double size = 0;
  std::vector<BlockId> beyond;
  for (const auto& facet : two_sided_facets(source, facet_set(source, {facets.on, facets.blocks}), comm)) {
    const auto box = box_of(facet);
    if (!facets.reaches(box.first, box.second)) continue;
    size += facet.size();
    const auto pair = std::make_pair(facet.block_i, facet.block_j);
    if (sides.stones.empty() || sides.stones.back() != pair) sides.stones.push_back(pair);
    beyond.push_back(facet.block_j);
  }
  sides.size = total_over_ranks(comm, size);
  sides.joints = total_over_ranks(comm, static_cast<long long>(sides.stones.size()));
  sort_unique(beyond);
  source.bring(beyond, comm);
  return sides;
}

/// "the joint between surface 1 (bed) and surface 2 (stone)", and how many more. Collective.
template <int dim>
std::string in_words(const BlockSource<dim>& source, const Sides& sides, const Teuchos::Comm<int>& comm) {
  std::vector<std::string> mine;
  for (const auto& [i, j] : sides.stones)
    if (mine.size() < pairs_told) mine.push_back(source.block(i).name + " and " + source.block(j).name);
  std::string text = sides.joints == 1 ? "the joint" : "the joints";
  const auto told = first_texts(comm, mine, pairs_told);
  for (std::size_t k = 0; k < told.size(); ++k) text += (k == 0 ? "" : ",") + std::string(" between ") + told[k];
  const auto more = sides.joints - static_cast<long long>(told.size());
  if (more > 0) text += " and " + std::to_string(more) + " more";
  return text;
}

/// Sets that hold the stone on one side of each of the joints and not that on the other, with the word "or" between
/// them. Collective.
template <int dim>
std::string sets_of_one_side(const BlockSource<dim>& source, const Sides& sides, const Teuchos::Comm<int>& comm) {
  const auto of_one_side = [&](const std::pair<BlockId, BlockId>& pair) {
    const auto a = source.block(pair.first).sets, b = source.block(pair.second).sets;
    std::vector<int> sets;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sets));
    std::vector<std::string> names;
    for (const int set : sets) names.push_back(source.block_sets()[set]);
    return names;
  };
  std::vector<std::string> candidates;  // those of the first joint: what is of one side of all is of one of that
  const int first = least_over_ranks(comm, sides.stones.empty() ? comm.getSize() : comm.getRank());
  if (comm.getRank() == first) candidates = of_one_side(sides.stones.front());
  const auto most = total_over_ranks(comm, static_cast<long long>(candidates.size()));
  candidates = first_texts(comm, candidates, static_cast<std::size_t>(most));
  std::vector<long long> joints(candidates.size(), 0);
  for (const auto& pair : sides.stones) {
    const auto names = of_one_side(pair);
    for (std::size_t k = 0; k < candidates.size(); ++k)
      joints[k] += std::count(names.begin(), names.end(), candidates[k]);
  }
  joints = total_of_list(comm, joints, WhyWhole{"sets of one stone"});
  std::string text;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (joints[k] == sides.joints) text += (text.empty() ? "" : " or ") + in_quotes(candidates[k]);
  return text;
}

/// Collective.
template <int dim>
std::string how_to_say_it(const BlockSource<dim>& source, const Sides& sides, const Teuchos::Comm<int>& comm) {
  const std::string sets = sets_of_one_side(source, sides, comm);
  if (!sets.empty()) return "say which side is meant: blocks = " + sets;
  return std::string(
             "say which side is meant by the key blocks, a set of blocks that holds one of the two stones: no "
             "set of this mesh does, so ") +
         (dim == 2 ? "put one of them into a physical surface of its own" : "put one of them into a group of its own");
}

/// The side that is named has facets. Collective.
template <int dim>
void check_side(const std::string& where, const std::string& on, const std::string& blocks,
                const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  if (blocks.empty() || blocks == "all") return;
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  if (any_of_ranks(comm, has_facets(source, facet_set(source, {on, blocks}), read))) return;
  throw InputError(where + " > blocks = " + in_quotes(blocks) + "\n  has no facet of " + in_quotes(on) +
                   " (the key says whose facets of the set are meant).\n"
                   "  Give a set of blocks on whose border that set lies, or leave the key out.");
}

/// What would act on both sides of a joint. Collective.
template <int dim>
void refuse_both_sides(const LoadParameters& load, const std::string& where, const FacetsOfLoad& facets,
                       const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  const auto sides = both_sides(source, facets, comm);
  if (sides.joints == 0) return;
  const std::string joints = in_words(source, sides, comm);
  std::string advice = how_to_say_it(source, sides, comm);
  advice[0] = 'S';
  throw InputError(where + " > on = " + in_quotes(facets.on) + "\n  has both sides of " + joints + ", so that the " +
                   load.word() + " would act on the stones of either side (twice what it says in all).\n  " + advice +
                   ". Where both are loaded on purpose give two loads.");
}

}  // namespace

template <int dim>
void check_sides(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  for (const auto& [name, support] : scene.supports)
    check_side(scene.file + ": scene > supports > " + name, support.on, support.blocks, source, comm);
  for (const auto& load : scene.loads) {
    const auto facets = load.facets();
    if (!facets) continue;
    const std::string where = scene.file + ": scene > loads > " + load.name;
    check_side(where, facets->on, facets->blocks, source, comm);
    // The named sets of generators lie on the outside.
    if (facets->adds_up && scene.mesh.from_file()) refuse_both_sides(load, where, *facets, source, comm);
  }
}

template <int dim>
Warnings warnings_of_sides(const Scene& scene, const BlockSource<dim>& source, const Teuchos::Comm<int>& comm) {
  Warnings all;
  if (!scene.mesh.from_file()) return all;
  const auto ask = [&](const std::string& what, const std::string& where, const FacetsOfLoad& facets,
                       const std::string& consequence) {
    if (facets.blocks == "all") return;
    const auto sides = both_sides(source, facets, comm);
    if (sides.joints == 0) return;
    const std::string joints = in_words(source, sides, comm), advice = how_to_say_it(source, sides, comm);
    all.push_back({what, scene.file + ": scene > " + where, "", sides.size,
                   "its set " + in_quotes(facets.on) + " has both sides of " + joints + ", so that " + consequence +
                       "; " + advice + ", or blocks = \"all\" for both"});
  };
  for (const auto& [name, support] : scene.supports) {
    FacetsOfLoad facets;
    facets.on = support.on;
    facets.blocks = support.blocks;
    if ((dim == 3 || scene.mesh.type == MeshType::stones) && facets.on == "faces" && !facets.blocks.empty())
      continue;  // stones that are held whole
    ask("support_on_both_sides", "supports > " + name, facets,
        "the support holds both stones and nothing is left to the law of the joint");
  }
  for (const auto& load : scene.loads)
    if (const auto facets = load.facets(); facets && !facets->adds_up)
      ask("pressure_on_both_sides", "loads > " + load.name, *facets,
          "the " + load.word() + " pushes the stones apart and its resultant is zero");
  return all;
}

template void check_sides(const Scene&, const BlockSource<2>&, const Teuchos::Comm<int>&);
template void check_sides(const Scene&, const BlockSource<3>&, const Teuchos::Comm<int>&);
template Warnings warnings_of_sides(const Scene&, const BlockSource<2>&, const Teuchos::Comm<int>&);
template Warnings warnings_of_sides(const Scene&, const BlockSource<3>&, const Teuchos::Comm<int>&);

}  // namespace voussoir
