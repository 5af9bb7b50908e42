#include "loads/bearer.hpp"

#include <map>

#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/shared_warnings.hpp"

namespace voussoir {

namespace {

/// For a rank that can be asked of these stones.
template <int dim>
Warning among_several(const LoadSite<dim>& site, const std::string& what, const std::string& place,
                      const std::vector<BlockId>& stones, BlockId bearer) {
  std::vector<std::string> names, sets;
  std::map<int, int> count;  // of the stones in a set
  for (const BlockId stone : stones) {
    const auto block = site.source.block(stone);
    names.push_back(block.name);
    for (const int set : block.sets) ++count[set];
  }
  for (const auto& [set, stones_in_it] : count)
    if (stones_in_it == 1) sets.push_back(in_quotes(site.source.block_sets()[set]));
  return {what, site.where, "", static_cast<double>(stones.size()),
          place + " is on " + counted(stones.size(), "stone") + ", " + list_of(names) + "; " +
              site.source.block(bearer).name + " bears the load; say which one is meant by the key blocks, a set of " +
              "blocks that holds it alone" + (sets.empty() ? "" : ", such as " + list_of(sets, 3))};
}

}  // namespace

template <int dim>
Warnings warning_of_bearer(const LoadSite<dim>& site, const std::string& what, const std::string& place,
                           std::vector<BlockId> stones, BlockId bearer) {
  sort_unique(stones);
  if (stones.size() < 2) return {};
  const auto& comm = *site.structure.comm();
  site.source.bring(comm.getRank() == 0 ? stones : std::vector<BlockId>(), comm);
  return warnings_of_first_rank(comm, [&] { return Warnings{among_several(site, what, place, stones, bearer)}; });
}

template Warnings warning_of_bearer<2>(const LoadSite<2>&, const std::string&, const std::string&, std::vector<BlockId>,
                                       BlockId);
template Warnings warning_of_bearer<3>(const LoadSite<3>&, const std::string&, const std::string&, std::vector<BlockId>,
                                       BlockId);

}  // namespace voussoir
