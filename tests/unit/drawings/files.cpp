// Drawings hold what they say, and what is wrong in them is told by line and place.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "drawings/curves.hpp"
#include "drawings/drawing_files.hpp"
#include "stones/stone_text.hpp"
#include "support/input_error.hpp"

namespace {

using namespace voussoir;
using test::holds;
using test::input_error;

TEUCHOS_UNIT_TEST(Csv, RowsOfAStoneAreItsCornersAndColumnsAreFoundByName) {
  const auto drawn =
      read_csv_stones("a.csv",
                      "\xEF\xBB\xBFset; Y ;stone;x\r\n# a comment\r\nring;0;a 1;0\r\nring;0;a 1;1\r\n\r\n"
                      "ring;1;a 1;1\r\n;0;2;1\n;0;2;2\n;1;2;2e0\n");
  TEST_EQUALITY(drawn.stones.size(), 2u);
  TEST_EQUALITY(drawn.stones[0].name, "a 1");
  TEST_EQUALITY(drawn.stones[0].origin, "a.csv, line 3");
  TEST_EQUALITY(drawn.stones[0].sets.at(0), "ring");
  TEST_ASSERT(drawn.stones[0].loops[0].corners == (Polygon{{0, 0}, {1, 0}, {1, 1}}));
  TEST_ASSERT(drawn.stones[1].sets.empty());
  TEST_ASSERT(drawn.stones[1].loops[0].corners == (Polygon{{1, 0}, {2, 0}, {2, 1}}));
}

TEUCHOS_UNIT_TEST(Csv, LinesEndInAnyWay) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto drawn =
        read_csv_stones("a.csv", "stone,x,y" + end + end + "a,0,0" + end + "a,1,0" + end + "a,1,1" + end);
    TEST_EQUALITY(drawn.stones.size(), 1u);
    TEST_EQUALITY(drawn.stones[0].origin, "a.csv, line 3");
    TEST_EQUALITY(drawn.stones[0].loops[0].corners.size(), 3u);
  }
}

TEUCHOS_UNIT_TEST(Csv, AHoleIsRowsWithANumberOfTheirOwn) {
  const auto drawn = read_csv_stones("a.csv",
                                     "stone,x,y,hole\na,0,0,\na,4,0,\na,4,4,\na,0,4,\na,1,1,1\na,2,1,1\na,2,2,1\n"
                                     "a,3,3,2\na,3.5,3,2\na,3.5,3.5,2\n");
  TEST_EQUALITY(drawn.stones.size(), 1u);
  TEST_EQUALITY(drawn.stones[0].loops.size(), 3u);
  TEST_EQUALITY(drawn.stones[0].loops[2].corners.size(), 3u);
}

TEUCHOS_UNIT_TEST(Csv, WhatIsWrongIsToldByLine) {
  const auto error = [](const std::string& text) { return input_error([&] { read_csv_stones("a.csv", text); }); };
  TEST_ASSERT(holds(error("stone,X [m],y\n"), "Line 1 has no column \"x\": its columns are stone, X [m], y"));
  TEST_ASSERT(holds(error("stone,x,y,x\n"), "two columns of one name: stone, x, y, x"));
  TEST_ASSERT(holds(error("1,0,0\n1,1,0\n"), "has no column \"stone\""));
  TEST_ASSERT(holds(error("stone,x,y\n"), "no row below its head"));
  TEST_ASSERT(holds(error("stone;x;y\na;0,5;1\n"), "Line 2 has \"0,5\" in the column x"));
  TEST_ASSERT(holds(error("stone;x;y\na;0,5;1\n"), "decimal points"));
  TEST_ASSERT(holds(error("stone,x,y\na,0,5,1\n"), "Line 2 has 4 words, where the head names 3 columns"));
  TEST_ASSERT(holds(error("stone,x,y\na,0\n"), "Line 2 has nothing in the column y"));
  TEST_ASSERT(holds(error("stone,x,y\na,nan,0\n"), "has \"nan\""));
  TEST_ASSERT(holds(error("stone,x,y\n,1,0\n"), "Line 2 names no stone"));
  TEST_ASSERT(
      holds(error("stone,x,y\na,0,0\nb,0,0\na,1,0\n"), "Line 4 goes on with stone \"a\", which begins in line 2"));
  TEST_ASSERT(holds(error("stone,x,y,set\na,0,0,r\na,1,0,q\n"), "is in the set \"q\", and the rows above \"r\""));
}

