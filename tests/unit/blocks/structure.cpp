// The part of a structure a rank works on: complete where it owns, and the same numbers as on one rank.
#include "blocks/structure.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <set>

#include "blocks/assembly.hpp"
#include "blocks/supports.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Four courses of four blocks in running bond: ends of head joints meet a third block.
std::unique_ptr<BlockSource<2>> wall() {
  WallParameters p;
  p.courses = p.blocks_per_course = 4;
  return make_wall(p);
}

/// Stones of several kinds.
Material alternating(const Block<2>& block) { return {1e9 * (1 + block.id % 3), 0.1 * (1 + block.id % 2), 2000}; }

/// The first node of each block, and the total at the end.
std::vector<NodeId> first_nodes(const BlockSource<2>& source) {
  std::vector<NodeId> first{0};
  for (BlockId b = 0; b < source.block_count(); ++b) first.push_back(first.back() + source.node_count(b));
  return first;
}

Structure<2> wall_structure(const BlockSource<2>& source, const Comm& comm) {
  return Structure<2>(source, share_out(source, *comm), {Plane::stress, 0.4}, alternating, comm);
}

TEUCHOS_UNIT_TEST(Structure, TheHaloIsEveryNeighbourOfOwnedBlocksAndNothingElse) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone());
  const auto share = share_out(*source, *everyone());
  const std::vector<BlockId>& owned = share.owned;
  std::set<BlockId> halo;
  for (const BlockId b : owned)
    for (const auto& beside : source->neighbours(b)) halo.insert(beside.block);
  for (BlockId b : owned) halo.erase(b);
  std::vector<BlockId> ids, expected = owned;
  expected.insert(expected.end(), halo.begin(), halo.end());
  for (const auto& b : s.blocks()) ids.push_back(b.mesh.id);
  TEST_COMPARE_ARRAYS(ids, expected);
  TEST_EQUALITY(s.owned_blocks(), int(owned.size()));
  for (BlockId b = 0; b < source->block_count(); ++b) {
    const int local = s.local_block(b);
    TEST_EQUALITY(local >= 0, std::count(ids.begin(), ids.end(), b) == 1);
    if (local >= 0) TEST_EQUALITY(s.blocks()[local].mesh.id, b);
  }
}

TEUCHOS_UNIT_TEST(Structure, EveryNodeIsOwnedByOneRankAndNumberedAsOnOneRank) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone());
  std::vector<long long> owners(s.total_nodes(), 0), all(s.total_nodes());
  for (int i = 0; i < s.owned_nodes(); ++i) owners[s.node_id()[i]] += 1;
  Teuchos::reduceAll(*everyone(), Teuchos::REDUCE_SUM, int(all.size()), owners.data(), all.data());
  TEST_ASSERT(all == std::vector<long long>(s.total_nodes(), 1));
  const auto first = first_nodes(*source);
  for (int i = 0; i < s.nodes(); ++i) {
    const auto& b = s.blocks()[s.block_of_node()[i]];
    const auto within = s.node_id()[i] - first[b.mesh.id];
    TEST_EQUALITY(within, NodeId(i - b.first_local));
    TEST_ASSERT(s.position()[i] == source->block(b.mesh.id).position[within]);
  }
}

TEUCHOS_UNIT_TEST(Structure, CopiesAtOwnedVerticesAreCompleteAlsoWhereThreeBlocksMeet) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone());
  const auto first = first_nodes(*source);
  std::map<VertexId, std::vector<NodeId>> copies_of;
  std::map<NodeId, VertexId> vertex_of;
  for (BlockId b = 0; b < source->block_count(); ++b) {
    const auto block = source->block(b);
    for (std::size_t i = 0; i < block.vertex.size(); ++i) {
      copies_of[block.vertex[i]].push_back(first[b] + NodeId(i));
      vertex_of[first[b] + NodeId(i)] = block.vertex[i];
    }
  }
  std::vector<int> groups_with(s.owned_nodes(), 0);
  long long junctions = 0;
  for (std::size_t g = 0; g + 1 < s.copies_start().size(); ++g) {
    std::vector<NodeId> ids;
    for (int k = s.copies_start()[g]; k < s.copies_start()[g + 1]; ++k) {
      ids.push_back(s.node_id()[s.copy()[k]]);
      if (s.copy()[k] < s.owned_nodes()) ++groups_with[s.copy()[k]];
    }
    TEST_ASSERT(ids == copies_of[vertex_of[ids.front()]]);
    if (ids.size() == 3 && s.copy()[s.copies_start()[g]] < s.owned_nodes()) ++junctions;
  }
  TEST_ASSERT(groups_with == std::vector<int>(s.owned_nodes(), 1));
  // Three bed planes, each met by 3 head joints of one course and 4 of the other.
  TEST_EQUALITY(sum_over_ranks(*everyone(), junctions), 21);
}

TEUCHOS_UNIT_TEST(Structure, StiffnessTimesDisplacementIsThatOfOneRank) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone()), one = wall_structure(*source, alone());
  const auto forces = [](const Structure<2>& part) {
    std::vector<double> u, f;
    for (int i = 0; i < part.nodes(); ++i)
      for (int c = 0; c < 2; ++c) u.push_back(noise(2 * part.node_id()[i] + c));
    part.apply_stiffness(u, f);
    return f;
  };
  const auto f = forces(s), expected = forces(one);
  TEST_EQUALITY(NodeId(one.nodes()), s.total_nodes());
  for (int i = 0; i < s.nodes(); ++i)  // the same sums in the same order: equal to the last bit
    for (int c = 0; c < 2; ++c) TEST_EQUALITY(f[2 * i + c], expected[2 * s.node_id()[i] + c]);
}

