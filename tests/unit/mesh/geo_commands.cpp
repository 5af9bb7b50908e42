// What a drawing must not do, told from what only looks like it.
#include "mesh/geo_commands.hpp"

#include "mesh/cell_count.hpp"
#include "unit/mesh/gmsh_files.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

TEUCHOS_UNIT_TEST(GeoCommands, WhatRunsProgramsOrTouchesFilesIsFoundInItsLine) {
  for (const char* command : {"SystemCall \"rm x\";",
                              "NonBlockingSystemCall \"x\";",
                              "System \"x\";",
                              "OnelabRun(\"x\", \"y\");",
                              "Include \"x.geo\";",
                              "Merge \"x.stl\";",
                              "Save \"x.msh\";",
                              "Print \"x.png\";",
                              "CreateDir \"x\";",
                              "SendToServer View[0] \"x\";",
                              "a() = ShapeFromFile(\"x.brep\");",
                              "a() = ListFromFile(\"x\");",
                              "Plugin(Crack).Run;",
                              "Field[1] = ExternalProcess;",
                              "Field[1].CommandLine = \"x\";",
                              "Field[1].FileName = \"x\";",
                              "Printf(\"a (b)\", 1) > \"x\";",
                              "Error(\"a\") >> \"x\";",
                              "Exit;",
                              "SystemCall\"rm x\";",
                              "If(1) Exit; EndIf"})
    TEST_ASSERT(forbidden_command(std::string("a = 1;\n/* two\nlines */ ") + command).find("line 3 has ") == 0);
}

// gmsh knows no backslash in texts, and comments end and begin where texts do not.
TEUCHOS_UNIT_TEST(GeoCommands, HidesBehindNoCommentAndNoText) {
  for (const char* hidden :
       {"a = \"//\"; Exit;", "a = \"/*\"; Exit; // */", "a = '\"'; Exit; b = '\"';", "a = \"\\\"; Exit; b = \"\\\";",
        "/* // */ Exit;", "// /*\nExit; // */", "/* \" */ Exit; /* \" */", "a = 2;Exit;", "x = 1e5Exit;"})
    TEST_INEQUALITY(forbidden_command(hidden), "");
  TEST_INEQUALITY(forbidden_command(std::string("// \0 Exit;", 10)), "");
  TEST_INEQUALITY(forbidden_command("a = \"" + std::string(1500, 'x') + "\";"), "");
}

TEUCHOS_UNIT_TEST(GeoCommands, CommentsTextsNamesAndOptionsAreNone) {
  for (const char* harmless :
       {"// SystemCall \"x\";", "/* Include \"x\"; */", "a = \"Exit; SystemCall\";", "Printf(\"Merge > 1\");",
        "Exits = 1; Point(Exits) = {0, 0, 0};", "Print.Text = 0;", "Save = 2;", "Mesh.SaveAll = 1;",
        "If(a > 1) Printf(\"x\"); EndIf", "Physical Curve(\"Exit\") = {1};", "a = CurrentFileName;", ""})
    TEST_EQUALITY(forbidden_command(harmless), "");
}

TEUCHOS_UNIT_TEST(GeoCommands, AreRefusedUnlessTheFileIsTrusted) {
  const auto p = written("prints.geo", square + "Plane Surface(1) = {1};\nPrintf(\"a\") > \"/dev/null\";\n");
  const auto said = refusal(p);
  TEST_ASSERT(said.find("line 4 has Printf into a file") != std::string::npos);
  TEST_ASSERT(said.find("--trust") != std::string::npos);
  TEST_EQUALITY(read(p, Trust::yes)->block_count(), 1);
}

TEUCHOS_UNIT_TEST(GeoCommands, AMeshIsNoScript) {
  const auto p = written("script.msh", "Printf(\"a\");\n");
  TEST_ASSERT(refusal(p).find("$MeshFormat") != std::string::npos);
}

