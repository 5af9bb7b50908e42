// Blocks of a file of stones are the same on every rank, and so are errors.
#include "stones/stone_source.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <fstream>
#include <memory>
#include <numeric>
#include <set>

#include "blocks/shapes.hpp"
#include "linalg/reduce.hpp"
#include "stones/filled_stones.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

void write_obj(const std::string& name, const std::vector<StoneSurface>& stones) {
  std::ofstream file(name);
  file.precision(17);
  int first = 1;
  for (const auto& stone : stones) {
    file << "o " << stone.name << "\n";
    for (const auto& x : stone.points) file << "v " << x[0] << " " << x[1] << " " << x[2] << "\n";
    for (const auto& face : stone.faces) {
      file << "f";
      for (const int point : face) file << " " << first + point;
      file << "\n";
    }
    first += static_cast<int>(stone.points.size());
  }
}

TEUCHOS_UNIT_TEST(StoneSource, GivesEveryRankTheSameBlocks) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getRank() == 0) write_obj("corner.obj", corner());
  StonesParameters p;
  p.file = "corner.obj";
  const auto read = read_stone_blocks(p, *comm);
  TEST_EQUALITY(read->block_count(), 3);
  TEST_ASSERT(!read->report().empty());
  read->bring({0, 1, 2}, *comm);
  TEST_ASSERT((read->block_sets() == SetNames{"L", "inner", "below"}));
  double sum = 0;
  for (BlockId b = 0; b < 3; ++b) {
    const auto block = read->block(b);
    TEST_EQUALITY(read->node_count(b), static_cast<int>(block.position.size()));
    for (std::size_t n = 0; n < block.position.size(); ++n)
      sum += static_cast<double>(block.vertex[n]) + block.position[n][0];
  }
  TEST_EQUALITY(largest_over_ranks(*comm, sum), least_over_ranks(*comm, sum));
  TEST_EQUALITY(graph_of(*read).neighbour.size(), 6u);
}

/// The different stiffnesses of blocks, which every rank finds by itself.
std::size_t stiffnesses(const BlockSource<3>& source) {
  StiffnessOfShapes shapes(ModelParameters{});
  std::set<std::shared_ptr<const LocalCsr>> found;
  for (BlockId b = 0; b < source.block_count(); ++b)
    found.insert(shapes.of(source.block(b), Material{10e9, 0.2, 2000}).stiffness);
  return found.size();
}

std::unique_ptr<BlockSource<3>> read_all(const std::vector<StoneSurface>& stones, const StonesParameters& p,
                                         const Teuchos::Comm<int>& comm) {
  if (comm.getRank() == 0) write_obj(p.file, stones);
  auto source = read_stone_blocks(p, comm);
  std::vector<BlockId> all(stones.size());
  std::iota(all.begin(), all.end(), 0);
  source->bring(all, comm);
  return source;
}

// Joints straighten edges of quadratic cells: stones that touch others on other sides bend otherwise.
TEUCHOS_UNIT_TEST(StoneSource, StonesThatAreAlikeHaveOneStiffness) {
  const auto comm = Tpetra::getDefaultComm();
  StonesParameters p;
  p.file = "honeycomb.obj";
  p.element = StoneElement::linear;
  TEST_EQUALITY(stiffnesses(*read_all(honeycomb(5, 4), p, *comm)), 1u);
  p.element = StoneElement::quadratic;
  // Inside six neighbours; along the sides of the wall, at its corners and where columns end higher or lower there are
  // ten other sets of them.
  TEST_EQUALITY(stiffnesses(*read_all(honeycomb(6, 5), p, *comm)), 11u);
  std::vector<StoneSurface> boxes;
  for (int k = 0; k < 7; ++k)
    boxes.push_back(box("stone " + std::to_string(k), {0.1, 0, 0.3 * k}, {0.8, 0.4, 0.3 * (k + 1)}));
  p.file = "boxes.obj";
  const auto column = read_all(boxes, p, *comm);
  TEST_EQUALITY(column->block(3).cells[0].count, 8);
  TEST_EQUALITY(stiffnesses(*column), 1u);
}

