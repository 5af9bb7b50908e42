// Drawings in the plane.
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/file_ending.hpp"
#include "base/words.hpp"
#include "gmsh/gmsh_file.hpp"
#include "gmsh/gmsh_works.hpp"
#include "mesh/cell_count.hpp"
#include "mesh/divisions.hpp"
#include "mesh/gmsh_failures.hpp"
#include "mesh/gmsh_numbers.hpp"
#include "mesh/gmsh_request.hpp"
#include "mesh/lattice.hpp"
#include "mesh/msh_format.hpp"
#include "mesh/node_numbers.hpp"
#include "mesh/surface_mesh.hpp"

namespace voussoir {
namespace {

/// Lengths [units of the file] of the cells of every curve, from its beginning.
std::map<int, std::vector<double>> cells_of_curves() {
  std::map<int, std::vector<double>> cells;
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  for (const auto& [dim, tag] : curves) {
    std::vector<std::size_t> nodes;
    std::vector<double> x, along;
    gmsh::model::mesh::getNodes(nodes, x, along, dim, tag, true);
    cells[tag] = edge_lengths(along, x);
  }
  return cells;
}

/// Points along a curve of the drawing, curved ones by a chord for each sixteenth [m].
std::vector<Vector<2>> along(int curve, double unit) {
  constexpr int chords = 16;
  std::vector<double> first, last, at, x;
  gmsh::model::getParametrizationBounds(1, curve, first, last);
  for (int k = 0; k <= chords; ++k) at.push_back(first.at(0) + (last.at(0) - first.at(0)) * k / chords);
  gmsh::model::getValue(1, curve, at, x);
  std::vector<Vector<2>> points;
  for (std::size_t k = 0; k + 2 < x.size(); k += 3) points.push_back({unit * x[k], unit * x[k + 1]});
  return points;
}

/// The stones as drawn, their borders not divided.
Drawing drawing_of(double unit) {
  Drawing drawing;
  gmsh::vectorpair surfaces, curves;
  gmsh::model::getEntities(surfaces, 2);
  for (const auto& surface : surfaces) {
    drawing.stones.emplace_back();
    gmsh::model::getBoundary({surface}, curves, false, true, false);
    for (const auto& [dim, tag] : curves) drawing.add(tag, along(std::abs(tag), unit));
  }
  return drawing;
}

/// Edges that each curve has when all sizes of the file are that many times as large.
std::map<int, double> edges_with(double times) {
  double factor;
  gmsh::option::getNumber("Mesh.MeshSizeFactor", factor);
  gmsh::option::setNumber("Mesh.MeshSizeFactor", times * factor);
  gmsh::model::mesh::clear();
  gmsh::model::mesh::generate(1);
  gmsh::option::setNumber("Mesh.MeshSizeFactor", factor);
  std::map<int, double> edges;
  for (const auto& [tag, cells] : cells_of_curves()) edges[tag] = static_cast<double>(cells.size());
  return edges;
}

/// Curves that have as many cells when four as when eight are wanted on each: the file divides them itself.
std::vector<DividedCurve> divided_curves(double unit) {
  const auto first = cells_of_curves();
  std::map<int, double> length;
  for (const auto& [tag, cells] : first)
    for (const double cell : cells) length[tag] += cell;
  const int nothing = gmsh::model::mesh::field::add("MathEval");  // in the place of the file's background
  gmsh::model::mesh::field::setString(nothing, "F", "1e22");
  gmsh::model::mesh::field::setAsBackgroundMesh(nothing);
  for (const char* source : {"Points", "Curvature"})
    gmsh::option::setNumber(std::string("Mesh.MeshSizeFrom") + source, 0);
  gmsh::option::setNumber("Mesh.MeshSizeMin", 0);
  gmsh::option::setNumber("Mesh.MeshSizeMax", 1e22);
  const auto divided_by = [&](double number) {
    gmsh::model::mesh::setSizeCallback([&](int dim, int tag, double, double, double) {
      const auto found = length.find(tag);
      return dim == 1 && found != length.end() ? found->second / number : 1e22;
    });
    gmsh::model::mesh::clear();
    gmsh::model::mesh::generate(1);
    gmsh::model::mesh::removeSizeCallback();
    return cells_of_curves();
  };
  return curves_divided_alike(divided_by(4), divided_by(8), unit);
}

/// The element size of a scene by gmsh's mesh size, where the file has no number of that name. Divisions of the file
/// (Transfinite Curve) do not follow a mesh size; they are set anew.
void divide_by_size(Gmsh& gmsh_itself, const GmshParameters& p) {
  const double size = p.element_size / p.unit;
  std::vector<DividedCurve> divided;
  run_on_file(gmsh_itself, p.file, "mesh the curves of the file", [&] {
    set_mesh_size(size);
    gmsh::model::mesh::generate(1);
    divided = divided_curves(p.unit);
  });
  const auto divisions = divisions_for(divided, p.element_size, p.file);
  run_on_file(gmsh_itself, p.file, "mesh the curves of the file", [&] {
    gmsh::model::mesh::clear();
    set_mesh_size(size);
    for (const Division& d : divisions)
      gmsh::model::mesh::setTransfiniteCurve(d.tag, d.cells + 1, "Progression", d.ratio);
    gmsh::model::mesh::generate(1);
  });
  const auto cells = cells_of_curves();
  for (const Division& d : divisions)
    if (const auto found = cells.find(d.tag); found != cells.end() && static_cast<int>(found->second.size()) != d.cells)
      refuse_mesh("gmsh > element size", in_words(p.element_size) + " m",
                  "cannot be had: curve " + std::to_string(d.tag) + " of " + p.file + " keeps its " +
                      counted(found->second.size(), "cell") + " whatever is wanted (Layers of an Extrude?).",
                  "Write DefineConstant[ element_size = ... ]; in the file and use the number there.");
}

/// Refuses a drawing whose own sizes ask for more cells than can be computed with: found by meshing its curves, with
/// cells a thousand times smaller each time, so that no more edges are made than can be borne.
void refuse_too_fine(Gmsh& gmsh_itself, const GmshParameters& p, Drawing& drawing) {
  std::map<int, double> coarser;
  for (const double times : {1e9, 1e6, 1e3, 1.0}) {
    std::map<int, double> edges;
    run_on_file(gmsh_itself, p.file, "mesh the curves of the file", [&] { edges = edges_with(times); });
    drawing.divide(times == 1 ? edges : least_edges(edges, coarser, times));
    coarser = edges;
    refuse_too_many_cells(p, drawing);
  }
}

/// The stones as drawn, from an open file.
Drawing measured(Gmsh& gmsh_itself, const GmshParameters& p) {
  Drawing drawing;
  run_on_file(gmsh_itself, p.file, "measure the file", [&] { drawing = drawing_of(p.unit); });
  return drawing;
}

/// Refuses a drawing with more cells of the size a scene asks for than can be computed with. Nothing is meshed for it.
void refuse_too_small_cells(const GmshParameters& p, Drawing& drawing) {
  drawing.divide(p.element_size);
  refuse_too_many_cells(p, drawing);
}

void open_file(Gmsh& gmsh_itself, const GmshParameters& p) {
  require_file(p.file);
  const std::filesystem::path path = std::filesystem::absolute(p.file);
  if (is_mesh(p.file)) {
    open_mesh(gmsh_itself, p);
  } else if (lower_ending(p.file) == ".geo") {
    const auto numbers = numbers_to_set(p, path.string());
    open_geo(gmsh_itself, p, numbers);
    if (p.element_size > 0) {
      Drawing drawing = measured(gmsh_itself, p);
      refuse_too_small_cells(p, drawing);
    }
    if (p.element_size > 0 && numbers.count("element_size") == 0) divide_by_size(gmsh_itself, p);
    run_on_file(gmsh_itself, p.file, "mesh the file", [] { gmsh::model::mesh::generate(2); });
  } else {
    refuse_file(p.file, "is neither .geo nor .msh.", "Save other formats as .msh (version 4.1) in gmsh.");
  }
}

SurfaceMesh read_surfaces(const GmshParameters& p) {
  SurfaceMesh mesh;
  std::vector<double> coordinates, parametric;
  std::vector<std::size_t> node_tags;
  gmsh::model::mesh::getNodes(node_tags, coordinates, parametric, -1, -1, false, false);
  const NodeNumbers number(p.file, p.unit, node_tags, coordinates, mesh);
  gmsh::model::mesh::getNodes(node_tags, coordinates, parametric, 0, -1, false, false);
  for (const auto tag : node_tags) mesh.corners.push_back(number(tag));
  Groups surface_groups = read_groups(p.file, 2), curve_groups = read_groups(p.file, 1);
  mesh.block_sets = surface_groups.names;
  mesh.facet_sets = curve_groups.names;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, 2);
  std::sort(entities.begin(), entities.end());
  if (entities.empty())
    refuse_file(p.file, "has no surface; every surface becomes a block.", "Add Plane Surfaces to the file.");
  bool quadrilaterals = false, triangles = false;
  for (const auto& [dim, tag] : entities) {
    SurfaceMesh::Surface surface;
    surface.tag = tag;
    surface.sets = surface_groups.of_entity[tag];
    for (const auto& nodes : read_elements(p.file, dim, tag, surface_groups)) {
      Cell cell;
      cell.count = static_cast<int>(nodes.size());
      quadrilaterals = quadrilaterals || cell.count == 4;
      triangles = triangles || cell.count == 3;
      for (int k = 0; k < cell.count; ++k) cell.node[k] = number(nodes[k]);
      surface.cells.push_back(cell);
    }
    mesh.surfaces.push_back(std::move(surface));
  }
  if (p.cells == CellType::quadratic_triangle && !triangles)
    refuse_mesh("gmsh > cells", "quadratic triangle",
                "cannot be had: the mesh of " + p.file + " has quadrilaterals only.",
                "Choose quadrilateral, or give a drawing that is meshed by triangles.");
  if (p.cells == CellType::quadrilateral && !quadrilaterals)
    refuse_mesh("gmsh > cells", "quadrilateral", "cannot be had: the mesh of " + p.file + " has triangles only.",
                "Let the file recombine its surfaces when the number `recombine` is 1, or choose triangle.");
  for (const auto& [curve, sets] : curve_groups.of_entity)
    for (const auto& nodes : read_elements(p.file, 1, curve, curve_groups))
      for (const int set : sets) mesh.lines.push_back({{number(nodes[0]), number(nodes[1])}, set});
  return mesh;
}

}  // namespace

std::string gmsh_work::looked_at(const std::string& request) {
  const GmshParameters p = gmsh_parameters_of(request);
  const std::filesystem::path path = std::filesystem::absolute(p.file);
  if (lower_ending(p.file) != ".geo" || !std::filesystem::is_regular_file(path)) return "";
  Gmsh gmsh_itself;
  const auto numbers = numbers_to_set(p, path.string());
  open_geo(gmsh_itself, p, numbers);
  Drawing drawing = measured(gmsh_itself, p);
  if (p.element_size > 0)
    refuse_too_small_cells(p, drawing);
  else
    refuse_too_fine(gmsh_itself, p, drawing);
  return far_from_origin(drawing);
}

std::string gmsh_work::drawing_meshed(const std::string& request) {
  const GmshParameters parameters = gmsh_parameters_of(request);
  Gmsh gmsh_itself;
  open_file(gmsh_itself, parameters);
  return bytes_of(read_surfaces(parameters));
}

}  // namespace voussoir
