#include "stones/stone_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/text.hpp"
#include "stones/stone_text.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {
namespace {

using Reader = std::vector<StoneSurface> (*)(const std::string&, const std::string&);

/// Nothing for a file that is none of stones.
Reader reader_of(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path.string());
  if (ending == ".obj") return read_obj;
  if (ending == ".stl") return read_stl;
  if (ending == ".ply") return read_ply;
  if (ending == ".json") return read_compas;
  if (ending == ".step" || ending == ".stp") return read_step;
  return nullptr;
}

std::string contents_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string contents((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file && !file.eof()) refuse_stones(path, "cannot be read", "Correct the name, or the rights of the file");
  return contents;
}

/// OBJ, STL and PLY of a folder by name; a JSON beside them may hold anything, such as loads.
std::vector<std::string> files_of(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (const Reader reader = reader_of(entry.path()); entry.is_regular_file() && reader && reader != read_compas)
      files.push_back(entry.path().string());
  if (files.empty())
    refuse_stones(folder, "is a folder without files .stl, .ply or .obj", "Put a file into it for each stone");
  std::sort(files.begin(), files.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;  // stone_9 before stone_10
  });
  return files;
}

}  // namespace

std::vector<StoneSurface> read_stones(const std::string& path, double unit) {
  const bool folder = std::filesystem::is_directory(path);
  if (!folder && !std::filesystem::is_regular_file(path))
    refuse_stones(path, "cannot be read (sought as " + std::filesystem::absolute(path).string() + ")",
                  "Correct the name or the folder");
  if (!folder && !reader_of(path))
    refuse_stones(path, "is no file of stones by its ending",
                  "Known are .obj, .stl, .ply, .json (of COMPAS), .step and .stp in space, and .csv, .dxf, .svg and "
                  ".geojson in the plane (a .dwg is saved as .dxf)");
  std::vector<StoneSurface> stones;
  for (const auto& file : folder ? files_of(path) : std::vector<std::string>{path})
    for (auto& stone : reader_of(file)(file, contents_of(file))) stones.push_back(std::move(stone));
  for (auto& stone : stones)
    for (auto& x : stone.points) x = unit * x;
  return stones;
}

}  // namespace voussoir