/// What is said of a drawing with too many cells.
std::string too_fine(const GmshParameters& p) {
  const auto said = refusal(p);
  return said.find(" cells, and this machine's memory") == std::string::npos ? "not said: " + said : "";
}

// Drawn in millimetres, or with sizes as small: by the scene, by points, by options, by divisions of curves.
TEUCHOS_UNIT_TEST(CellCount, TooManyAreRefusedBeforeTheyAreMade) {
  const std::string plate = square + "Plane Surface(1) = {1};\n";
  auto p = written("plate_of_too_many.geo", plate);
  p.element_size = 1e-6;
  TEST_EQUALITY(too_fine(p), "");
  p.element_size = 0.1;
  p.unit = 1e5;
  TEST_EQUALITY(too_fine(p), "");
  p.unit = 1;
  TEST_EQUALITY(read(p)->block_count(), 1);
  for (const char* fine :
       {"MeshSize{:} = 1e-7;", "Mesh.MeshSizeMax = 1e-6;", "Mesh.MeshSizeFactor = 1e-6;",
        "Field[1] = MathEval; Field[1].F = \"1e-6\"; Background Field = 1;", "Transfinite Curve{:} = 200000;"})
    TEST_EQUALITY(too_fine(written("plate_too_fine.geo", plate + fine + "\n")), "");
  // Divided by the file into few cells, which no size of it changes.
  const auto few = written("plate_divided.geo", plate + "Transfinite Curve{:} = 9; MeshSize{:} = 1e-7;\n");
  TEST_EQUALITY(read(few)->block_count(), 1);
}

TEUCHOS_UNIT_TEST(CellCount, GeneratorsKnowTheirs) {
  MeshParameters p;
  p.type = MeshType::wall;
  p.wall.courses = p.wall.blocks_per_course = 8;
  TEST_EQUALITY(cells_of(p), 8.0 * 8 * 4 * 2);
  refuse_too_many_cells(p);
  p.wall.courses = p.wall.blocks_per_course = 1'000'000;
  TEST_THROW(refuse_too_many_cells(p), InputError);
  p.type = MeshType::arch;
  p.arch.voussoirs = 1'000'000;
  p.arch.cells_along = p.arch.cells_radial = 10'000;
  TEST_THROW(refuse_too_many_cells(p), InputError);
}

TEUCHOS_UNIT_TEST(CellCount, IsThatOfTheMesh) {
  auto p = written("plate_counted.geo", square + "Plane Surface(1) = {1};\n");
  p.element_size = 0.02;
  Drawing drawing;
  drawing.stones.emplace_back();
  drawing.add(-1, {{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}});
  drawing.divide(p.element_size);
  // Triangles of a free mesh have 0.43 of the square of their edges.
  const auto cells = static_cast<double>(read(p)->block(0).cells.size());
  TEST_COMPARE(cells_of(drawing), <, cells);
  TEST_COMPARE(3 * cells_of(drawing), >, cells);
}

TEUCHOS_UNIT_TEST(Scaling, OfWhatGmshSavesIsRefused) {
  const auto p = written("scaled.geo", square + "Plane Surface(1) = {1}; Mesh.ScalingFactor = 0.001;\n");
  const auto said = refusal(p);
  TEST_ASSERT(said.find("Mesh.ScalingFactor = 0.001") != std::string::npos);
  TEST_ASSERT(said.find("unit") != std::string::npos);
}

TEUCHOS_UNIT_TEST(FarFromTheOrigin, IsSaidOfWhatIsFar) {
  const auto words = [](double x) {
    Drawing drawing;
    drawing.stones.emplace_back();
    drawing.add(1, {{x, 0}, {x + 1, 1}});
    return far_from_origin(drawing);
  };
  TEST_EQUALITY(words(0), "");
  TEST_EQUALITY(words(1000), "");
  TEST_ASSERT(words(1e6).find("origin") != std::string::npos);
}

}  // namespace
