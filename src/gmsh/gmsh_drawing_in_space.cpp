// Volumes of drawings and meshes.
#include <gmsh.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/sort_unique.hpp"
#include "gmsh/gmsh_file.hpp"
#include "gmsh/gmsh_works.hpp"
#include "mesh/gmsh_failures.hpp"
#include "mesh/gmsh_numbers.hpp"
#include "mesh/gmsh_request.hpp"
#include "mesh/msh_format.hpp"
#include "stones/gmsh_volumes.hpp"

namespace voussoir {
namespace {

/// Nodes in the order of their tags.
class Nodes {
 public:
  Nodes(std::string file, double unit, Places& position) : file_(std::move(file)) {
    std::vector<std::size_t> tags;
    std::vector<double> x, parametric;
    gmsh::model::mesh::getNodes(tags, x, parametric, -1, -1, false, false);
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t n = 0; n < tags.size(); ++n) order.emplace_back(tags[n], n);
    std::sort(order.begin(), order.end());
    for (const auto& [tag, n] : order) {
      tags_.push_back(tag);
      position.push_back({unit * x[3 * n], unit * x[3 * n + 1], unit * x[3 * n + 2]});
    }
  }
  int operator()(std::size_t tag) const {
    const auto found = std::lower_bound(tags_.begin(), tags_.end(), tag);
    if (found == tags_.end() || *found != tag)
      refuse_file(file_, "has a cell at node " + std::to_string(tag) + ", which is not there.", "Mesh it again.");
    return static_cast<int>(found - tags_.begin());
  }
  VolumeMesh::Face face(const std::vector<std::size_t>& tags) const {
    VolumeMesh::Face face;
    face.count = static_cast<int>(tags.size());
    for (int k = 0; k < face.count; ++k) face.node[k] = (*this)(tags[k]);
    return face;
  }

 private:
  std::string file_;
  std::vector<std::size_t> tags_;
};

void open_volumes(Gmsh& gmsh_itself, const GmshParameters& p, VolumesAs wanted) {
  require_file(p.file);
  if (is_mesh(p.file)) {
    auto mesh = p;
    mesh.element_size = 0;  // of a mesh that is made anew from its borders
    open_mesh(gmsh_itself, mesh);
    return;
  }
  const auto numbers = numbers_to_set(p, std::filesystem::absolute(p.file).string());
  open_geo(gmsh_itself, p, numbers);
  if (wanted == VolumesAs::meshed) {
    if (p.element_size > 0 && numbers.count("element_size") == 0) set_mesh_size(p.element_size / p.unit);
    run_on_file(gmsh_itself, p.file, "mesh the file", [] { gmsh::model::mesh::generate(3); });
    return;
  }
  size_by_curvature();
  run_on_file(gmsh_itself, p.file, "mesh the surfaces of the file", [] { gmsh::model::mesh::generate(2); });
}

/// Nodes at points of the drawing, and on its curves where two surfaces meet.
std::vector<int> folds_of(const Nodes& number) {
  std::vector<int> folds;
  std::vector<std::size_t> tags;
  std::vector<double> x, parametric;
  const auto add = [&](int dim, int entity) {
    gmsh::model::mesh::getNodes(tags, x, parametric, dim, entity, false, false);
    for (const auto tag : tags) folds.push_back(number(tag));
  };
  add(0, -1);
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  for (const auto& [dim, curve] : curves) {
    std::vector<int> surfaces, points;
    gmsh::model::getAdjacencies(dim, curve, surfaces, points);
    sort_unique(surfaces);
    if (surfaces.size() != 1) add(dim, curve);  // one: the seam of something round; none: a mesh without drawing
  }
  return folds;
}

VolumeMesh read(const GmshParameters& p, VolumesAs wanted) {
  VolumeMesh mesh;
  const Nodes number(p.file, p.unit, mesh.position);
  Groups volumes = read_groups(p.file, 3), surfaces = read_groups(p.file, 2);
  mesh.block_sets = volumes.names;
  mesh.facet_sets = surfaces.names;
  if (wanted == VolumesAs::meshed) mesh.folds = folds_of(number);
  gmsh::vectorpair entities, around;
  gmsh::model::getEntities(entities, 3);
  std::sort(entities.begin(), entities.end());
  if (entities.empty())
    refuse_file(p.file, "has no volume; every volume is a stone.",
                "Add Volumes to the file; for surfaces in a plane give mesh > type = gmsh.");
  for (const auto& [dim, tag] : entities) {
    VolumeMesh::Volume volume;
    volume.tag = tag;
    volume.sets = volumes.of_entity[tag];
    if (wanted == VolumesAs::meshed)
      for (const auto& nodes : read_elements(p.file, dim, tag, volumes)) {
        Cell cell;
        cell.count = static_cast<int>(nodes.size());
        for (int k = 0; k < cell.count; ++k) cell.node[k] = number(nodes[k]);
        volume.cells.push_back(cell);
      }
    else
      gmsh::model::getBoundary({{dim, tag}}, around, false, false, false);
    if (wanted == VolumesAs::outlined)
      for (const auto& surface : around)
        for (const auto& nodes : read_elements(p.file, 2, surface.second, surfaces))
          volume.border.push_back(number.face(nodes));
    mesh.volumes.push_back(std::move(volume));
  }
  for (const auto& [surface, sets] : surfaces.of_entity)
    for (const auto& nodes : read_elements(p.file, 2, surface, surfaces))
      for (const int set : sets) mesh.faces.push_back({number.face(nodes), set});
  return mesh;
}

std::string volumes_of(const std::string& request, VolumesAs wanted) {
  const auto p = gmsh_parameters_of(request);
  Gmsh gmsh_itself;
  open_volumes(gmsh_itself, p, wanted);
  return bytes_of(read(p, wanted));
}

}  // namespace

std::string gmsh_work::volumes_meshed(const std::string& request) { return volumes_of(request, VolumesAs::meshed); }

std::string gmsh_work::volumes_outlined(const std::string& request) { return volumes_of(request, VolumesAs::outlined); }

}  // namespace voussoir
