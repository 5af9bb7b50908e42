// The only file that knows gmsh.
#include "mesh/gmsh_reader.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <utility>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "linalg/agree.hpp"
#include "mesh/cell_count.hpp"
#include "mesh/divisions.hpp"
#include "mesh/gmsh_failures.hpp"
#include "mesh/gmsh_numbers.hpp"
#include "mesh/gmsh_request.hpp"
#include "mesh/lattice.hpp"
#include "mesh/msh_format.hpp"
#include "mesh/node_numbers.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/temporary_file.hpp"

namespace voussoir {
namespace {

/// gmsh from initialisation to its end, silent; errors quote what it said.
class Gmsh {
 public:
  Gmsh() {
    gmsh::initialize(0, nullptr, false);  // no configuration files: the same mesh for every user
    gmsh::option::setNumber("General.Terminal", 0);
    // By default it throws where it meshes side by side, and what leaves a parallel region ends the program.
    gmsh::option::setNumber("General.AbortOnError", 1);
    gmsh::logger::start();
  }
  ~Gmsh() {
    gmsh::logger::stop();
    gmsh::finalize();
  }
  Gmsh(const Gmsh&) = delete;
  Gmsh& operator=(const Gmsh&) = delete;

  /// Runs a command of gmsh; its errors become an InputError about the file.
  template <class Command>
  void run(const std::string& file, const std::string& what, Command command) {
    bool failed = false;
    try {
      command();
    } catch (const std::bad_alloc&) {  // is no fault of the file
      throw;
    } catch (...) {  // gmsh throws strings and ints; the reason is in its log
      failed = true;
    }
    const std::string said = errors();
    if (failed || !said.empty())
      throw InputError("mesh > gmsh > file = " + file + "\n  gmsh could not " + what + ":\n" +
                       (said.empty() ? "    (it gave no reason)\n" : said) +
                       "  Open the file in gmsh itself to look for the place.");
  }

