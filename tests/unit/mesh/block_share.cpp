// What each rank has of a structure, and how it comes there when one rank has read it.
#include "mesh/block_share.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <map>
#include <set>

#include "linalg/gather.hpp"
#include "mesh/block_list.hpp"
#include "mesh/generators.hpp"
#include "mesh/read_blocks.hpp"

namespace {

using namespace voussoir;

std::unique_ptr<BlockSource<2>> wall() {
  WallParameters p;
  p.courses = 5;
  p.blocks_per_course = 6;
  return make_wall(p);
}

/// The stones of the wall, as if a file had them.
BlockList<2> read_by_first() {
  BlockList<2> list;
  if (Tpetra::getDefaultComm()->getRank() > 0) return list;
  const auto source = wall();
  for (BlockId b = 0; b < source->block_count(); ++b) list.blocks.push_back(source->block(b));
  list.block_sets = source->block_sets();
  list.facet_sets = source->facet_sets();
  list.warnings = {{"a_kind", "a place", "", 2.5, "a text"}};
  list.report = {"one line", ""};
  return list;
}

void check_share(const BlockSource<2>& source, const BlockShare& share, Teuchos::FancyOStream& out, bool& success) {
  const auto comm = Tpetra::getDefaultComm();
  std::map<BlockId, int> owner;
  struct Owned {
    BlockId block;
    int rank;
  };
  std::vector<Owned> mine;
  for (const BlockId b : share.owned) mine.push_back({b, comm->getRank()});
  for (const auto& [block, rank] : all_gather(mine, *comm, WhyWhole{"a test"}))
    TEST_ASSERT(owner.emplace(block, rank).second);  // one rank's
  TEST_EQUALITY(int(owner.size()), source.block_count());
  std::set<BlockId> halo;
  for (const BlockId b : share.owned)
    for (const auto& beside : source.neighbours(b))
      if (owner.at(beside.block) != comm->getRank()) halo.insert(beside.block);
  TEST_ASSERT(share.halo == std::vector<BlockId>(halo.begin(), halo.end()));
  TEST_EQUALITY(share.owner_of_halo.size(), share.halo.size());
  for (std::size_t k = 0; k < share.halo.size(); ++k) TEST_EQUALITY(share.owner_of_halo[k], owner.at(share.halo[k]));
  TEST_ASSERT(std::is_sorted(share.owned.begin(), share.owned.end()));
}

TEUCHOS_UNIT_TEST(BlockShare, EveryBlockIsOwnedOnceAndItsNeighboursAreKnown) {
  const auto comm = Tpetra::getDefaultComm();
  const auto source = wall();
  check_share(*source, share_out(*source, *comm), out, success);
  PartitionSettings by_all;
  by_all.most_on_first = 0;
  check_share(*source, share_out(*source, *comm, by_all), out, success);
}

TEUCHOS_UNIT_TEST(BlockShare, RanksReadAllBlocksBetweenThem) {
  const auto source = wall();
  for (const int ranks : {1, 2, 3, 7, 100}) {
    BlockId next = 0;
    for (int rank = 0; rank < ranks; ++rank) {
      const auto read = source->read_by(rank, ranks);
      TEST_EQUALITY(read.from, next);
      for (BlockId b = read.from; b < read.to; ++b) TEST_EQUALITY(source->reader_of(b, ranks), rank);
      next = read.to;
    }
    TEST_EQUALITY(next, source->block_count());
  }
}

TEUCHOS_UNIT_TEST(BlockShare, WhatOneRankHasReadIsBroughtToWhoOwnsItAndNoFurther) {
  const auto comm = Tpetra::getDefaultComm();
  const auto source = make_source_of_readers(handed_out(read_by_first(), *comm), *comm);
  const auto generated = wall();
  TEST_EQUALITY(source->block_count(), generated->block_count());
  TEST_ASSERT(source->facet_sets() == generated->facet_sets());
  const auto names = names_of_block_sets(*source, *comm);
  TEST_ASSERT(comm->getRank() == 0 ? SetNames(names) == generated->block_sets() : names.empty());
  TEST_EQUALITY(source->warnings().size(), 1u);
  TEST_EQUALITY(source->warnings().front().text, "a text");
  TEST_EQUALITY(source->report().size(), 2u);
  const auto share = share_out(*source, *comm);
  check_share(*source, share, out, success);
  TEST_ASSERT(share.owned == share_out(*generated, *comm).owned);
  std::set<BlockId> here(share.owned.begin(), share.owned.end());
  here.insert(share.halo.begin(), share.halo.end());
  const auto read = source->read_by(comm->getRank(), comm->getSize());
  for (BlockId b = read.from; b < read.to; ++b) here.insert(b);
  for (BlockId b = 0; b < source->block_count(); ++b) {
    if (here.count(b) == 0) {
      TEST_THROW(source->block(b), std::logic_error);
      continue;
    }
    const auto brought = source->block(b), made = generated->block(b);
    TEST_EQUALITY(brought.id, b);
    TEST_EQUALITY(brought.name, made.name);
    for (const int set : made.sets) TEST_EQUALITY(source->block_sets()[set], generated->block_sets()[set]);
    TEST_ASSERT(brought.position == made.position && brought.vertex == made.vertex && brought.sets == made.sets);
    TEST_EQUALITY(brought.cells.size(), made.cells.size());
    for (std::size_t k = 0; k < made.cells.size(); ++k) TEST_ASSERT(brought.cells[k].node == made.cells[k].node);
    TEST_EQUALITY(brought.facets.size(), made.facets.size());
    for (std::size_t k = 0; k < made.facets.size(); ++k)
      TEST_ASSERT(brought.facets[k].node == made.facets[k].node && brought.facets[k].set == made.facets[k].set);
    TEST_EQUALITY(source->node_count(b), generated->node_count(b));
    const auto beside = source->neighbours(b), expected = generated->neighbours(b);
    TEST_EQUALITY(beside.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      TEST_ASSERT(beside[k].block == expected[k].block && beside[k].shared_vertices == expected[k].shared_vertices);
  }
}

TEUCHOS_UNIT_TEST(BlockShare, ReadersFindTheEdgesThatBend) {
  const auto comm = Tpetra::getDefaultComm();
  ArchParameters arch;
  arch.voussoirs = 7;
  arch.cells = CellType::triangle;
  const auto generated = make_arch(arch);
  BlockList<2> list;
  for (BlockId b = 0; b < generated->block_count(); ++b) list.blocks.push_back(generated->block(b));
  list.block_sets = generated->block_sets();
  list.quadratic = true;
  const auto known_to_all = make_source(list);
  const auto source = make_source_of_readers(handed_out(list, *comm), *comm);
  const auto read = source->read_by(comm->getRank(), comm->getSize());
  for (BlockId b = read.from; b < read.to; ++b) {
    TEST_ASSERT(!source->block(b).curved.empty());
    TEST_ASSERT(source->block(b).curved == known_to_all->block(b).curved);
  }
}

}  // namespace
