// Files of COMPAS: every shape that could be a stone is one where its element lies, or is refused by its path.
#include <Teuchos_UnitTestHarness.hpp>

#include "stones/repair.hpp"
#include "stones/stone_files.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

const std::string mesh_data = R"({"vertex": {"0": {}, "7": {"x": 1.0}, "12": {"y": 1.0}, "3": {"z": 1.0}},
  "face": {"0": [0, 12, 7], "1": [0, 7, 3], "2": [7, 12, 3], "5": [0, 3, 12]}})";

std::string mesh() { return R"({"dtype": "compas.datastructures/Mesh", "data": )" + mesh_data + "}"; }

TEUCHOS_UNIT_TEST(Compas, ANumberThatNoComputerHoldsIsRefused) {
  TEST_ASSERT(holds(input_error([&] { read_compas("m.json", "{\"x\": 1e970}"); }), "s no JSON: number overflow"));
}

TEUCHOS_UNIT_TEST(Compas, MeshesOfListsAssembliesAndModelsAreStonesAndThoseOfInterfacesAreNot) {
  TEST_EQUALITY(read_compas("m.json", mesh())[0].name, "m");
  const auto list = read_compas("m.json", "[" + mesh() + ", [" + mesh() + "]]");
  TEST_EQUALITY(list.size(), 2u);
  TEST_EQUALITY(list[0].faces.size(), 4u);
  TEST_ASSERT(list[0].points[1] == (Vector<3>{1, 0, 0}));
  TEST_FLOATING_EQUALITY(volume(list[0]), 1.0 / 6, 1e-15);

  const auto assembly =
      read_compas("a.json", R"({"dtype": "compas_assembly.datastructures/Assembly", "data": {"graph": {"data": {
    "node": {"10": {"block": )" +
                                mesh() + R"(, "is_support": true}, "9": {"block": )" + mesh() + R"(}},
    "edge": {"9": {"10": {"interfaces": [)" +
                                mesh() + "]}}}}}}}");
  TEST_EQUALITY(assembly.size(), 2u);
  TEST_EQUALITY(assembly[0].name, "10");
  TEST_ASSERT(assembly[0].support && !assembly[1].support);

  const std::string move = R"({"dtype": "compas.geometry/Transformation", "data": {"matrix":
    [[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}})";
  const auto model = read_compas(
      "b.json", R"({"dtype": "compas_dem.models/BlockModel", "data": {"elements": {
    "71c1eba0-3b01-4daa-a066-5b5c4074b946": {"data": {"transformation": )" +
                    move + R"(, "geometry": )" + mesh() +
                    R"(, "is_support": true}}}, "graph": {"edge": {"0": {"1": {"contacts": [)" + mesh() + "]}}}}}}");
  TEST_EQUALITY(model.size(), 1u);
  TEST_EQUALITY(model[0].name, "0");
  TEST_ASSERT(model[0].support);
  TEST_ASSERT(model[0].points[1] == (Vector<3>{5, 1, 0}));
}

/// Two tetrahedra on either side of one face, and a face that is of neither.
std::string network(const std::string& cells) {
  return R"({"dtype": "compas.datastructures/CellNetwork", "data": {"vertex": {"0": {}, "7": {"x": 1.0},
    "12": {"y": 1.0}, "3": {"z": 1.0}, "4": {"z": -2.0}, "9": {"x": 5.0}},
    "face": {"0": [0, 12, 7], "1": [0, 7, 3], "2": [7, 12, 3],
    "5": [0, 3, 12], "6": [0, 7, 4], "8": [7, 12, 4], "10": [0, 4, 12], "11": [0, 7, 9]}, "edge": {}, "cell": )" +
         cells + "}}";
}

TEUCHOS_UNIT_TEST(Compas, CellsOfANetworkAreStonesThatShareFaces) {
  const auto mended = closed(read_compas("n.json", network(R"({"0": [0, 1, 2, 5], "3": ["0", 6, 8, 10]})")), 0);
  TEST_EQUALITY(mended.stones.size(), 2u);
  TEST_EQUALITY(mended.stones[0].name, "cell 0");
  TEST_EQUALITY(mended.stones[1].name, "cell 3");
  TEST_EQUALITY(mended.stones[1].points.size(), 4u);
  TEST_FLOATING_EQUALITY(volume(mended.stones[0]), 1.0 / 6, 1e-15);
  TEST_FLOATING_EQUALITY(volume(mended.stones[1]), 1.0 / 3, 1e-15);
  const auto error = [](const std::string& cells) {
    return input_error([&] { read_compas("n.json", network(cells)); });
  };
  TEST_ASSERT(holds(error("{}"), "is a CellNetwork without cells"));
  TEST_ASSERT(holds(error(R"({"0": [0, 1, 2, 99]})"), "cell 0 names the face \"99\", which is not there"));
}

TEUCHOS_UNIT_TEST(Compas, WhatIsWrongIsToldByPath) {
  TEST_ASSERT(holds(input_error([] { read_compas("a.json", "{\"data\": [1, "); }), "s no JSON"));
  TEST_ASSERT(holds(input_error([] { read_compas("a.json", "{\"data\": 3}"); }), "olds no mesh"));
  TEST_ASSERT(
      holds(input_error([] { read_compas("a.json", R"({"node": {"4": {"vertex": {"0": {"x": "1"}}, "face": {}}}})"); }),
            "node > 4 > vertex > 0 a number"));
  TEST_ASSERT(holds(input_error([] { read_compas("a.json", R"({"vertex": {"0": {}}, "face": {"2": [0, 0, 8]}})"); }),
                    "face 2 names the vertex \"8\""));
  TEST_ASSERT(
      holds(input_error([] { read_compas("a.json", std::string(3000, '[') + std::string(3000, ']')); }), "nested"));
}

std::string named(const std::string& name) {
  return R"({"dtype": "compas.datastructures/Mesh", "data": )" + mesh_data + R"(, "name": ")" + name + "\"}";
}

std::string typed(const std::string& type, const std::string& data) {
  return R"({"dtype": ")" + type + R"(", "data": )" + data + "}";
}

/// By rows of numbers: a turn about z by a right angle, then a move.
std::string turned_and_moved(int x, int y, int z) {
  return typed("compas.geometry/Transformation", "{\"matrix\": [[0, -1, 0, " + std::to_string(x) + "], [1, 0, 0, " +
                                                     std::to_string(y) + "], [0, 0, 1, " + std::to_string(z) +
                                                     "], [0, 0, 0, 1]]}");
}

const std::string box_data =
    R"({"xsize": 1, "ysize": 2, "zsize": 4, "frame": {"point": [0, 0, 2], "xaxis": [0, 2, 0], "yaxis": [-1, 1, 0]}})";

TEUCHOS_UNIT_TEST(Compas, BoxesAndPolyhedraAreStones) {
  const auto stones = read_compas("s.json", "[" + typed("compas.geometry/Box", box_data) + ", " +
                                                typed("compas.geometry/Polyhedron",
                                                      R"({"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                              "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]})") +
                                                "]");
  TEST_EQUALITY(stones.size(), 2u);
  TEST_FLOATING_EQUALITY(volume(stones[0]), 8.0, 1e-15);  // faces look outward
  TEST_FLOATING_EQUALITY(volume(stones[1]), 1.0 / 6, 1e-15);
  // x of the box is y of the world, and y of the box, made square to it, is -x of the world.
  Vector<3> low = stones[0].points[0], high = low;
  for (const auto& x : stones[0].points)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
  for (int i = 0; i < 3; ++i) {
    TEST_FLOATING_EQUALITY(low[i] + 10, (Vector<3>{-1, -0.5, 0})[i] + 10, 1e-14);
    TEST_FLOATING_EQUALITY(high[i] + 10, (Vector<3>{1, 0.5, 4})[i] + 10, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(Compas, ShapesThatAreNotReadAreRefusedByPathInListsAndElements) {
  const std::string sphere = typed("compas.geometry/Sphere", R"({"radius": 1})");
  const std::string brep = typed("compas_occ.brep/OCCBrep", R"({"vertices": [], "edges": [], "faces": []})");
  const auto error = [](const std::string& text) { return input_error([&] { read_compas("a.json", text); }); };
  const std::string list = error("[" + mesh() + ", " + sphere + "]");
  TEST_ASSERT(holds(list, "t 1 is a shape of type compas.geometry/Sphere") && holds(list, "to_mesh"));
  TEST_ASSERT(
      holds(error("{\"a\": " + mesh() + ", \"b\": " + brep + "}"), "t b is a shape of type compas_occ.brep/OCCBrep"));
  const auto model = [&](const std::string& type, const std::string& data) {
    return error(R"({"data": {"elements": {"e1": {"data": {"features": [], "geometry": )" + mesh() + R"(}}, "e2": )" +
                 typed(type, data) + R"(}, "tree": {}}})");
  };
  TEST_ASSERT(holds(model("compas_dem.elements/Block", "{\"features\": [], \"geometry\": " + brep + "}"),
                    "data > elements > e2 > data > geometry is a shape of type compas_occ.brep/OCCBrep"));
  TEST_ASSERT(holds(model("compas_model.elements/BeamElement", R"({"features": [], "length": 3})"),
                    "data > elements > e2 is a shape of type compas_model.elements/BeamElement"));
  TEST_EQUALITY(model("compas_model.elements/Group", R"({"features": [], "name": "left"})"), "");
  TEST_ASSERT(holds(error(R"([{"vertex": {"0": {}}, "face": {}}])"), "t 0 is a mesh without faces"));
  // Points, frames and lines are no stones, and stand in many lists.
  TEST_EQUALITY(error("[" + mesh() + ", " + typed("compas.geometry/Point", "[0, 0, 1]") + "]"), "");
}

TEUCHOS_UNIT_TEST(Compas, TransformationsOfModelParentsAndElementAreMultiplied) {
  const std::string text = R"({"data": {"transformation": )" + turned_and_moved(100, 0, 0) + R"(, "elements": {
      "outer": {"data": {"transformation": )" +
                           turned_and_moved(0, 10, 0) + R"(, "features": []}},
      "inner": {"data": {"transformation": )" +
                           turned_and_moved(0, 0, 1) + R"(, "features": []}},
      "stone": {"data": {"transformation": )" +
                           turned_and_moved(2, 0, 0) + R"(, "geometry": )" + mesh() + R"(}}},
    "tree": {"root": {"name": "root", "children": [{"element": "outer", "children": [
      {"element": "inner", "children": [{"element": "stone"}]}]}]}}}})";
  const auto stones = read_compas("m.json", text);
  TEST_EQUALITY(stones.size(), 1u);
  // (1, 0, 0) -> (2, 1, 0) by its own -> (-1, 2, 1) by inner -> (-2, 9, 1) by outer -> (91, -2, 1) by the model.
  TEST_ASSERT(stones[0].points[1] == (Vector<3>{91, -2, 1}));
}

TEUCHOS_UNIT_TEST(Compas, ElementsOfOlderModelsLieByFrameAndTransformation) {
  const std::string frame =
      typed("compas.geometry/Frame", R"({"point": [5, 0, 0], "xaxis": [0, 1, 0], "yaxis": [-1, 0, 0]})");
  const auto shape = [&](const std::string& members) {
    const auto stones =
        read_compas("m.json", R"({"data": {"elements": [{"guid": "g", "data": {"features": [], )" + members +
                                  R"(, "name": "keystone", "shape": )" + mesh() + R"(}}], "tree": {}}})");
    TEST_EQUALITY(stones.size(), 1u);
    TEST_EQUALITY(stones[0].name, "keystone");
    return stones[0].points[1];
  };
  TEST_ASSERT(shape("\"frame\": null, \"transformation\": " + turned_and_moved(2, 0, 0)) == (Vector<3>{2, 1, 0}));
  TEST_ASSERT(shape("\"frame\": " + frame) == (Vector<3>{5, 1, 0}));
  // By its transformation first: (2, 1, 0), which the frame turns to (-1, 2, 0).
  TEST_ASSERT(shape("\"frame\": " + frame + ", \"transformation\": " + turned_and_moved(2, 0, 0)) ==
              (Vector<3>{4, 2, 0}));
}

TEUCHOS_UNIT_TEST(Compas, KeysOfAPlainDictionaryAreNamesWhateverTheyAre) {
  const auto stones = read_compas("d.json", R"({"base": )" + mesh() + R"(, "features": )" + mesh() +
                                                R"(, "contacts": [)" + mesh() + R"(], "shape": )" + mesh() + "}");
  TEST_EQUALITY(stones.size(), 4u);
  TEST_EQUALITY(stones[1].name, "features");
  TEST_EQUALITY(stones[3].name, "shape");
}

TEUCHOS_UNIT_TEST(Compas, NamesOfMeshesInAListAreThoseOfStonesWhereTheyDiffer) {
  const auto stones =
      read_compas("l.json", "[" + named("base") + "," + named("Mesh") + "," + mesh() + "," + named("Mesh") + "]");
  TEST_EQUALITY(stones[0].name, "base");
  TEST_EQUALITY(stones[1].name, "1");
  TEST_EQUALITY(stones[2].name, "2");
  TEST_EQUALITY(stones[3].name, "3");
  TEST_EQUALITY(read_compas("d.json", "{\"west\": " + named("base") + "}")[0].name, "west");
}

TEUCHOS_UNIT_TEST(Compas, CoordinatesThatAreNotWrittenAreTheDefault) {
  const auto stones = read_compas("d.json", R"({"default_vertex_attributes": {"x": 0.0, "z": 3.0},
    "vertex": {"0": {}, "1": {"x": 1.0}, "2": {"y": 1.0, "z": 0.0}}, "face": {"0": [0, 1, 2]}})");
  TEST_ASSERT(stones[0].points[0] == (Vector<3>{0, 0, 3}));
  TEST_ASSERT(stones[0].points[2] == (Vector<3>{0, 1, 0}));
}

}  // namespace
