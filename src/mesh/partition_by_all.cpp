#include "mesh/partition_by_all.hpp"

#include <ptscotch.h>
#include <cstdint>
#include <cstdio>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "base/words.hpp"
#include "linalg/agree.hpp"
#include "linalg/mpi_handle.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

/// Scotch counts in integers: a total of at most 1e9 leaves room below 2^31. A block heavier than the share of a rank
/// fills one by itself, however heavy it is.
std::vector<SCOTCH_Num> whole_weights(const std::vector<double>& weights, const Teuchos::Comm<int>& comm) {
  const double total = total_over_ranks(comm, std::accumulate(weights.begin(), weights.end(), 0.0));
  const double share = total / comm.getSize(), scale = std::min(1.0, 1e9 / total);
  std::vector<SCOTCH_Num> whole;
  for (const double weight : weights)
    whole.push_back(std::max<SCOTCH_Num>(1, static_cast<SCOTCH_Num>(std::min(weight, share) * scale)));
  return whole;
}

/// A graph and a strategy of Scotch, let go at the end of a scope. It works with one thread: with more, two of them
/// call MPI at the same time, which MPI has not been told of, and they wait for each other for ever.
struct OfScotch {
  SCOTCH_Context one_thread;
  SCOTCH_Dgraph graph, bound;
  SCOTCH_Strat strategy;
  explicit OfScotch(MPI_Comm comm)
      : made(SCOTCH_dgraphInit(&graph, comm) == 0 && SCOTCH_dgraphInit(&bound, comm) == 0) {
    SCOTCH_stratInit(&strategy);
    SCOTCH_contextInit(&one_thread);
    made = made && SCOTCH_contextThreadSpawn(&one_thread, 1, nullptr) == 0;
  }
  ~OfScotch() {
    SCOTCH_stratExit(&strategy);
    SCOTCH_dgraphExit(&bound);
    SCOTCH_dgraphExit(&graph);
    SCOTCH_contextExit(&one_thread);
  }
  OfScotch(const OfScotch&) = delete;
  OfScotch& operator=(const OfScotch&) = delete;
  bool made;
};

}  // namespace

std::vector<int> divided_by_all(const BlockGraph& rows, const std::vector<double>& vertex_weights,
                                const Teuchos::Comm<int>& comm) {
  const auto here = static_cast<SCOTCH_Num>(vertex_weights.size());
  std::vector<SCOTCH_Num> start(rows.start.begin(), rows.start.end());
  std::vector<SCOTCH_Num> neighbour(rows.neighbour.begin(), rows.neighbour.end());
  std::vector<SCOTCH_Num> edge_weight(rows.shared_vertices.begin(), rows.shared_vertices.end());
  auto vertex_weight = whole_weights(vertex_weights, comm);
  std::vector<SCOTCH_Num> part(vertex_weights.size(), 0);
  SCOTCH_randomReset();  // the same parts in every run
  bool done = false;
  {
    OfScotch scotch(mpi_handle(comm));
    const auto edges = static_cast<SCOTCH_Num>(neighbour.size());
    done = scotch.made &&
           SCOTCH_dgraphBuild(&scotch.graph, 0, here, here, start.data(), nullptr, vertex_weight.data(), nullptr, edges,
                              edges, neighbour.data(), nullptr, edge_weight.data()) == 0 &&
           SCOTCH_contextBindDgraph(&scotch.one_thread, &scotch.graph, &scotch.bound) == 0 &&
           SCOTCH_dgraphPart(&scotch.bound, comm.getSize(), &scotch.strategy, part.data()) == 0;
  }
  agree(comm, [&] {
    if (!done)
      throw std::runtime_error("PT-Scotch could not divide the blocks among " + counted(comm.getSize(), "rank") + ".");
  });
  return std::vector<int>(part.begin(), part.end());
}

}  // namespace voussoir
