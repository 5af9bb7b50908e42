// STEP, by the OpenCASCADE that gmsh has.
#include <gmsh.h>

#include <filesystem>
#include <map>
#include <utility>

#include "mesh/bytes.hpp"
#include "stones/gmsh_session.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

constexpr double chords = 16;  ///< of a full turn: what curved faces are cut into; a hundredth of the radius off

/// What a child answers.
struct StepSolids {
  std::vector<StoneSurface> stones;
  std::string failure;
};

template <class Bytes, class Solids>
void exchange(Bytes& bytes, Solids& solids) {
  plain_list(bytes, solids.failure);
  const std::size_t stones = bytes.size(solids.stones, sizeof(std::size_t));
  for (std::size_t k = 0; k < stones; ++k) {
    plain_list(bytes, solids.stones[k].name);
    bytes.plain(solids.stones[k].curved);
    plain_list(bytes, solids.stones[k].points);
    const std::size_t faces = bytes.size(solids.stones[k].faces, sizeof(std::size_t));
    for (std::size_t f = 0; f < faces; ++f) plain_list(bytes, solids.stones[k].faces[f]);
  }
}

/// Places of all nodes by their tags.
std::map<std::size_t, Vector<3>> places() {
  std::vector<std::size_t> tags;
  std::vector<double> x, parametric;
  gmsh::model::mesh::getNodes(tags, x, parametric);
  std::map<std::size_t, Vector<3>> place;
  for (std::size_t k = 0; k < tags.size(); ++k) place[tags[k]] = {x[3 * k], x[3 * k + 1], x[3 * k + 2]};
  return place;
}

StoneSurface surface_of(int solid, const std::map<std::size_t, Vector<3>>& place) {
  StoneSurface stone;
  gmsh::model::getEntityName(3, solid, stone.name);
  if (stone.name.empty()) stone.name = "solid " + std::to_string(solid);
  gmsh::vectorpair faces;
  gmsh::model::getBoundary({{3, solid}}, faces, false, false, false);
  std::map<std::size_t, int> number;
  for (const auto& [dim, face] : faces) {
    std::string type;
    gmsh::model::getType(dim, face, type);
    if (type != "Plane") ++stone.curved;
    std::vector<std::size_t> tags, corners;
    gmsh::model::mesh::getElementsByType(2, tags, corners, face);
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      stone.faces.emplace_back();
      for (std::size_t c = k; c < k + 3; ++c) {
        const auto [known, is_new] = number.emplace(corners[c], static_cast<int>(stone.points.size()));
        if (is_new) stone.points.push_back(place.at(corners[c]));
        stone.faces.back().push_back(known->second);
      }
    }
  }
  return stone;
}

/// What a child does: the file as triangles, as few as its faces have corners.
std::string triangulated(const std::string& file) {
  StepSolids solids;
  GmshSession gmsh_itself;
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
  gmsh::option::setNumber("Mesh.MeshSizeMax", 1e22);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", chords);
  solids.failure = gmsh_itself.run([&] {
    gmsh::vectorpair shapes, entities;
    gmsh::model::occ::importShapes(file, shapes, true, "step");
    gmsh::model::occ::synchronize();
    gmsh::model::mesh::generate(2);
    const auto place = places();
    gmsh::model::getEntities(entities, 3);
    for (const auto& [dim, tag] : entities) solids.stones.push_back(surface_of(tag, place));
  });
  ByteWriter writer;
  exchange(writer, std::as_const(solids));
  return writer.bytes;
}

}  // namespace

std::vector<StoneSurface> read_step(const std::string& file, const std::string&) {
  StepSolids solids;
  try {
    const std::string bytes = in_gmsh_child(triangulated, std::filesystem::absolute(file).string());
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
