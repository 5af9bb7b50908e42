// A drawing as blocks on every rank.
#include "drawings/drawing_source.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <filesystem>
#include <fstream>

#include "unit/drawings/drawn_walls.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A file on the first rank, there for all.
std::string file_with(const std::string& name, const std::string& text) {
  const auto comm = Tpetra::getDefaultComm();
  const auto path = (std::filesystem::current_path() / name).string();
  if (comm->getRank() == 0) std::ofstream(path) << text;
  comm->barrier();
  return path;
}

TEUCHOS_UNIT_TEST(DrawingSource, EveryRankIsBroughtTheBlocksOfTheFirst) {
  auto p = asked(0, 0.5);
  p.file = file_with("two.csv", "stone,x,y\na,0,0\na,1,0\na,1,1\na,0,1\nb,1,0\nb,2,0\nb,2,1\nb,1,1\n");
  const auto source = read_drawn_blocks(p, *Tpetra::getDefaultComm());
  TEST_EQUALITY(source->block_count(), 2);
  source->bring({0, 1}, *Tpetra::getDefaultComm());
  TEST_EQUALITY(source->block(1).position.size(), 9u);
  TEST_EQUALITY(graph_of(*source).shared_vertices.at(0), 3);
  TEST_EQUALITY(source->report().back(), "2 stones of quadrilaterals, 0 of triangles: 18 nodes, 8 cells");
  TEST_EQUALITY(source->picture().empty(), Tpetra::getDefaultComm()->getRank() != 0);
}

TEUCHOS_UNIT_TEST(DrawingSource, ErrorsAreThoseOfEveryRank) {
  auto p = asked();
  const auto error = [&] { return input_error([&] { read_drawn_blocks(p, *Tpetra::getDefaultComm()); }); };
  p.file = file_with("empty.csv", "\n");
  TEST_ASSERT(test::holds(error(), "Is empty") || test::holds(error(), "is empty"));
  p.file = file_with("none.geojson", "{\"type\": \"FeatureCollection\", \"features\": []}");
  TEST_ASSERT(test::holds(error(), "olds no stone"));
  p.file = "not there.csv";
  TEST_ASSERT(test::holds(error(), "annot be read"));
}

}  // namespace
