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

/// The length of what the header tells of.
std::size_t whole_size(std::size_t triangles) { return header + bytes_of_triangle * triangles; }

std::size_t triangles_told(const std::string& file, const std::string& contents) {
  return StoneBytes(file, contents, header - 4, false).plain<std::uint32_t>();
}

/// By its size, which the number of triangles gives: headers of binary files may begin with the word of those of text.
/// What is less than a triangle more is no loss, only left over.
bool is_binary(const std::string& file, const std::string& contents) {
  if (contents.size() < header) return false;
  const std::size_t triangles = triangles_told(file, contents), size = contents.size(), whole = whole_size(triangles);
  if (size >= whole && size - whole < bytes_of_triangle) return true;
  if (contents.find('\0') == std::string::npos) return false;
  begin_of_text(file, contents);
  const std::string told = "tells of " + counted(triangles, "triangle") + ", in all " + counted(whole, "byte") +
                           ", and has " + std::to_string(size);
  if (size > whole)
    refuse_stones(file, told + ", " + counted(size - whole, "byte") + " more than its triangles take",
                  "The number of triangles in its header is damaged, or something else is attached: export it anew");
  refuse_stones(file, told, "It was cut when it was copied, or is damaged: export it anew");
}

std::vector<StoneSurface> read_binary(const std::string& file, const std::string& contents, Warnings& warnings) {
  StoneSurface stone;
  stone.name = stem(file);
  stone.origin = std::filesystem::path(file).filename().string();
  StoneBytes bytes(file, contents, header, false);
  while (bytes.left() >= bytes_of_triangle) {
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
  if (bytes.left() > 0)
    add_warning(warnings,
                {"bytes_left_over", stone.origin, "", static_cast<double>(bytes.left()),
                 "has " + counted(bytes.left(), "byte") + " more than its " + counted(stone.faces.size(), "triangle") +
                     " take, which are not read: look whether the stone is whole"});
  if (stone.faces.empty()) return {};
  return {stone};
}

std::vector<StoneSurface> read_ascii(const std::string& file, const std::string& contents) {
  std::vector<StoneSurface> stones;
  StoneLines lines(file, contents);
  std::vector<Vector<3>> corners;
  while (lines.next()) {
    const std::string word = lower(lines.words()[0]);  // some programs write capitals
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

std::vector<StoneSurface> read_stl(const std::string& file, const std::string& contents, Warnings& warnings) {
  auto stones = is_binary(file, contents) ? read_binary(file, contents, warnings) : read_ascii(file, contents);
  if (stones.empty()) refuse_stones(file, "has no triangles", "Export the stone as a solid or a closed mesh");
  return stones;
}

}  // namespace voussoir
