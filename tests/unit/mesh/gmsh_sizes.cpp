// Units of a file, and the size of cells where a file has no number for it.
#include <algorithm>
#include <cmath>

#include "mesh/divisions.hpp"
#include "unit/mesh/gmsh_files.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

double longest_edge(const BlockSource<2>& source) {
  double longest = 0;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    for (const Cell& cell : block.cells)
      for (int k = 0; k < cell.count; ++k)
        longest =
            std::max(longest, norm(block.position[cell.node[(k + 1) % cell.count]] - block.position[cell.node[k]]));
  }
  return longest;
}

Vector<2> far_corner(const BlockSource<2>& source) {
  Vector<2> corner{-INFINITY, -INFINITY};
  for (BlockId b = 0; b < source.block_count(); ++b)
    for (const auto& x : source.block(b).position)
      for (int c = 0; c < 2; ++c) corner[c] = std::max(corner[c], x[c]);
  return corner;
}

// A plate of 1 by 1 whose points ask for cells of 1.
const std::string plate = square + "Plane Surface(1) = {1}; Physical Curve(\"base\") = {1};\n";
// Two plates of 1 by 0.5 upon each other, 4 cells along and 2 up.
const std::string divided = R"(
Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {1,0.5,0}; Point(4) = {0,0.5,0};
Point(5) = {1,1,0}; Point(6) = {0,1,0};
Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1}; Line(5) = {3,5}; Line(6) = {5,6}; Line(7) = {6,4};
Transfinite Curve{1,3,6} = 5; Transfinite Curve{2,4,5,7} = 3;
Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1}; Curve Loop(2) = {-3,5,6,7}; Plane Surface(2) = {2};
Transfinite Surface{1,2};
)";

TEUCHOS_UNIT_TEST(Units, LengthsOfTheFileBecomeMetres) {
  for (const auto& [unit, metres] : {std::pair{1e-3, 1e-3}, {1e-2, 1e-2}, {0.3048, 0.3048}, {1.0, 1.0}}) {
    GmshParameters p = written("unit.geo", plate);
    p.unit = unit;
    const auto source = read(p);
    check_source(*source, out, success);
    TEST_FLOATING_EQUALITY(far_corner(*source)[0], metres, 1e-15);
    TEST_FLOATING_EQUALITY(far_corner(*source)[1], metres, 1e-15);
  }
}

TEUCHOS_UNIT_TEST(Units, TheElementSizeStaysInMetres) {
  // two_stones.geo has the number element_size; 2 m x 1 m, or feet.
  GmshParameters p = geo("two_stones.geo");
  p.unit = 0.3048;
  p.element_size = 0.3048 / 8;
  const auto in_feet = read(p);
  TEST_EQUALITY(graph_of(*in_feet).shared_vertices[0], 9);  // eight cells along a joint of a foot
  p.unit = 1;
  p.element_size = 1.0 / 8;
  TEST_EQUALITY(in_feet->node_count(0), read(p)->node_count(0));
  p = written("plate_in_mm.geo", plate);
  p.unit = 1e-3;
  p.element_size = 2.5e-4;
  TEST_EQUALITY(facet_midpoints(*read(p), "base").size(), 4u);
}

TEUCHOS_UNIT_TEST(ElementSize, ReachesAFileThatHasNoNumberForIt) {
  GmshParameters p = written("plain_plate.geo", plate);
  for (const double size : {0.25, 0.125, 0.0625}) {
    p.element_size = size;
    const auto source = read(p);
    check_source(*source, out, success);
    TEST_EQUALITY(facet_midpoints(*source, "base").size(), std::size_t(std::lround(1 / size)));
    TEST_COMPARE(longest_edge(*source), <, 1.6 * size);  // triangles of a free mesh are nearly equilateral
  }
}

TEUCHOS_UNIT_TEST(ElementSize, OverridesPointsFieldsAndOptionsOfTheFile) {
  GmshParameters p = written("fine.geo",
                             "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 1, 1};\n"
                             "Field[1] = MathEval; Field[1].F = \"0.05\"; Background Field = 1;\n"
                             "Mesh.MeshSizeFactor = 0.5; Mesh.MeshSizeMax = 0.1;\n"
                             "Physical Curve(\"base\") = {1};\n");
  p.element_size = 0.5;
  TEST_EQUALITY(facet_midpoints(*read(p), "base").size(), 2u);
}

