#include "stones/stone_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "base/file_ending.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/stone_names.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

namespace fs = std::filesystem;

bool is_of_stones(const fs::path& path) {
  const std::set<std::string> known{".obj", ".stl", ".ply", ".json", ".step", ".stp"};
  return known.count(lower_ending(path.string())) > 0;
}

std::string contents_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string contents((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file && !file.eof()) refuse_stones(path, "cannot be read", "Correct the name, or the rights of the file");
  return contents;
}

std::vector<StoneSurface> stones_of(const std::string& path, Warnings& warnings) {
  const std::string ending = lower_ending(path), contents = contents_of(path);
  if (ending == ".obj") return read_obj(path, contents);
  if (ending == ".stl") return read_stl(path, contents, warnings);
  if (ending == ".ply") return read_ply(path, contents);
  if (ending == ".json") return read_compas(path, contents);
  return read_step(path, contents);
}

/// Files of a folder that hold stones, and those that might and are not read.
struct FolderFiles {
  std::vector<std::string> read, hidden, below;
};

/// A JSON beside others may hold anything, such as loads. Names that begin with a dot are no files of a user's: macOS
/// keeps its own notes of stone.stl in ._stone.stl.
FolderFiles files_of(const std::string& folder) {
  FolderFiles files;
  std::error_code unreadable;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, options, unreadable), end; at != end; at.increment(unreadable)) {
    const auto& path = at->path();
    if (!at->is_regular_file(unreadable) || !is_of_stones(path) || lower_ending(path.string()) == ".json") continue;
    if (at.depth() > 0)
      files.below.push_back(fs::relative(path, folder, unreadable).string());
    else if (path.filename().string()[0] == '.')
      files.hidden.push_back(path.filename().string());
    else
      files.read.push_back(path.string());
  }
  const auto by_number = [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;  // stone_9 before stone_10
  };
  for (auto* list : {&files.read, &files.hidden, &files.below}) std::sort(list->begin(), list->end(), by_number);
  return files;
}

/// "the folder has 3 files of stones in folders below it (sub/stone_7.stl, ...)", or nothing.
std::string not_read(const FolderFiles& files) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& names, const std::string& what) {
    if (names.empty()) return;
    std::vector<std::string> shown;
    for (const auto& name : names) shown.push_back(as_utf8(name));
    text += (text.empty() ? "" : " and ") + counted(names.size(), "file") + " of stones " + what + " (" +
            list_of(shown, 3) + ")";
  };
  add(files.below, "in folders below it");
  add(files.hidden, "with a dot before the name");
  return text.empty() ? "" : "the folder has " + text;
}

std::vector<std::string> files_to_read(const std::string& folder, Warnings& warnings) {
  const auto files = files_of(folder);
  const std::string left_out = not_read(files);
  if (files.read.empty())
    refuse_stones(folder,
                  "is a folder without files .stl, .ply, .obj, .step or .stp" +
                      (left_out.empty() ? "" : "; " + left_out + ", not read"),
                  "Put a file into it for each stone");
  if (!left_out.empty())
    add_warning(warnings, {"files_not_read", "mesh > stones > file", "",
                           static_cast<double>(files.hidden.size() + files.below.size()),
                           left_out + ", not read: where they are stones, put them into the folder itself" +
                               (files.hidden.empty() ? "" : ", under names without that dot")});
  return files.read;
}

}  // namespace

bool says_its_unit(const std::string& file) {
  const auto ending = lower_ending(file);
  return ending == ".step" || ending == ".stp";
}

std::vector<StoneSurface> read_stones(const std::string& path, double unit, Warnings& warnings) {
  const bool folder = fs::is_directory(path);
  if (!folder && !fs::is_regular_file(path))
    refuse_stones(path, "cannot be read (sought as " + fs::absolute(path).string() + ")",
                  "Correct the name or the folder");
  if (!folder && !is_of_stones(path))
    refuse_stones(path, "is no file of stones by its ending",
                  "Known are .obj, .stl, .ply, .json (of COMPAS), .step and .stp (STEP), .geo and .msh (of gmsh) in "
                  "space, and .csv, .dxf, .svg and .geojson in the plane (a .dwg is saved as .dxf)");
  const auto files = folder ? files_to_read(path, warnings) : std::vector<std::string>{path};
  std::vector<StonesOfFile> read;
  int told = 0;
  for (const auto& file : files) {
    read.push_back({stem(file), stones_of(file, warnings)});
    if (says_its_unit(file)) {
      ++told;
      continue;
    }
    for (auto& stone : read.back().stones)
      for (auto& x : stone.points) x = unit * x;
  }
  if (told > 0 && unit != 1)
    add_warning(warnings, {"unit_not_used", "mesh > stones > unit", "", unit,
                           "STEP files say their own unit, by which their lengths are metres here: " +
                               number_text(unit) + " m is not used for " + counted(told, "such file") +
                               "; leave the key out, or correct "
                               "the unit in the file where it is wrong"});
  return with_names_that_differ(std::move(read), warnings);
}

std::vector<StoneSurface> read_stones(const std::string& path, double unit) {
  Warnings untold;
  return read_stones(path, unit, untold);
}

}  // namespace voussoir
