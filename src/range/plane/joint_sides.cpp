#include "range/plane/joint_sides.hpp"

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "mesh/facet_set.hpp"

namespace voussoir {
namespace {

constexpr std::size_t pairs_told = 3;  // a ring has dozens of joints with its fill; three show which set is at fault

/// Joints both sides of which a support or load has.
struct Sides {
  std::vector<std::pair<BlockId, BlockId>> stones;  ///< ascending, each pair once
  double length = 0;                                ///< [m] of all of them
};

Sides both_sides(const BlockSource<2>& source, const FacetsOfLoad& facets) {
  Sides sides;
  for (const auto& facet : two_sided_facets(source, facet_set(source, {facets.on, facets.blocks}))) {
    if (!facets.reaches(facet.x[0], facet.x[1])) continue;
    sides.length += facet.length();
    const auto pair = std::make_pair(facet.block_i, facet.block_j);
    if (sides.stones.empty() || sides.stones.back() != pair) sides.stones.push_back(pair);
  }
  return sides;
}

/// "the joint between surface 1 (bed) and surface 2 (stone)", and how many more.
std::string in_words(const BlockSource<2>& source, const Sides& sides) {
  const auto& pairs = sides.stones;
  std::string text = pairs.size() == 1 ? "the joint" : "the joints";
  for (std::size_t k = 0; k < std::min(pairs.size(), pairs_told); ++k)
    text += (k == 0 ? "" : ",") + std::string(" between ") + source.block(pairs[k].first).name + " and " +
            source.block(pairs[k].second).name;
  if (pairs.size() > pairs_told) text += " and " + std::to_string(pairs.size() - pairs_told) + " more";
  return text;
}

/// Sets of blocks that have one side of the joints and not the other, with the word "or" between them.
std::string sets_of_one_side(const BlockSource<2>& source, const Sides& sides) {
  std::set<int> one, both;
  for (const auto& [i, j] : sides.stones) {
    const auto a = source.block(i).sets, b = source.block(j).sets;
    for (const int set : a) (std::count(b.begin(), b.end(), set) ? both : one).insert(set);
    for (const int set : b) (std::count(a.begin(), a.end(), set) ? both : one).insert(set);
  }
  std::string text;
  for (const int set : one)
    if (!both.count(set)) text += (text.empty() ? "" : " or ") + in_quotes(source.block_sets()[set]);
  return text;
}

std::string how_to_say_it(const BlockSource<2>& source, const Sides& sides) {
  const std::string sets = sets_of_one_side(source, sides);
  if (!sets.empty()) return "say which side is meant: blocks = " + sets;
  return "say which side is meant by the key blocks, a set of blocks that holds one of the two stones: no set of this "
         "mesh does, so put one of them into a physical surface of its own";
}

/// The side that is named has facets.
void check_side(const std::string& where, const std::string& on, const std::string& blocks,
                const BlockSource<2>& source) {
  if (blocks.empty() || blocks == "all" || has_facets(source, facet_set(source, {on, blocks}))) return;
  throw InputError(where + " > blocks = " + in_quotes(blocks) + "\n  has no facet of " + in_quotes(on) +
                   " (the key says whose facets of the set are meant).\n"
                   "  Give a set of blocks on whose border that set lies, or leave the key out.");
}

}  // namespace

void check_sides(const Scene& scene, const BlockSource<2>& source) {
  for (const auto& [name, support] : scene.supports)
    check_side(scene.file + ": scene > supports > " + name, support.on, support.blocks, source);
  for (const auto& load : scene.loads) {
    const auto facets = load.facets();
    if (!facets) continue;
    const std::string where = scene.file + ": scene > loads > " + load.name;
    check_side(where, facets->on, facets->blocks, source);
    // The named sets of generators lie on the outside.
    if (!facets->adds_up || scene.mesh.type != MeshType::gmsh) continue;
    const auto sides = both_sides(source, *facets);
    if (sides.stones.empty()) continue;
    std::string advice = how_to_say_it(source, sides);
    advice[0] = 'S';
    throw InputError(where + " > on = " + in_quotes(facets->on) + "\n  has both sides of " + in_words(source, sides) +
                     ", so that the " + load.word() +
                     " would act on the stones of either side (twice what it says in all).\n  " + advice +
                     ". Where both are loaded on purpose give two loads.");
  }
}

Warnings warnings_of_sides(const Scene& scene, const BlockSource<2>& source) {
  Warnings all;
  if (scene.mesh.type != MeshType::gmsh) return all;
  const auto ask = [&](const std::string& what, const std::string& where, const FacetsOfLoad& facets,
                       const std::string& consequence) {
    if (facets.blocks == "all") return;
    const auto sides = both_sides(source, facets);
    if (sides.stones.empty()) return;
    all.push_back({what, scene.file + ": scene > " + where, "", sides.length,
                   "its set " + in_quotes(facets.on) + " has both sides of " + in_words(source, sides) + ", so that " +
                       consequence + "; " + how_to_say_it(source, sides) + ", or blocks = \"all\" for both"});
  };
  for (const auto& [name, support] : scene.supports) {
    FacetsOfLoad facets;
    facets.on = support.on;
    facets.blocks = support.blocks;
    ask("support_on_both_sides", "supports > " + name, facets,
        "the support holds both stones and nothing is left to the law of the joint");
  }
  for (const auto& load : scene.loads)
    if (const auto facets = load.facets(); facets && !facets->adds_up)
      ask("pressure_on_both_sides", "loads > " + load.name, *facets,
          "the " + load.word() + " pushes the stones apart and its resultant is zero");
  return all;
}

}  // namespace voussoir