TEUCHOS_UNIT_TEST(ElementSize, RefinesAndCoarsensDivisionsOfTheFile) {
  GmshParameters p = written("divided.geo", divided);
  TEST_EQUALITY(read(p)->node_count(0), 5 * 3);
  const auto nodes = [&](double size) {
    p.element_size = size;
    const auto source = read(p);
    check_source(*source, out, success);
    TEST_EQUALITY(source->node_count(0), source->node_count(1));
    return source->node_count(0);
  };
  TEST_EQUALITY(nodes(0.25), 5 * 3);
  TEST_EQUALITY(nodes(0.125), 9 * 5);
  TEST_EQUALITY(nodes(0.1), 11 * 6);  // cells of 0.1 m: five times the least division of 2 x 1
  TEST_EQUALITY(nodes(0.5), 3 * 2);
  p.element_size = 1;
  TEST_ASSERT(holds(refusal(p), "gmsh > element size = 1 m\n  cannot be had"));
  TEST_ASSERT(holds(refusal(p), "Give at most 0.75"));
}

TEUCHOS_UNIT_TEST(ElementSize, KeepsTheGradingOfTheFile) {
  GmshParameters p = written("graded.geo", square +
                                               "Transfinite Curve{1, -3} = 4 Using Progression 2;\n"
                                               "Transfinite Curve{2, 4} = 2; Plane Surface(1) = {1};\n"
                                               "Transfinite Surface{1}; Physical Curve(\"base\") = {1};\n");
  p.element_size = 0.5;  // its cells are 1/7, 2/7 and 4/7 long, and 1
  const auto x = facet_midpoints(*read(p), "base");
  TEST_EQUALITY(x.size(), 6u);
  double first = INFINITY, last = 0;
  for (const auto& middle : x) first = std::min(first, middle[0]), last = std::max(last, middle[0]);
  // Six cells whose lengths grow by the root of two: 1 : 5.7 from first to last.
  const double r = std::sqrt(2.0), shortest = (r - 1) / (std::pow(r, 6) - 1);
  TEST_FLOATING_EQUALITY(first, shortest / 2, 1e-6);
  TEST_FLOATING_EQUALITY(1 - last, shortest * std::pow(r, 5) / 2, 1e-6);
}

TEUCHOS_UNIT_TEST(ElementSize, NumbersOfIncludedFilesAreFound) {
  const std::string measures = written("measures.geo", "DefineConstant[ element_size = 1 ];\n").file;
  GmshParameters p = written("including.geo", "Include \"" + measures + "\";\n" + square +
                                                  "Characteristic Length{1, 2, 3, 4} = element_size;\n"
                                                  "Plane Surface(1) = {1}; Physical Curve(\"base\") = {1};\n");
  p.element_size = 0.2;
  TEST_EQUALITY(facet_midpoints(*read(p, Trust::yes), "base").size(), 5u);
  const std::string corners = written("corners.geo", square).file;
  p = written("including_points.geo", "Include \"" + corners +
                                          "\";\nPlane Surface(1) = {1};\nPhysical Curve(\"base\") "
                                          "= {1};\n");
  p.element_size = 0.25;
  TEST_EQUALITY(facet_midpoints(*read(p, Trust::yes), "base").size(), 4u);  // no number anywhere: gmsh's own size
}

TEUCHOS_UNIT_TEST(Divisions, AreOneMultipleForAllCurves) {
  const auto curve = [](int tag, int cells, double length) {
    return DividedCurve{tag, std::vector<double>(cells, length / cells)};
  };
  const auto finer = divisions_for({curve(1, 6, 3.0), curve(2, 4, 1.0), curve(3, 2, 2.0)}, 0.4, "x.geo");
  // The divisor is 2; the longest cell is 1 m of two: 2 m at the coarsest, so five times 3, 2 and 1.
  TEST_EQUALITY(finer.size(), 3u);
  TEST_EQUALITY(finer[0].cells, 15);
  TEST_EQUALITY(finer[1].cells, 10);
  TEST_EQUALITY(finer[2].cells, 5);
  TEST_ASSERT(divisions_for({curve(1, 6, 3.0), curve(3, 2, 2.0)}, 1.0, "x.geo").empty());
  TEST_ASSERT(divisions_for({}, 1.0, "x.geo").empty());
  // A single cell cannot be coarser, and is not refused for it.
  TEST_ASSERT(divisions_for({curve(1, 1, 0.1)}, 5.0, "x.geo").empty());
  const DividedCurve bump{7, {0.1, 0.3, 0.3, 0.1}};
  TEST_ASSERT(holds(input_error([&] { divisions_for({bump}, 0.1, "x.geo"); }), "curve 7 into cells that grow neither"));
}

}  // namespace
