#include "results/mesh_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "linalg/numbering.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// Round-off of a turned axis and more; less than an angle that anybody draws.
constexpr double leaning = 1e-6;

/// Things are numbered block by block, like nodes: the first of each owned block. Collective.
/// @param count  of a block
template <int dim, class Count>
std::vector<long long> first_of_each(const Structure<dim>& s, const Count& count) {
  std::vector<long long> blocks, counts;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    blocks.push_back(s.blocks()[b].mesh.id);
    counts.push_back(count(s.blocks()[b].mesh));
  }
  return first_numbers(blocks, counts, s.total_blocks(), *s.comm()).first;
}

/// Of each cell its kind and its corners.
template <int dim>
long long numbers_of_cells(const Block<dim>& block) {
  return std::accumulate(block.cells.begin(), block.cells.end(), 0LL,
                         [](long long sum, const Cell& cell) { return sum + 1 + cell.count; });
}

/// @param place  of the first in the list that MeshRows tells of
template <int dim>
void add_cells(const LocalBlock<dim>& block, long long number, long long place, MeshRows& rows) {
  for (const auto& cell : block.mesh.cells) {
    rows.cell.push_back(number++);
    rows.place_of_cell.push_back(std::exchange(place, place + 1 + cell.count));
    rows.corner_count.push_back(cell.count);
    rows.block_of_cell.push_back(block.mesh.id);
    for (int i = 0; i < cell.count; ++i) rows.corners.push_back(block.first_node + cell.node[i]);
  }
}

/// The sum of 1, 2 and 4 for x, y and z. What is held along a normal counts for every axis that the normal leans to.
int directions_held(const Held& held, int dim, std::size_t node) {
  int sum = 0;
  for (int c = 0; c < dim; ++c) {
    if (!held[dim * node + c]) continue;
    Vector<3> own{};
    own[c] = 1;
    const auto way = held.from_own(static_cast<int>(node), own);
    for (int d = 0; d < dim; ++d)
      if (std::abs(way[d]) > leaning) sum |= 1 << d;
  }
  return sum;
}

}  // namespace

template <int dim>
MeshRows mesh_rows(const BlockSource<dim>& source, const Structure<dim>& s, const Held& held) {
  MeshRows rows;
  rows.block_set_names = names_of_block_sets(source, *s.comm());
  std::size_t most = 0;
  for (int b = 0; b < s.owned_blocks(); ++b) most = std::max(most, s.blocks()[b].mesh.sets.size());
  rows.sets_of_a_block = static_cast<int>(largest_over_ranks(*s.comm(), static_cast<long long>(most)));
  const auto first = first_of_each(s, [](const auto& mesh) { return static_cast<long long>(mesh.cells.size()); });
  const auto first_place = first_of_each(s, [](const auto& mesh) { return numbers_of_cells(mesh); });
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    rows.block.push_back(block.mesh.id);
    rows.block_set.push_back(block.mesh.sets.empty() ? -1 : block.mesh.sets.front());
    for (int k = 0; k < rows.sets_of_a_block; ++k)
      rows.block_sets.push_back(k < static_cast<int>(block.mesh.sets.size()) ? block.mesh.sets[k] : -1);
    for (std::size_t i = 0; i < block.mesh.position.size(); ++i) {
      rows.node.push_back(block.first_node + static_cast<NodeId>(i));
      rows.block_of_node.push_back(block.mesh.id);
      rows.held.push_back(directions_held(held, dim, static_cast<std::size_t>(block.first_local) + i));
      rows.coordinates.insert(rows.coordinates.end(), block.mesh.position[i].begin(), block.mesh.position[i].end());
    }
    add_cells(block, first[b], first_place[b], rows);
  }
  return rows;
}

template MeshRows mesh_rows(const BlockSource<2>&, const Structure<2>&, const Held&);
template MeshRows mesh_rows(const BlockSource<3>&, const Structure<3>&, const Held&);

}  // namespace voussoir