bool are_equal(const Block<3>& one, const Block<3>& other) {
  const auto same_cell = [](const Cell& x, const Cell& y) { return x.node == y.node && x.count == y.count; };
  const auto same_facet = [](const TaggedFacet& x, const TaggedFacet& y) { return x.node == y.node && x.set == y.set; };
  return one.id == other.id && one.name == other.name && one.position == other.position && one.vertex == other.vertex &&
         one.folds == other.folds && one.sets == other.sets &&
         std::equal(one.cells.begin(), one.cells.end(), other.cells.begin(), other.cells.end(), same_cell) &&
         std::equal(one.facets.begin(), one.facets.end(), other.facets.begin(), other.facets.end(), same_facet);
}

// Ranks mesh polygons that the first one puts together, and fill the stones that they read. Stones of an arch are each
// of a shape of their own, those of a honeycomb are all of one, whose first stone one rank alone reads.
TEUCHOS_UNIT_TEST(StoneSource, BlocksAreTheSameWhoeverMeshesThem) {
  const auto comm = Tpetra::getDefaultComm();
  StonesParameters p;
  p.cells = StoneCells::tetrahedra;
  const std::vector<std::vector<StoneSurface>> drawings{arch(7), honeycomb(4, 3)};
  const std::vector<int> shapes{7, 1};
  for (std::size_t k = 0; k < drawings.size(); ++k) {
    const auto structure = structure_of(drawings[k], p);
    const auto alone = mesh_stones(structure);
    StoneShells shells;
    on_first_rank_meshed_by_all(*comm, [&](const PolygonMesher& mesher) { shells = shells_of(structure, mesher); });
    const auto by_all = filled_stones(handed_out(std::move(shells), *comm), *comm);
    out << by_all.quality.filled << " shapes\n";
    TEST_EQUALITY(by_all.quality.filled, alone.quality.filled);
    TEST_EQUALITY(by_all.quality.filled, shapes[k]);
    TEST_EQUALITY(by_all.quality.nodes, alone.quality.nodes);
    TEST_FLOATING_EQUALITY(by_all.quality.volume, alone.quality.volume, 1e-12);
    const auto stones = static_cast<BlockId>(drawings[k].size());
    const auto read = span_read_by(comm->getRank(), comm->getSize(), stones);
    TEST_EQUALITY(static_cast<BlockId>(by_all.list.blocks.size()), read.to - read.from);
    for (BlockId b = read.from; b < read.to; ++b)
      TEST_ASSERT(are_equal(by_all.list.blocks[b - read.from], alone.list.blocks[b]));
  }
}

