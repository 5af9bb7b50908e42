#include <filesystem>

#include "mesh/bytes.hpp"
#include "mesh/gmsh_program.hpp"
#include "stones/gmsh_crash.hpp"
#include "stones/step_solids.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {

std::vector<StoneSurface> read_step(const std::string& file, const std::string&) {
  StepSolids solids;
  try {
    const std::string bytes = in_gmsh_child(gmsh_work::triangulate_step, std::filesystem::absolute(file).string());
    ByteReader reader(bytes);
    exchange(reader, solids);
  } catch (const GmshCrash& crash) {
    solids.failure = crash.how;
  }
  if (!solids.failure.empty())
    refuse_stones(file, "cannot be read by gmsh: " + solids.failure, "Export it anew as STEP AP214 or AP203");
  if (solids.stones.empty())
    refuse_stones(file, "has no solids", "Export the stones as solids, not as surfaces or curves");
  for (auto& stone : solids.stones) {
    stone.origin = std::filesystem::path(file).filename().string();
    for (const auto& face : stone.faces)
      for (const int point : face)
        if (point < 0 || point >= static_cast<int>(stone.points.size())) refuse_bytes("a number of a point is none");
  }
  return solids.stones;
}

}  // namespace voussoir
