// The two sides of a curve between stones.
#include "mesh/facet_set.hpp"

#include "linalg/gather.hpp"
#include "mesh/block_list.hpp"
#include "mesh/mesh_check.hpp"
#include "unit/mesh/gmsh_files.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Of all ranks.
std::vector<TwoSidedFacet<2>> two_sided(const BlockSource<2>& source, const FacetNames& names) {
  const auto comm = Tpetra::getDefaultComm();
  return all_gather(two_sided_facets(source, facet_set(source, names), *comm), *comm, WhyWhole{"a test"});
}

TEUCHOS_UNIT_TEST(FacetSet, ACurveBetweenStonesHasTwoSidesUnlessBlocksAreNamed) {
  const auto source = read(geo("two_stones.geo"));  // 1 m x 1 m each, two cells along their joint
  const auto both = two_sided(*source, {"joint"});
  TEST_EQUALITY(both.size(), 2u);
  double length = 0;
  for (const auto& facet : both) {
    TEST_EQUALITY(facet.block_i, 0);
    TEST_EQUALITY(facet.block_j, 1);
    length += facet.size();
  }
  TEST_FLOATING_EQUALITY(length, 1.0, 1e-15);
  TEST_ASSERT(two_sided(*source, {"joint", "west"}).empty());
  TEST_EQUALITY(two_sided(*source, {"joint", "both"}).size(), 2u);
  TEST_EQUALITY(two_sided(*source, {"joint", "all"}).size(), 2u);
  TEST_ASSERT(two_sided(*source, {"base"}).empty());
}

TEUCHOS_UNIT_TEST(FacetSet, StonesMeshedApartHaveTwoSidesToo) {
  const auto source = read(geo("meshed_apart.geo"));  // the set names one of two coincident curves
  TEST_EQUALITY(two_sided(*source, {"bed"}).size(), 5u);
}

TEUCHOS_UNIT_TEST(FacetSet, HoldsOnlyTheStonesOfItsSide) {
  const auto source = read(geo("two_stones.geo"));
  TEST_ASSERT(has_facets(*source, facet_set(*source, {"base", "west"}), {0, 2}));
  TEST_ASSERT(!has_facets(*source, facet_set(*source, {"base", "west"}), {0, 0}));
  BlockList<2> list;
  for (BlockId b = 0; b < 2; ++b) list.blocks.push_back(source->block(b));
  list.block_sets = source->block_sets();
  list.facet_sets = source->facet_sets();
  for (VertexId& vertex : list.blocks[1].vertex) vertex += 1000;  // the stones are joined no more
  const auto apart = make_source<2>(list);
  TEST_EQUALITY(input_error([&] { check_supports(*apart, {"base"}, *Tpetra::getDefaultComm()); }), "");
  TEST_ASSERT(
      holds(input_error([&] { check_supports(*apart, {FacetNames("base", "west")}, *Tpetra::getDefaultComm()); }),
            "mesh: surface 4 (group 7, both) has neither support nor joint"));
}

}  // namespace