TEUCHOS_UNIT_TEST(StoneSource, EveryRankIsTold) {
  const auto comm = Tpetra::getDefaultComm();
  const FlatDomain good{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 1.0}, crossed{{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, 1.0};
  // A polygon that fails on the last rank fails alone; the work goes on and may fail afterwards.
  const auto told = input_error([&] {
    on_first_rank_meshed_by_all(*comm, [&](const PolygonMesher& mesher) {
      const auto meshes = mesher({good, good, good, good, crossed});
      TEST_ASSERT(meshes[3].failure.empty() && meshes[3].triangles == meshes[0].triangles);
      if (!meshes[4].failure.empty()) throw InputError("the last polygon");
    });
  });
  TEST_EQUALITY(told, "the last polygon");
  // So may a rank amid the work, of which the first one then sees no end.
  const auto last_fails = [&] {
    if (comm->getRank() == comm->getSize() - 1) throw InputError("the last rank");
  };
  bool ended = false;
  const auto all_told = input_error([&] {
    on_first_rank_meshed_by_all(
        *comm,
        [&](const PolygonMesher& mesher) {
          mesher({good, good, good, good});
          ended = true;
        },
        [&](const std::vector<FlatDomain>& domains) {
          last_fails();
          return meshed(domains);
        });
  });
  TEST_EQUALITY(all_told, "the last rank");
  TEST_ASSERT(!ended);
}

TEUCHOS_UNIT_TEST(StoneSource, EveryRankIsToldOfStonesThatCannotBeFilled) {
  const auto comm = Tpetra::getDefaultComm();
  StonesParameters p;
  p.cells = StoneCells::tetrahedra;
  const auto fault = [&](const SurfaceFiller& fill) {
    StoneShells shells;
    on_first_rank_meshed_by_all(
        *comm, [&](const PolygonMesher& by_all) { shells = shells_of(structure_of(arch(7), p), by_all); });
    return input_error([&] { filled_stones(handed_out(std::move(shells), *comm), *comm, fill); });
  };
  const auto first_of_each_fails = fault([](const std::vector<ClosedMesh>& surfaces) {
    auto meshes = filled(surfaces);
    if (!meshes.empty()) meshes.front().failure = "for the sake of this test";
    return meshes;
  });
  const int failing = std::min(7, comm->getSize());
  TEST_ASSERT(holds(first_of_each_fails, std::to_string(failing) + " of 7 stones cannot be filled with cells:\n"
                                                                   "    stone voussoir 0: for the sake of this test"));
  const auto hollow = fault([](const std::vector<ClosedMesh>& surfaces) {
    auto meshes = filled(surfaces);
    for (auto& mesh : meshes) mesh.cells.pop_back();
    return meshes;
  });
  TEST_ASSERT(holds(hollow, "7 of 7 stones cannot be filled"));
}

// A support on such a set would hold the stone of that name too, or that stone in the place of the set.
TEUCHOS_UNIT_TEST(StoneSource, RefusesNamesThatMeanSets) {
  const auto comm = Tpetra::getDefaultComm();
  StonesParameters p;
  p.file = "named.obj";
  const auto refused = [&](const std::string& name) {
    auto stones = corner();
    stones[2].name = name;
    if (comm->getRank() == 0) write_obj(p.file, stones);
    return input_error([&] { read_stone_blocks(p, *comm); });
  };
  TEST_ASSERT(holds(refused("all"), "always means every stone"));
  TEST_ASSERT(holds(refused("one neighbour"), "always means all stones that touch one other"));
  TEST_EQUALITY(refused("supports"), "");  // no stone of an OBJ file is called a support
}

TEUCHOS_UNIT_TEST(StoneSource, TellsOfTheFileWhatIsToBeTold) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getRank() == 0) {
    std::ofstream file("repeated.stl");
    for (const double height : {0.0, 1.0}) {
      file << "solid x\n";
      const auto stone = box("x", {0, 0, height}, {1, 1, height + 1});
      for (const auto& face : stone.faces)
        for (const auto& corners : {std::array<int, 3>{0, 1, 2}, std::array<int, 3>{0, 2, 3}}) {
          file << "facet normal 0 0 0\nouter loop\n";
          for (const int k : corners) {
            const auto& x = stone.points[face[k]];
            file << "vertex " << x[0] << " " << x[1] << " " << x[2] << "\n";
          }
          file << "endloop\nendfacet\n";
        }
      file << "endsolid x\n";
    }
  }
  StonesParameters p;
  p.file = "repeated.stl";
  const auto read = read_stone_blocks(p, *comm);
  read->bring({0, 1}, *comm);
  TEST_ASSERT((read->block_sets() == SetNames{"x 1", "x 2", "one neighbour"}));
  const auto warnings = read->warnings();
  TEST_ASSERT(warnings.size() == 1 && warnings[0].what == "names_repeated");
}

TEUCHOS_UNIT_TEST(StoneSource, RefusesOnEveryRank) {
  const auto comm = Tpetra::getDefaultComm();
  auto stones = corner();
  stones[1].faces.pop_back();
  if (comm->getRank() == 0) write_obj("open.obj", stones);
  StonesParameters p;
  p.file = "open.obj";
  TEST_ASSERT(holds(input_error([&] { read_stone_blocks(p, *comm); }), "stone \"inner\" (open.obj, line "));
}

}  // namespace
