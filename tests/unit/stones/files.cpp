// Files of stones hold what they say, and what is wrong in them is told by line, byte or path.
#include <Teuchos_UnitTestHarness.hpp>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "stones/gmsh_volumes.hpp"
#include "stones/stone_files.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

template <class T>
std::string bytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <class T>
std::string swapped(T value) {
  const std::string b = bytes(value);
  return {b.rbegin(), b.rend()};
}

std::vector<StoneSurface> stl(const std::string& file, const std::string& contents) {
  Warnings untold;
  return read_stl(file, contents, untold);
}

const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEUCHOS_UNIT_TEST(Obj, ObjectsAndGroupsAreStonesWithThePointsTheyUse) {
  const auto stones = read_obj("two.obj", tetrahedron_obj +
                                              "# a comment\r\no west stone\nf 1 3 2\nf 1/1 2/2/5 4//1\r\nv 9 9 9\n"
                                              "o east\ng heart\nf -1 -5 -4 -3\no west stone\nf 1 4 3\n");
  TEST_EQUALITY(stones.size(), 2u);
  TEST_EQUALITY(stones[0].name, "west stone");
  TEST_EQUALITY(stones[0].origin, "two.obj, line 7");
  TEST_EQUALITY(stones[0].points.size(), 4u);
  TEST_EQUALITY(stones[0].faces.size(), 3u);  // the name comes again and goes on with the same stone
  TEST_EQUALITY(stones[1].name, "east");
  TEST_ASSERT(stones[1].points[0] == (Vector<3>{9, 9, 9}));
  TEST_ASSERT(stones[1].points[1] == (Vector<3>{0, 0, 0}));
}

std::string with_ends(std::string text, const std::string& end) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) text.replace(at, 1, end);
  return text;
}

// Lines end in "\n", "\r\n" or "\r", and are counted alike.
TEUCHOS_UNIT_TEST(StoneFiles, AreReadWithAnyEndsOfLines) {
  const std::string obj = tetrahedron_obj + "\no a # first\nf 1 3 2\nf 1 2 \\\n4\nf 2 3 4\nf 3 1 4\n";
  const std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  // The first byte of the data is that of "\n", which is no end of a line there.
  const std::string data = "\n" + std::string(71, '\0') + "\3" + bytes(0) + bytes(1) + bytes(2);
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto stones = read_obj("a.obj", with_ends(obj, end));
    TEST_EQUALITY(stones.size(), 1u);
    TEST_EQUALITY(stones[0].origin, "a.obj, line 7");
    TEST_EQUALITY(stones[0].faces.size(), 4u);
    TEST_FLOATING_EQUALITY(volume(stones[0]), 1.0 / 6, 1e-15);
    TEST_ASSERT(
        holds(input_error([&] { read_obj("a.obj", with_ends(obj + "f 1 2 9\n", end)); }), "Line 12 names the point"));
    TEST_EQUALITY(stl("a.stl", with_ends("solid a\n" + facet + "endsolid\n", end))[0].points.size(), 3u);
    const auto surface = read_ply("a.ply", with_ends(ply, end) + data);
    TEST_EQUALITY(surface[0].points.size(), 3u);
    TEST_COMPARE(surface[0].points[0][0], >, 0);
  }
}

TEUCHOS_UNIT_TEST(Stl, WordsMayBeInCapitals) {
  std::string capitals;
  for (const char c : facet) capitals += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const auto stones = stl("a.stl", "SOLID West\n" + capitals + "ENDSOLID West\n");
  TEST_EQUALITY(stones.size(), 1u);
  TEST_EQUALITY(stones[0].name, "West");
  TEST_EQUALITY(stones[0].faces.size(), 1u);
}

TEUCHOS_UNIT_TEST(Obj, WhatIsWrongIsToldByLine) {
  const auto error = [](const std::string& lines) {
    return input_error([&] { read_obj("a.obj", tetrahedron_obj + lines); });
  };
  TEST_ASSERT(holds(error("f 1 2 5\n"), "Line 5 names the point \"5\", of 4"));
  TEST_ASSERT(holds(error("f 1 2\n"), "Line 5 has a face of 2 points"));
  TEST_ASSERT(holds(error("\nv 1 nan 2\n"), "Line 6 has \"nan\" where a number is wanted"));
  TEST_ASSERT(holds(error("v 1 2\n"), "Line 5 ends after 3 words"));
  TEST_ASSERT(holds(error(""), "has no faces") || holds(error(""), "Has no faces"));
  TEST_ASSERT(holds(error("f 1 2 5\n"), "mesh > stones > file = a.obj"));
}

