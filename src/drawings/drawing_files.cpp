#include "drawings/drawing_files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/file_ending.hpp"
#include "base/text.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// A drawing of an office has some megabytes; what is larger is no drawing of stones that could be computed.
constexpr std::size_t largest_drawing = 256u << 20;  // bytes

}  // namespace

DrawnFile read_drawing(const std::string& path) {
  if (!std::filesystem::is_regular_file(path))
    refuse_stones(path, "cannot be read (sought as " + std::filesystem::absolute(path).string() + ")",
                  "Correct the name or the folder");
  std::error_code unknown;
  if (std::filesystem::file_size(path, unknown) > largest_drawing)
    refuse_stones(path, "is larger than 256 MB, which no drawing of stones is", "Give the stones alone");
  std::ifstream stream(path, std::ios::binary);
  const std::string contents((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream && !stream.eof()) refuse_stones(path, "cannot be read", "Correct the name, or the rights of the file");
  if (trimmed(contents).empty()) refuse_stones(path, "is empty", "Export the drawing anew");
  const std::string ending = lower_ending(path);
  auto drawn = ending == ".csv"   ? read_csv_stones(path, contents)
               : ending == ".dxf" ? read_dxf_stones(path, contents)
               : ending == ".svg" ? read_svg_stones(path, contents)
                                  : read_geojson_stones(path, contents);
  if (drawn.stones.empty())
    refuse_stones(
        path,
        "holds no stone" +
            (drawn.unused.empty() ? "" : " (what it has is no closed outline: " + list_of(drawn.unused) + ")"),
        "Draw every stone as one closed outline; edges drawn one by one are joined to polylines first (in CAD "
        "by JOIN or PEDIT)");
  for (std::size_t k = 0; k < drawn.stones.size(); ++k)
    if (drawn.stones[k].name.empty()) drawn.stones[k].name = "stone " + std::to_string(k + 1);
  return drawn;
}

}  // namespace voussoir
