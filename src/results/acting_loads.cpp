#include "results/acting_loads.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "model/loads_at_work.hpp"

namespace voussoir {
namespace {

/// Rows are numbered by load and node, so that a table does not show how many ranks wrote it. Collective.
std::vector<long long> numbers_of(const LoadRows& rows, const Teuchos::Comm<int>& comm) {
  std::vector<std::array<long long, 2>> mine;
  for (std::size_t k = 0; k < rows.node.size(); ++k) mine.push_back({rows.load_of[k], rows.node[k]});
  auto all = all_gather(mine, comm, {"nodes of the edges and faces that loads act on, a small part of all"});
  std::sort(all.begin(), all.end());
  std::vector<long long> numbers;
  for (const auto& row : mine) numbers.push_back(std::lower_bound(all.begin(), all.end(), row) - all.begin());
  return numbers;
}

}  // namespace

LoadRows acting_loads(const Model& model, const std::map<std::string, double>& factors, double time) {
  const auto& s = model.structure();
  const auto& absent = model.absent();
  const int dim = model.components();
  LoadRows rows;
  model.loads_at_work().each_acting(factors, time, s, [&](const ActingLoad& load) {
    const int number = static_cast<int>(rows.name.size());
    rows.name.push_back(load.name);
    rows.type.push_back(load.type);
    rows.factor.push_back(load.factor);
    rows.of_stones.push_back(load.of_stones);
    std::array<double, 3> total{};
    for (int i = 0; i < s.owned_nodes(); ++i) {
      const double* force = &load.force.of_nodes[static_cast<std::size_t>(dim) * i];
      if (std::all_of(force, force + dim, [](double f) { return f == 0; })) continue;
      if (!absent.empty() && absent[s.block_of_node()[i]]) continue;
      for (int c = 0; c < dim; ++c) total[c] += force[c];
      if (load.of_stones) continue;
      rows.load_of.push_back(number);
      rows.node.push_back(s.node_id()[i]);
      rows.force.insert(rows.force.end(), force, force + dim);
    }
    const auto all = total_of_each(*s.comm(), total);
    rows.total.insert(rows.total.end(), all.begin(), all.begin() + dim);
  });
  rows.row = numbers_of(rows, *s.comm());
  return rows;
}

}  // namespace voussoir