TEUCHOS_UNIT_TEST(Obj, LinesGoOnBehindABackslashAndEndAtAComment) {
  const auto stones = read_obj("a.obj", "# C:\\stones\\\n" + tetrahedron_obj +
                                            "o Block #1 # the first\nf 1 3 \\\r\n 2 # bottom\nf 1 2 4# side\n"
                                            "o Block #2\nf 1 \\\n\\\n4 3\n");
  TEST_EQUALITY(stones.size(), 2u);
  TEST_EQUALITY(stones[0].name, "Block #1");
  TEST_ASSERT(stones[0].faces == (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));
  TEST_EQUALITY(stones[1].name, "Block #2");
  TEST_EQUALITY(stones[1].faces.size(), 1u);
  TEST_ASSERT(holds(input_error([&] { read_obj("a.obj", tetrahedron_obj + "f 1 \\\n2 \\\n9\nf 1 2 3\n"); }),
                    "Line 5 names the point \"9\""));
}

TEUCHOS_UNIT_TEST(Text, TheMarkOfUtf8IsSkippedAndUtf16IsRefusedBySayingSo) {
  const std::string mark = "\xef\xbb\xbf";
  TEST_EQUALITY(read_obj("a.obj", mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")[0].points.size(), 3u);
  TEST_EQUALITY(stl("a.stl", mark + "solid one\n" + facet)[0].name, "one");
  TEST_EQUALITY(read_compas("a.json", mark + R"({"vertex": {"0": {}}, "face": {"0": [0, 0, 0]}})").size(), 1u);
  TEST_EQUALITY(read_ply("a.ply", mark + "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                         "property float y\nproperty float z\nelement face 1\n"
                                         "property list uchar int vertex_index\nend_header\n0 0 0\n3 0 0 0\n")[0]
                    .faces.size(),
                1u);
  const auto wide = [](const std::string& text, bool low_first) {
    std::string pairs;
    for (const char c : text) pairs += low_first ? std::string{c, '\0'} : std::string{'\0', c};
    return pairs;
  };
  for (const auto& text : {"\xff\xfe" + wide("o A", true), "\xfe\xff" + wide("o A", false), wide("o A", true)})
    TEST_ASSERT(holds(input_error([&] { read_obj("a.obj", text); }), "is text in UTF-16") ||
                holds(input_error([&] { read_obj("a.obj", text); }), "Is text in UTF-16"));
  TEST_ASSERT(holds(input_error([&] { read_compas("a.json", "\xff\xfe" + wide("[]", true)); }), "UTF-16"));
  TEST_ASSERT(holds(input_error([&] { stl("a.stl", "\xff\xfe" + wide("solid x\n" + facet, true)); }), "UTF-16"));
}

TEUCHOS_UNIT_TEST(Text, MessagesHoldNoControlCharacters) {
  const std::string noise{'b', '\0', '\x1b', 'x', '\x07', ' ', 'z'};
  TEST_ASSERT(holds(input_error([&] { stl("a.stl", noise); }), "ine 1 is \"bx\", not solid"));
}

TEUCHOS_UNIT_TEST(Stl, BytesBehindTheLastTriangleAreToldAndAWholeTriangleMoreIsRefused) {
  std::string binary = std::string(80, ' ') + bytes<std::uint32_t>(2);
  for (int k = 0; k < 24; ++k) binary += bytes(static_cast<float>(k % 12));
  binary.insert(84 + 48, 2, '\0');
  binary += std::string(2 + 4, '\0');
  Warnings warnings;
  TEST_EQUALITY(read_stl("a.stl", binary, warnings)[0].faces.size(), 2u);
  TEST_EQUALITY(warnings.size(), 1u);
  TEST_ASSERT(holds(warnings[0].text, "4 bytes more than its 2 triangles take"));
  TEST_ASSERT(holds(input_error([&] { stl("a.stl", binary + std::string(46, '\0')); }),
                    "50 bytes more than its triangles take"));
}

TEUCHOS_UNIT_TEST(Ply, OnlyTheListOfVerticesIsCornersAndOthersHaveAnyLength) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
      "1\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\nproperty list uchar int tags\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  TEST_ASSERT(read_ply("s.ply", header + "0 3 2 1 0 1 7\n")[0].faces == (std::vector<std::vector<int>>{{2, 1, 0}}));
  TEST_ASSERT(holds(input_error([&] { read_ply("s.ply", header + "2 0.5 0.5 2 0 1 0\n"); }),
                    "ace 0 has 2 members of its list \"vertex_indices\""));
}

TEUCHOS_UNIT_TEST(Stl, SolidsOfTextAreStonesAndABinaryFileIsOne) {
  const auto text = stl("a.stl", "solid one\n" + facet + facet + "endsolid\nsolid two\n" + facet + "endsolid two\n");
  TEST_EQUALITY(text.size(), 2u);
  TEST_EQUALITY(text[0].faces.size(), 2u);
  TEST_EQUALITY(text[1].name, "two");

  std::string binary = "solid misleading" + std::string(64, ' ') + bytes<std::uint32_t>(1);
  for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 0.f, 3.f, 0.f}) binary += bytes(x);
  binary += std::string(2, '\0');
  const auto stones = stl("folder/stone 3.stl", binary);
  TEST_EQUALITY(stones[0].name, "stone 3");
  TEST_ASSERT(stones[0].points[2] == (Vector<3>{0, 3, 0}));
  TEST_ASSERT(
      holds(input_error([&] { stl("a.stl", binary.substr(0, 100)); }), "1 triangle, in all 134 bytes, and has 100"));
  TEST_ASSERT(holds(input_error([&] { stl("a.stl", "solid x\nvertex 0 0 0\nendfacet\n"); }), "facet of 1 corner"));
}