 private:
  static std::string errors() {
    std::vector<std::string> log;
    gmsh::logger::get(log);
    std::string lines;
    for (const std::string& line : log)
      if (line.compare(0, 5, "Error") == 0) lines += "    " + line + "\n";
    return lines;
  }
};

/// A finished mesh, not a geometry to be meshed.
bool is_mesh(const std::string& file) { return std::filesystem::path(file).extension() == ".msh"; }

/// Cells of that length everywhere, whatever points and fields of the file say.
void set_mesh_size(double size) {
  gmsh::option::setNumber("Mesh.MeshSizeMin", size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeFactor", 1);
}

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
void set_mesh_size(Gmsh& gmsh_itself, const GmshParameters& p) {
  const double size = p.element_size / p.unit;
  std::vector<DividedCurve> divided;
  gmsh_itself.run(p.file, "mesh the curves of the file", [&] {
    set_mesh_size(size);
    gmsh::model::mesh::generate(1);
    divided = divided_curves(p.unit);
  });
  const auto divisions = divisions_for(divided, p.element_size, p.file);
  gmsh_itself.run(p.file, "mesh the curves of the file", [&] {
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
                      std::to_string(found->second.size()) + " cells whatever is wanted (Layers of an Extrude?).",
                  "Write DefineConstant[ element_size = ... ]; in the file and use the number there.");
}

/// Refuses a drawing whose own sizes ask for more cells than can be computed with: found by meshing its curves, with
/// cells a thousand times smaller each time, so that no more edges are made than can be borne.
void refuse_too_fine(Gmsh& gmsh_itself, const GmshParameters& p, Drawing& drawing) {
  std::map<int, double> coarser;
  for (const double times : {1e9, 1e6, 1e3, 1.0}) {
    std::map<int, double> edges;
    gmsh_itself.run(p.file, "mesh the curves of the file", [&] { edges = edges_with(times); });
    drawing.divide(times == 1 ? edges : least_edges(edges, coarser, times));
    coarser = edges;
    refuse_too_many_cells(p, drawing);
  }
}

/// gmsh heeds it when it saves a mesh, and a mesh is not saved here.
void refuse_scaling(const std::string& file) {
  double scaling = 1;
  gmsh::option::getNumber("Mesh.ScalingFactor", scaling);
  if (scaling != 1)
    refuse_file(file, "sets Mesh.ScalingFactor = " + in_words(scaling) + ", which scales only what gmsh saves.",
                "Take it out, and say the unit of the file by mesh > gmsh > unit.");
}

void read_geo(Gmsh& gmsh_itself, const GmshParameters& p, const std::map<std::string, double>& numbers) {
  const TemporaryFile with_numbers(geo_with_numbers(numbers, std::filesystem::absolute(p.file).string()), ".geo");
  gmsh_itself.run(p.file, "read the file", [&] { gmsh::open(with_numbers.path()); });
  refuse_scaling(p.file);
}

void open_file(Gmsh& gmsh_itself, const GmshParameters& p) {
  const std::filesystem::path path = std::filesystem::absolute(p.file);
  const std::string ending = path.extension().string();
  std::ifstream file(path);
  if (!file || !std::filesystem::is_regular_file(path))
    refuse_file(p.file, "cannot be read (sought as " + path.string() + ").", "Correct the name or the folder.");
  if (ending == ".msh") {
    if (p.element_size > 0 || !p.geometry.empty())
      refuse_file(p.file, "is a finished mesh: \"element size\" and \"geometry\" cannot change it.",
                  "Remove these keys or give the .geo file.");
    gmsh_itself.run(p.file, "read the file", [&] { gmsh::open(path.string()); });
  } else if (ending == ".geo") {
    const auto numbers = numbers_to_set(p, path.string());
    read_geo(gmsh_itself, p, numbers);
    if (p.element_size > 0 && numbers.count("element_size") == 0) set_mesh_size(gmsh_itself, p);
    gmsh_itself.run(p.file, "mesh the file", [] { gmsh::model::mesh::generate(2); });
  } else {
    refuse_file(p.file, "is neither .geo nor .msh.", "Save other formats as .msh (version 4.1) in gmsh.");
  }
}

/// The names of physical groups of a dimension, and for each entity the groups it is in, by tag.
struct Groups {
  std::vector<std::string> names;
  std::map<int, std::vector<int>> of_entity;      ///< indices of names, ascending
  std::map<int, std::vector<std::string>> named;  ///< a name for each group, though groups may have the same
};

Groups read_groups(const std::string& file, int dimension) {
  Groups groups;
  gmsh::vectorpair tags;
  gmsh::model::getPhysicalGroups(tags, dimension);
  std::sort(tags.begin(), tags.end());
  for (const auto& [dim, tag] : tags) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    if (name.empty()) name = "group " + std::to_string(tag);
    if (name == "all")
      refuse_file(file, "has a physical group named \"all\", which always means every block or the whole border.",
                  "Choose another name.");
    const auto known = std::find(groups.names.begin(), groups.names.end(), name);
    const int set = static_cast<int>(known - groups.names.begin());
    if (known == groups.names.end()) groups.names.push_back(name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dim, tag, entities);
    for (const int entity : entities) {
      groups.of_entity[std::abs(entity)].push_back(set);
      groups.named[std::abs(entity)].push_back(name);
    }
  }
  for (auto& [entity, sets] : groups.of_entity) {
    sort_unique(sets);
  }
  return groups;
}

std::string name_of_entity(int dimension, int tag) {
  return (dimension == 2 ? "surface " : "curve ") + std::to_string(tag);
}

/// Nodes of each element of one entity, all of first order.
std::vector<std::vector<std::size_t>> read_elements(const std::string& file, int dimension, int entity) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes, elements;
  gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
  for (std::size_t t = 0; t < types.size(); ++t) {
    const int line = 1, triangle = 2, quadrilateral = 3;  // types of the MSH format
    const int count = types[t] == line ? 2 : types[t] == triangle ? 3 : types[t] == quadrilateral ? 4 : 0;
    if (count == 0 && !tags[t].empty())
      refuse_file(file,
                  "has on " + name_of_entity(dimension, entity) + " cells with " +
                      std::to_string(nodes[t].size() / tags[t].size()) +
                      " nodes; only triangles with 3, quadrilaterals with 4 and edges with 2 nodes are known.",
                  "Set Mesh.ElementOrder = 1 and mesh again.");
    for (auto node = nodes[t].begin(); count > 0 && node != nodes[t].end(); node += count)
      elements.emplace_back(node, node + count);
  }
  return elements;
}

SurfaceMesh read_surfaces(const GmshParameters& p) {
  SurfaceMesh mesh;
  std::vector<double> coordinates, parametric;
  std::vector<std::size_t> node_tags;
  gmsh::model::mesh::getNodes(node_tags, coordinates, parametric, -1, -1, false, false);
  const NodeNumbers number(p.file, p.unit, node_tags, coordinates, mesh);
  Groups surface_groups = read_groups(p.file, 2), curve_groups = read_groups(p.file, 1);
  mesh.block_sets = surface_groups.names;
  mesh.facet_sets = curve_groups.names;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, 2);
  std::sort(entities.begin(), entities.end());
  if (entities.empty())
    refuse_file(p.file, "has no surface; every surface becomes a block.", "Add Plane Surfaces to the file.");
  const bool groups_of_cells = is_mesh(p.file) && !lists_surfaces(p.file);
  const auto elements_of = [&](int dimension, int entity, Groups& groups) {
    auto elements = read_elements(p.file, dimension, entity);
    if (!groups_of_cells) return elements;
    const auto keep = one_of_each_group(p.file, name_of_entity(dimension, entity), groups.named[entity], elements);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (keep[k]) elements[kept++] = elements[k];
    elements.resize(kept);
    return elements;
  };
  bool quadrilaterals = false;
  for (const auto& [dim, tag] : entities) {
    SurfaceMesh::Surface surface;
    surface.tag = tag;
    surface.sets = surface_groups.of_entity[tag];
    for (const auto& nodes : elements_of(dim, tag, surface_groups)) {
      Cell cell;
      cell.count = static_cast<int>(nodes.size());
      quadrilaterals = quadrilaterals || cell.count == 4;
      for (int k = 0; k < cell.count; ++k) cell.node[k] = number(nodes[k]);
      surface.cells.push_back(cell);
    }
    mesh.surfaces.push_back(std::move(surface));
  }
  if (p.cells == CellType::quadrilateral && !quadrilaterals)
    refuse_mesh("gmsh > cells", "quadrilateral", "cannot be had: the mesh of " + p.file + " has triangles only.",
                "Let the file recombine its surfaces when the number `recombine` is 1, or choose triangle.");
  for (const auto& [curve, sets] : curve_groups.of_entity)
    for (const auto& nodes : elements_of(1, curve, curve_groups))
      for (const int set : sets) mesh.lines.push_back({{number(nodes[0]), number(nodes[1])}, set});
  return mesh;
}

/// What a child process does before a .geo is meshed, in a process of its own because meshes depend on what was meshed
/// before: refuses a drawing that asks for too many cells. Its answer may explain why gmsh fails.
std::string look_at(const std::string& request) {
  const GmshParameters p = gmsh_parameters_of(request);
  const std::filesystem::path path = std::filesystem::absolute(p.file);
  if (path.extension() != ".geo" || !std::filesystem::is_regular_file(path)) return "";
  Gmsh gmsh_itself;
  const auto numbers = numbers_to_set(p, path.string());
  read_geo(gmsh_itself, p, numbers);
  Drawing drawing;
  gmsh_itself.run(p.file, "measure the file", [&] { drawing = drawing_of(p.unit); });
  if (p.element_size > 0) {
    drawing.divide(p.element_size);
    refuse_too_many_cells(p, drawing);
  } else {
    refuse_too_fine(gmsh_itself, p, drawing);
  }
  return far_from_origin(drawing);
}

/// What a child process does.
std::string mesh_of(const std::string& request) {
  const GmshParameters parameters = gmsh_parameters_of(request);
  Gmsh gmsh_itself;
  open_file(gmsh_itself, parameters);
  return bytes_of(read_surfaces(parameters));
}

}  // namespace

std::unique_ptr<BlockSource<2>> read_gmsh(const GmshParameters& parameters, const Teuchos::Comm<int>& comm,
                                          Trust trust) {
  BlockList<2> list;
  on_first_rank(comm, [&] {
    if (trust == Trust::no) refuse_commands(parameters.file, parameters.file);
    const auto died = [&](const ChildEnd& end) { refuse_end(parameters.file, end); };
    const std::string hint = in_child_process(look_at, bytes_of(parameters), died);
    const SurfaceMesh mesh =
        with_hint(hint, [&] { return surface_mesh_of(in_child_process(mesh_of, bytes_of(parameters), died)); });
    list = blocks_of_surfaces(mesh);
    if (is_mesh(parameters.file)) list.warnings = warnings_of_format(parameters.file, mesh);
  });
  broadcast_blocks(comm, list);
  return make_source(std::move(list));
}

}  // namespace voussoir