std::string dxf(const std::string& entities, const std::string& before = "") {
  return before + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

/// A polyline of pairs x, y, each with the bulge of the edge behind it.
std::string polyline(const std::vector<std::array<double, 3>>& corners, int flags = 1, const std::string& more = "") {
  std::string text =
      "0\nLWPOLYLINE\n8\nring\n90\n" + std::to_string(corners.size()) + "\n70\n" + std::to_string(flags) + "\n" + more;
  for (const auto& [x, y, bulge] : corners)
    text += "10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n42\n" + std::to_string(bulge) + "\n";
  return text;
}

TEUCHOS_UNIT_TEST(Dxf, ClosedPolylinesAreStonesAndTheirLayerIsASet) {
  const auto drawn = read_dxf_stones(
      "a.dxf",
      dxf(polyline({{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}}) +
              "0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n10\n9\n20\n9\n0\nVERTEX\n8\n0\n10\n5\n20\n0\n0\nVERTEX\n8\n0\n10\n6\n20"
              "\n0\n"
              "0\nVERTEX\n8\n0\n10\n6\n20\n7\n0\nSEQEND\n8\n0\n0\nTEXT\n1\nnot a stone\n0\nLINE\n10\n1\n20\n1\n",
          "0\r\nSECTION\r\n2\r\nHEADER\r\n9\r\n$INSUNITS\r\n70\r\n4\r\n0\r\nENDSEC\r\n"));
  TEST_EQUALITY(drawn.stones.size(), 2u);
  TEST_EQUALITY(drawn.unit, 1e-3);
  TEST_EQUALITY(drawn.stones[0].sets.at(0), "ring");
  TEST_ASSERT(drawn.stones[0].loops[0].corners == (Polygon{{0, 0}, {2, 0}, {2, 1}}));
  TEST_ASSERT(drawn.stones[1].sets.empty());
  TEST_ASSERT(drawn.stones[1].loops[0].corners == (Polygon{{5, 0}, {6, 0}, {6, 7}}));
  TEST_EQUALITY(drawn.unused.size(), 2u);
  TEST_EQUALITY(drawn.unused[0], "1 LINE");
}

TEUCHOS_UNIT_TEST(Dxf, LinesEndInAnyWay) {
  auto text = dxf(polyline({{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}}));
  std::replace(text.begin(), text.end(), '\n', '\r');
  TEST_EQUALITY(read_dxf_stones("a.dxf", text).stones.size(), 1u);
}

TEUCHOS_UNIT_TEST(Dxf, ABulgeIsAnArcInChordsOfFiveDegrees) {
  // A half circle of radius 1 above the line from (1, 0) to (-1, 0): bulge tan(180 / 4).
  const auto drawn = read_dxf_stones("a.dxf", dxf(polyline({{{1, 0, 1}, {-1, 0, 0}}})));
  const auto& loop = drawn.stones.at(0).loops.at(0);
  TEST_EQUALITY(loop.corners.size(), 37u);
  for (std::size_t k = 0; k < loop.corners.size(); ++k) {
    TEST_FLOATING_EQUALITY(norm(loop.corners[k]), 1.0, 1e-14);
    TEST_COMPARE(loop.corners[k][1], >=, 0.0);
    TEST_EQUALITY(loop.curved[k] != 0, k > 0 && k < 36);
  }
}

TEUCHOS_UNIT_TEST(Dxf, AnArcSeenFromEitherSideHasTheSamePoints) {
  DrawnLoop forth, back;
  add_bulge(forth, {0.3, 1.7}, {2.1, 2.4}, 0.31);
  add_bulge(back, {2.1, 2.4}, {0.3, 1.7}, -0.31);
  TEST_ASSERT(forth.corners.size() > 5);
  TEST_EQUALITY(forth.corners.size(), back.corners.size());
  for (std::size_t k = 0; k + 1 < forth.corners.size(); ++k)  // each without its first point
    TEST_COMPARE(norm(forth.corners[k] - back.corners[back.corners.size() - 2 - k]), <, 1e-14);
}

TEUCHOS_UNIT_TEST(Dxf, HolesGoToTheStoneAroundThemAndHiddenLayersAreLeftOut) {
  const std::string layers =
      "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nring\n70\n0\n62\n7\n0\nLAYER\n2\nnotes\n70\n0\n62\n-7\n"
      "0\nENDTAB\n0\nENDSEC\n";
  std::string hole = polyline({{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}}}), note = polyline({{{0, 0, 0}, {9, 9, 0}}}, 0);
  hole.replace(hole.find("ring"), 4, "Holes");
  note.replace(note.find("ring"), 4, "notes");
  const auto drawn =
      read_dxf_stones("a.dxf", dxf(hole + polyline({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}}) + note, layers));
  TEST_EQUALITY(drawn.stones.size(), 1u);
  TEST_EQUALITY(drawn.stones[0].loops.size(), 2u);
  TEST_ASSERT(holds(drawn.unused.at(0), "hidden layer \"notes\""));
  TEST_ASSERT(holds(input_error([&] { read_dxf_stones("a.dxf", dxf(hole)); }), "a hole (a.dxf, line "));
}

