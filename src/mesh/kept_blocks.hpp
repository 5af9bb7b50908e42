// Blocks in memory, of which equal parts are kept once: stones of a file that are alike share their cells and faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Lists that are equal byte by byte, kept once.
template <class T>
class SharedLists {
 public:
  /// The list that stands for all that are equal to it; it stays where it is.
  const std::vector<T>* add(std::vector<T> list) {
    list.shrink_to_fit();
    return &*lists_.insert(std::move(list)).first;
  }
  std::size_t size() const { return lists_.size(); }

 private:
  static_assert(std::has_unique_object_representations_v<T>, "no bytes between members");
  struct Less {
    bool operator()(const std::vector<T>& a, const std::vector<T>& b) const {
      if (a.size() != b.size()) return a.size() < b.size();
      return !a.empty() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) < 0;
    }
  };
  std::set<std::vector<T>, Less> lists_;
};

template <int dim>
class KeptBlocks {
 public:
  KeptBlocks() = default;
  KeptBlocks(const KeptBlocks&) = delete;  // blocks know their lists by address
  KeptBlocks& operator=(const KeptBlocks&) = delete;

  void add(Block<dim> block) {
    Kept kept;
    kept.cells = cells_.add(std::exchange(block.cells, {}));
    kept.curved = curved_.add(std::exchange(block.curved, {}));
    kept.facets = facets_.add(std::exchange(block.facets, {}));
    const BlockId id = block.id;
    kept.rest = std::move(block);
    blocks_.emplace(id, std::move(kept));
  }
  bool has(BlockId b) const { return blocks_.count(b) > 0; }
  /// Of blocks that have been added.
  Block<dim> operator[](BlockId b) const {
    const auto& kept = find(b);
    auto block = kept.rest;
    block.cells = *kept.cells;
    block.curved = *kept.curved;
    block.facets = *kept.facets;
    return block;
  }
  /// Its vertex per node.
  const std::vector<VertexId>& vertices(BlockId b) const { return find(b).rest.vertex; }
  /// How many lists of cells there are.
  std::size_t meshes() const { return cells_.size(); }

 private:
  struct Kept {
    Block<dim> rest;  ///< without the lists that follow
    const std::vector<Cell>* cells;
    const std::vector<std::array<int, 2>>* curved;
    const std::vector<TaggedFacet>* facets;
  };
  const Kept& find(BlockId b) const {
    const auto found = blocks_.find(b);
    VOUSSOIR_CHECK(found != blocks_.end() && "a block that was not brought to this rank");
    return found->second;
  }

  SharedLists<Cell> cells_;
  SharedLists<std::array<int, 2>> curved_;
  SharedLists<TaggedFacet> facets_;
  std::map<BlockId, Kept> blocks_;
};

}  // namespace voussoir
