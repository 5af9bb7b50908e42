// STEP, by the OpenCASCADE that gmsh has.
#include <gmsh.h>

#include <map>
#include <utility>

#include "gmsh/gmsh_session.hpp"
#include "gmsh/gmsh_works.hpp"
#include "stones/step_solids.hpp"

namespace voussoir {
namespace {

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

}  // namespace

std::string gmsh_work::step_triangulated(const std::string& file) {
  StepSolids solids;
  Gmsh gmsh_itself;
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
  size_by_curvature();
  solids.failure = gmsh_itself.run_piece([&] {
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

}  // namespace voussoir
