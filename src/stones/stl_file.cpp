// STL: triangles, each with corners of its own; equal corners become one point when the surface is repaired.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

constexpr std::size_t header = 84, bytes_of_triangle = 50;

void add_triangle(StoneSurface& stone, const std::array<Vector<3>, 3>& corners) {
  const int first = static_cast<int>(stone.points.size());
  stone.points.insert(stone.points.end(), corners.begin(), corners.end());
  stone.faces.push_back({first, first + 1, first + 2});
}

/// By its size, which the number of triangles gives: headers of binary files may begin with the word of those of text.
bool is_binary(const std::string& file, const std::string& contents) {
  if (contents.size() < header) return false;
  const std::size_t triangles = StoneBytes(file, contents, header - 4, false).plain<std::uint32_t>();
  if (contents.size() == header + bytes_of_triangle * triangles) return true;
  if (contents.find('\0') != std::string::npos)  // no text
    refuse_stones(file,
                  "tells of " + counted(triangles, "triangle") + ", in all " +
                      counted(header + bytes_of_triangle * triangles, "byte") + ", and has " +
                      std::to_string(contents.size()),
                  "It was cut when it was copied, or is damaged: export it anew");
  return false;
}

std::vector<StoneSurface> read_binary(const std::string& file, const std::string& contents) {
  StoneSurface stone;
  stone.name = stem(file);
  stone.origin = std::filesystem::path(file).filename().string();
  StoneBytes bytes(file, contents, header, false);
  while (bytes.left() > 0) {
    bytes.skip(12);  // the normal
    std::array<Vector<3>, 3> corners;
    for (auto& corner : corners)
      for (double& x : corner) {
        x = static_cast<double>(bytes.plain<float>());
        if (!std::isfinite(x))
          refuse_stones(file, "triangle " + std::to_string(stone.faces.size() + 1) + " has a corner that is no number",
                        "The file is damaged: export it anew");
      }
    bytes.skip(2);
    add_triangle(stone, corners);
  }
  if (stone.faces.empty()) return {};
  return {stone};
}

std::vector<StoneSurface> read_ascii(const std::string& file, const std::string& contents) {
  std::vector<StoneSurface> stones;
  StoneLines lines(file, contents);
  std::vector<Vector<3>> corners;
  while (lines.next()) {
    const std::string& word = lines.words()[0];
    if (word == "solid") {
      stones.emplace_back();
      const std::string name = lines.text_from(1);
      stones.back().name = name.empty() ? stem(file) : name;
      stones.back().origin = lines.place();
    } else if (stones.empty()) {
      lines.refuse("is " + in_quotes(word) + ", not solid, and the size of the file is none of a binary STL",
                   "Export the file anew");
    } else if (word == "vertex") {
      corners.push_back(lines.point(1));
    } else if (word == "endfacet") {
      if (corners.size() != 3)
        lines.refuse("ends a facet of " + counted(corners.size(), "corner"), "STL knows triangles only");
      add_triangle(stones.back(), {corners[0], corners[1], corners[2]});
      corners.clear();
    }
  }
  std::vector<StoneSurface> with_faces;
  for (auto& stone : stones)
    if (!stone.faces.empty()) with_faces.push_back(std::move(stone));
  return with_faces;
}

}  // namespace

std::vector<StoneSurface> read_stl(const std::string& file, const std::string& contents) {
  auto stones = is_binary(file, contents) ? read_binary(file, contents) : read_ascii(file, contents);
  if (stones.empty()) refuse_stones(file, "has no triangles", "Export the stone as a solid or a closed mesh");
  return stones;
}

}  // namespace voussoir
