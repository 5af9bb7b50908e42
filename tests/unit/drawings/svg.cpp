// Shapes of SVG with their transforms; paths letter by letter.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "drawings/drawing_files.hpp"
#include "drawings/svg_path.hpp"
#include "support/input_error.hpp"

namespace {

using namespace voussoir;
using test::input_error;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

DrawnFile read(const std::string& inside) {
  return read_svg_stones("a.svg",
                         "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + inside + "\n</svg>");
}

TEUCHOS_UNIT_TEST(SvgPath, LinesAbsoluteAndRelative) {
  const auto loops = loops_of_path("M1,2 h3 v1H1z m10-2l1 0 0,1.5.5-1Z");
  TEST_EQUALITY(loops.size(), 2u);
  TEST_ASSERT(loops[0].closed);
  TEST_ASSERT(loops[0].loop.corners == (Polygon{{1, 2}, {4, 2}, {4, 3}, {1, 3}}));
  TEST_ASSERT(loops[1].loop.corners == (Polygon{{11, 0}, {12, 0}, {12, 1.5}, {12.5, 0.5}}));
}

TEUCHOS_UNIT_TEST(SvgPath, AnArcIsThatOfTheCircle) {
  for (const bool sweep : {false, true}) {
    const auto loops = loops_of_path(std::string("M1 0A1 1 0 0 ") + (sweep ? "1" : "0") + "-1 0Z");
    for (const auto& x : loops.at(0).loop.corners) {
      TEST_FLOATING_EQUALITY(norm(x), 1.0, 1e-14);
      TEST_ASSERT(sweep ? x[1] > -1e-14 : x[1] < 1e-14);
    }
    TEST_EQUALITY(loops[0].loop.corners.size(), 37u);
  }
  // Of the two arcs about (0, 0) and (1, 1) from (1, 0) to (0, 1), flags written without blanks.
  const auto far = loops_of_path("M1 0A1 1 0 110 1Z");
  for (const auto& x : far.at(0).loop.corners) TEST_FLOATING_EQUALITY(norm(x - Vector<2>{1, 1}), 1.0, 1e-14);
}

TEUCHOS_UNIT_TEST(SvgPath, ABezierCurveGoesWhereItsFormulaGoes) {
  const auto loop = loops_of_path("M0 0C0 1 1 1 1 0Z").at(0).loop;
  const std::size_t middle = loop.corners.size() / 2;
  TEST_COMPARE(norm(loop.corners[middle] - Vector<2>{0.5, 0.75}), <, 1e-14);
  TEST_COMPARE(loop.corners.size(), >, 36u);
  // T and S turn the control point before about the point between.
  const auto smooth = loops_of_path("M0 0Q1 1 2 0T4 0Z").at(0).loop;
  for (const auto& x : smooth.corners)
    if (x[0] > 2.5 && x[0] < 3.5) TEST_COMPARE(x[1], <, -0.3);
}

TEUCHOS_UNIT_TEST(Svg, ShapesAreStonesWithNamesAndSets) {
  const auto drawn = read(
      "<g class=\"ring west\" id=\"group\"><rect id=\"r\" x=\"1\" y=\"2\" width=\"3\" height=\"4px\"/>\n"
      "<polygon id=\"p\" points=\"0,0 1,0 1 1\" class=\"top\"/></g><circle r=\"2\"/><text>words</text>"
      "<g style=\"display : none\"><rect width=\"1\" height=\"1\"/></g><defs><rect/></defs>");
  TEST_EQUALITY(drawn.stones.size(), 3u);
  TEST_EQUALITY(drawn.stones[0].name, "r");
  TEST_EQUALITY(drawn.stones[0].origin, "a.svg, line 3");
  TEST_ASSERT(drawn.stones[0].sets == (std::vector<std::string>{"ring", "west"}));
  TEST_ASSERT(drawn.stones[0].loops[0].corners == (Polygon{{1, 2}, {4, 2}, {4, 6}, {1, 6}}));
  TEST_ASSERT(drawn.stones[1].sets == (std::vector<std::string>{"ring", "west", "top"}));
  TEST_EQUALITY(drawn.stones[2].name, "");
  TEST_EQUALITY(drawn.unused.size(), 2u);  // text, hidden g
}

TEUCHOS_UNIT_TEST(Svg, TransformsApplyFromTheInnermostOutward) {
  const auto drawn = read(
      "<g transform=\"translate(10, 0) rotate(90)\"><g transform=\"scale(2)\"><rect x=\"1\" y=\"0\" width=\"1\" "
      "height=\"1\" transform=\"matrix(1 0 0 -1 0 0)\"/></g></g>");
  // (1, 0) -> (1, 0) -> (2, 0) -> (0, 2) -> (10, 2);  (2, -1) -> (4, -2) -> (2, 4) -> (12, 4)
  const auto& p = drawn.stones.at(0).loops.at(0).corners;
  TEST_COMPARE(norm(p[0] - Vector<2>{10, 2}), <, 1e-14);
  TEST_COMPARE(norm(p[2] - Vector<2>{12, 4}), <, 1e-14);
  const auto turned = read("<rect x=\"1\" y=\"1\" width=\"1\" height=\"1\" transform=\"rotate(180 1 1) skewX(45)\"/>");
  // (1, 2) -> skewed (3, 2) -> turned about (1, 1): (-1, 0)
  TEST_COMPARE(norm(turned.stones.at(0).loops.at(0).corners[3] - Vector<2>{-1, 0}), <, 1e-14);
}

TEUCHOS_UNIT_TEST(Svg, LoopsOfOnePathAreHolesOrStonesByWhereTheyLie) {
  const auto drawn = read("<path id=\"a\" d=\"M0 0h9v9h-9zM1 1h3v3h-3zM2 2h1v1h-1zM20 0h1v1z\"/>");
  TEST_EQUALITY(drawn.stones.size(), 3u);  // the square, what lies in its hole, and the triangle
  TEST_EQUALITY(drawn.stones[0].loops.size(), 2u);
  TEST_EQUALITY(drawn.stones[1].name, "a (2)");
  TEST_EQUALITY(drawn.stones[1].loops.size(), 1u);
}

TEUCHOS_UNIT_TEST(Svg, WhatIsWrongIsToldByLineAndId) {
  const auto error = [](const std::string& inside) { return input_error([&] { read(inside); }); };
  const auto open = error("<path id=\"k\" d=\"M0 0h9v9\"/>");
  TEST_ASSERT(has(open, "ine 3: the path \"k\" is not closed: its ends at (0, 0) and (9, 9) are 12.7279 apart"));
  TEST_ASSERT(has(error("<path d=\"h9v9z\"/>"), "without id does not begin with M"));
  TEST_ASSERT(has(error("<path d=\"M0 0 k9z\"/>"), "has the letter \"k\""));
  TEST_ASSERT(has(error("<path d=\"M0 0L1,x\"/>"), "has \"x\" where a number is wanted"));
  TEST_ASSERT(has(error("<line x1=\"0\"/>"), "no closed outline"));
  TEST_ASSERT(has(error("<rect width=\"1\" height=\"10%\"/>"), "height = \"10%\""));
  TEST_ASSERT(has(error("<g transform=\"turn(3)\"><rect/></g>"), "the transform \"turn\""));
  TEST_ASSERT(has(error("<rect"), "is no XML") || has(error("<rect"), "Is no XML"));
  TEST_ASSERT(has(input_error([] { read_svg_stones("a.svg", "<html/>"); }), "root element \"html\""));
}

}  // namespace