TEUCHOS_UNIT_TEST(Structure, EachBlockIsMadeOfItsOwnMaterialAndAsThickAsTheModel) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone());
  for (const auto& b : s.blocks()) {
    const auto m = alternating(b.mesh);
    TEST_EQUALITY(b.material.young_modulus, m.young_modulus);
    const auto k = block_stiffness(b.mesh, m, Plane::stress, 1.0);
    TEST_EQUALITY(k.value.size(), b.stiffness->value.size());
    TEST_FLOATING_EQUALITY(b.stiffness->value[0], 0.4 * k.value[0], 1e-14);
  }
}

TEUCHOS_UNIT_TEST(Structure, ItsSizeIsTheDiagonalOfAllBlocksOnEveryRank) {
  const auto source = wall();
  TEST_FLOATING_EQUALITY(wall_structure(*source, everyone()).size(), std::hypot(2.0, 1.0), 1e-15);
}

TEUCHOS_UNIT_TEST(Structure, GhostNodesTakeTheValuesOfTheirOwners) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone());
  std::vector<double> values(s.nodes(), -1.0);
  for (int i = 0; i < s.owned_nodes(); ++i) values[i] = noise(s.node_id()[i]);
  s.node_exchange().update(values, 1);
  for (int i = 0; i < s.nodes(); ++i) TEST_EQUALITY(values[i], noise(s.node_id()[i]));
}

TEUCHOS_UNIT_TEST(Supports, HoldTheNamedComponentsOfTheNodesOfTheirFacetsAlsoInTheHalo) {
  const auto source = wall();
  const auto s = wall_structure(*source, everyone());
  const auto& sets = source->facet_sets();
  const int base = int(std::find(sets.begin(), sets.end(), "base") - sets.begin());
  for (const std::string components : {"x", "y", "xy"}) {
    std::vector<char> held(2 * s.nodes(), 0);
    hold(s, SupportParameters{"base", components}, base, held);
    for (int i = 0; i < s.nodes(); ++i)
      for (int c = 0; c < 2; ++c)
        TEST_EQUALITY(held[2 * i + c] != 0, s.position()[i][1] == 0 && components.find("xy"[c]) != std::string::npos);
  }
}

TEUCHOS_UNIT_TEST(Structure, StonesThatAreFollowedBearNoForcesAndStretchAsBefore) {
  const auto source = wall();
  auto s = wall_structure(*source, everyone());
  const Vector<2> centre{3, -1};
  const auto stretched = [&](double angle, double stretch) {
    std::vector<double> u;
    for (const auto& x : s.drawn_position()) {
      const Vector<2> r{(1 + stretch) * (x[0] - centre[0]), x[1] - centre[1]};
      const double c = std::cos(angle), t = std::sin(angle);
      u.push_back(c * r[0] - t * r[1] + centre[0] - x[0]);
      u.push_back(t * r[0] + c * r[1] + centre[1] - x[1]);
    }
    return u;
  };
  std::vector<double> small, forces;
  s.internal_forces(stretched(0, 1e-4), small);
  const double largest = *std::max_element(small.begin(), small.end());

  const double angle = 0.7;  // [rad] no small one
  TEST_FLOATING_EQUALITY(s.move_to(stretched(angle, 0)), angle, 1e-12);
  s.internal_forces(stretched(angle, 0), forces);
  for (double f : forces) TEST_COMPARE(std::abs(f), <, 1e-9 * largest);
  TEST_COMPARE(s.move_to(stretched(angle, 0)), <, 1e-12);

  s.move_to(stretched(angle, 1e-4));
  s.internal_forces(stretched(angle, 1e-4), forces);
  for (std::size_t i = 0; i < small.size(); i += 2) {
    TEST_COMPARE(std::abs(forces[i] - std::cos(angle) * small[i] + std::sin(angle) * small[i + 1]), <, 1e-9 * largest);
    TEST_COMPARE(std::abs(forces[i + 1] - std::sin(angle) * small[i] - std::cos(angle) * small[i + 1]), <,
                 1e-9 * largest);
  }
}

// In time a wall keeps two matrices of a stone, and one as it turns: each for all stones that are alike.
TEUCHOS_UNIT_TEST(Structure, MatricesInTheirPlaceAreSharedByWhatIsAlike) {
  const auto source = wall();
  auto s = wall_structure(*source, everyone());
  const auto shared = [](const Structure<2>& of) {
    std::set<const LocalCsr*> matrices;
    for (const auto& b : of.blocks()) matrices.insert(b.stiffness.get());
    return matrices.size();
  };
  TEST_COMPARE(shared(s), <, s.blocks().size());
  int made = 0;
  const auto twice = s.with_matrices([&](int b) {
    ++made;
    return sum(2.0, *s.blocks()[b].stiffness, 0.0, *s.blocks()[b].stiffness);
  });
  TEST_EQUALITY(shared(twice), shared(s));
  TEST_EQUALITY(std::size_t(made), shared(s));
  for (std::size_t b = 0; b < s.blocks().size(); ++b)
    TEST_EQUALITY(twice.blocks()[b].stiffness->value[0], 2 * s.blocks()[b].stiffness->value[0]);
  // Stones that have moved and not turned are as they were.
  const auto before = shared(s);
  s.move_to(std::vector<double>(2 * s.nodes(), 0.0));
  TEST_EQUALITY(shared(s), before);
}

}  // namespace