TEUCHOS_UNIT_TEST(Dxf, WhatIsWrongIsToldByLineAndPlace) {
  const auto error = [](const std::string& text) { return input_error([&] { read_dxf_stones("a.dxf", text); }); };
  const auto open = error(dxf(polyline({{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}}, 0)));
  TEST_ASSERT(holds(open, "Line 6 begins a polyline on layer \"ring\" that is not closed"));
  TEST_ASSERT(holds(open, "(0, 0) and (2, 1) are 2.23607 apart"));
  TEST_ASSERT(error(dxf(polyline({{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}}}, 0))).empty());  // ends where it began
  TEST_ASSERT(holds(error("AutoCAD Binary DXF\r\n\x1a"), "Is a binary DXF"));
  TEST_ASSERT(holds(error("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n"), "without EOF"));
  TEST_ASSERT(holds(error("a drawing\nof mine\n"), "line 1 has \"a drawing\" where the code of a group is wanted") ||
              holds(error("a drawing\nof mine\n"), "Line 1 has \"a drawing\" where the code of a group is wanted"));
  TEST_ASSERT(holds(error(dxf("0\nLWPOLYLINE\n8\nring\n70\n1\n10\n1,5\n")), "has \"1,5\" where a number is wanted"));
}

std::string geojson(const std::string& type, const std::string& coordinates, const std::string& properties = "{}") {
  return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )" + properties +
         R"(, "geometry": {"type": ")" + type + R"(", "coordinates": )" + coordinates + "}}]}";
}

TEUCHOS_UNIT_TEST(GeoJson, PolygonsHaveHolesAndSeveralOfAFeatureAreSeveralStones) {
  const std::string ring = "[[0,0],[4,0],[4,4],[0,4],[0,0]]", hole = "[[1,1],[1,2],[2,2],[1,1]]";
  const auto one = read_geojson_stones(
      "a.geojson", geojson("Polygon", "[" + ring + "," + hole + "]", R"({"name": "b", "layer": "ring", "height": 2})"));
  TEST_EQUALITY(one.stones.at(0).name, "b");
  TEST_EQUALITY(one.stones[0].sets.at(0), "ring");
  TEST_EQUALITY(one.stones[0].loops.size(), 2u);
  TEST_EQUALITY(one.stones[0].origin, "a.geojson, feature 1");
  const auto two = read_geojson_stones(
      "a.geojson", geojson("MultiPolygon", "[[" + ring + "],[" + hole + "]]", R"({"name": 7, "set": "ring"})"));
  TEST_EQUALITY(two.stones.size(), 2u);
  TEST_EQUALITY(two.stones[0].name, "7 (1)");
  TEST_EQUALITY(two.stones[1].name, "7 (2)");
  TEST_ASSERT(two.stones[1].sets == (std::vector<std::string>{"ring", "7"}));
}

TEUCHOS_UNIT_TEST(GeoJson, WhatIsWrongIsToldByFeature) {
  const auto error = [](const std::string& text) {
    return input_error([&] { read_geojson_stones("a.geojson", text); });
  };
  TEST_ASSERT(holds(error("{\"type\": \"FeatureCollection\","), "is no JSON") ||
              holds(error("{\"type\": \"FeatureCollection\","), "Is no JSON"));
  TEST_ASSERT(holds(error("[1, 2]"), "no type"));
  TEST_ASSERT(holds(error(geojson("LineString", "[[0,0],[1,1]]")), "eature 1 is a LineString"));
  TEST_ASSERT(
      holds(error(geojson("Polygon", "[[[0,0],[4,0],[4,4],[0,4]]]")), "(it begins at (0, 0) and ends at (0, 4))"));
  TEST_ASSERT(holds(error(geojson("Polygon", "[[[0,0],[4,\"a\"],[4,4],[0,0]]]")), "no two numbers"));
  TEST_ASSERT(holds(error(geojson("Polygon", "[]")), "without rings"));
}

TEUCHOS_UNIT_TEST(Text, WhatIsNoUtf8IsReadAsLatin1) {
  TEST_EQUALITY(as_utf8("Gew\xF6lbe"), "Gewölbe");
  TEST_EQUALITY(as_utf8("Gewölbe"), "Gewölbe");
}

}  // namespace
