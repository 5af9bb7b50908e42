#include "linalg/groups.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "base/disjoint_sets.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

struct Label {
  long long thing, least;  ///< that is known to hang together with it
};

}  // namespace

std::vector<long long> least_of_group(const std::vector<long long>& mine, const std::vector<HangsWith>& pairs,
                                      const Teuchos::Comm<int>& comm) {
  const auto place = [&](long long thing) {
    const auto at = std::lower_bound(mine.begin(), mine.end(), thing);
    VOUSSOIR_EXPECT(at != mine.end() && *at == thing && "pairs: of things of this rank");
    return static_cast<int>(at - mine.begin());
  };
  DisjointSets here(mine.size());
  for (const auto& pair : pairs)
    if (pair.owner_of_other == comm.getRank()) here.unite(place(pair.mine), place(pair.other));
  std::vector<long long> least(mine);  // of the group of a root, which is the least that is here
  std::vector<char> is_new(mine.size(), 1);
  for (bool changed = true; changed;) {
    Post<Label> tell(comm);
    for (const auto& pair : pairs) {
      if (pair.owner_of_other == comm.getRank()) continue;
      const int root = here.root(place(pair.mine));
      if (is_new[root]) tell.add(pair.owner_of_other, {pair.other, least[root]});
    }
    std::fill(is_new.begin(), is_new.end(), 0);
    changed = false;
    for (const auto& label : std::move(tell).send_all()) {
      const int root = here.root(place(label.thing));
      if (label.least >= least[root]) continue;
      least[root] = label.least;
      is_new[root] = 1;
      changed = true;
    }
    changed = any_of_ranks(comm, changed);
  }
  std::vector<long long> all;
  for (std::size_t k = 0; k < mine.size(); ++k) all.push_back(least[here.root(static_cast<int>(k))]);
  return all;
}

}  // namespace voussoir