TEUCHOS_UNIT_TEST(Ply, TextAndBytesOfEitherOrderHoldTheSameStone) {
  const auto header = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\nproperty double y\n"
           "property float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  };
  std::string little, big;
  for (int k = 0; k < 3; ++k) {
    const auto x = static_cast<float>(k), z = static_cast<float>(k == 2);
    const double y = 0.1 * k;
    little += bytes(x) + bytes(y) + bytes(z) + "r";
    big += swapped(x) + swapped(y) + swapped(z) + "r";
  }
  little += '\3', big += '\3';
  for (const std::int32_t k : {0, 1, 2}) little += bytes(k), big += swapped(k);
  const std::string text = "0 0 0 7\n1 0.1 0 7\n2 0.2 1 7\n3 0 1 2\n";
  for (const auto& [format, body] : {std::pair<std::string, std::string>{"ascii", text},
                                     {"binary_little_endian", little},
                                     {"binary_big_endian", big}}) {
    const auto stones = read_ply("s.ply", header(format) + body);
    TEST_ASSERT(stones[0].faces == (std::vector<std::vector<int>>{{0, 1, 2}}));
    TEST_ASSERT(stones[0].points[2] == (Vector<3>{2, 0.2, 1}));
  }
  TEST_ASSERT(holds(input_error([&] { read_ply("s.ply", header("binary_little_endian") + little.substr(0, 40)); }),
                    "nds at byte"));
  TEST_ASSERT(holds(input_error([&] { read_ply("s.ply", header("ascii") + "0 0 0 7\n1 0 0 7\n0 1 0 7\n3 0 1 3\n"); }),
                    "ace 0 names the point 3, of 3"));
  TEST_ASSERT(holds(input_error([&] { read_ply("s.ply", header("zip") + little); }), "format \"zip\""));
}

TEUCHOS_UNIT_TEST(StoneFiles, AFolderIsReadByNamesInTheUnitOfItsFiles) {
  const std::string folder = "stones of a folder";
  std::filesystem::create_directory(folder);
  for (const std::string name : {"s10", "s9"})
    std::ofstream(folder + "/" + name + ".OBJ") << tetrahedron_obj << "f 1 3 2\n";
  std::ofstream(folder + "/loads.json") << "{}";
  const auto stones = read_stones(folder, 1e-3);
  TEST_EQUALITY(stones.size(), 2u);
  TEST_EQUALITY(stones[0].name, "s9");
  TEST_FLOATING_EQUALITY(extent(stones[0].points), std::sqrt(2.0) * 1e-3, 1e-15);
  TEST_ASSERT(holds(input_error([] { read_stones("nowhere.obj", 1); }), "annot be read"));
  std::ofstream("stone.dxf") << "0";
  const std::string unknown = input_error([] { read_stones("stone.dxf", 1); });
  for (const std::string ending : {".obj", ".stl", ".ply", ".json", ".step", ".stp", ".geo", ".msh"})
    TEST_ASSERT(holds(unknown, ending));
  for (const std::string file : {"arch.GEO", "arch.geo", "arch.Msh"}) TEST_ASSERT(is_of_gmsh(file));
}

}  // namespace
