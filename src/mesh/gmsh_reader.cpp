// The only file that knows gmsh.
#include "mesh/gmsh_reader.hpp"

#include <gmsh.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/sort_unique.hpp"
#include "mesh/gmsh_numbers.hpp"
#include "mesh/lattice.hpp"
#include "mesh/on_rank_zero.hpp"
#include "mesh/surface_mesh.hpp"

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

/// A file for the eyes of gmsh alone, gone with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) {
    path_ = (std::filesystem::temp_directory_path() / "voussoir-XXXXXX.geo").string();
    const int descriptor = mkstemps(path_.data(), 4);
    if (descriptor < 0)
      throw ResourceError("no file can be written in " + path_ + " (set TMPDIR to a folder with room).");
    close(descriptor);
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

[[noreturn]] void refuse_file(const std::string& file, const std::string& why, const std::string& advice) {
  refuse_mesh("gmsh > file", file, why, advice);
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
    std::ostringstream text;
    text << file.rdbuf();
    const TemporaryFile with_numbers(geo_with_numbers(numbers_to_set(p, text.str()), path.string()));
    gmsh_itself.run(p.file, "read the file", [&] { gmsh::open(with_numbers.path()); });
    gmsh_itself.run(p.file, "mesh the file", [] { gmsh::model::mesh::generate(2); });
  } else {
    refuse_file(p.file, "is neither .geo nor .msh.", "Save other formats as .msh (version 4.1) in gmsh.");
  }
}

/// The names of physical groups of a dimension, and for each entity the groups it is in, by tag.
struct Groups {
  std::vector<std::string> names;
  std::map<int, std::vector<int>> of_entity;
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
    for (const int entity : entities) groups.of_entity[std::abs(entity)].push_back(set);
  }
  for (auto& [entity, sets] : groups.of_entity) {
    sort_unique(sets);
  }
  return groups;
}

/// Nodes in the order of their tags.
class NodeNumbers {
 public:
  NodeNumbers(std::string file, SurfaceMesh& mesh) : file_(std::move(file)) {
    std::vector<double> coordinates, parametric;
    std::vector<std::size_t> tags;
    gmsh::model::mesh::getNodes(tags, coordinates, parametric, -1, -1, false, false);
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t n = 0; n < tags.size(); ++n) order.emplace_back(tags[n], n);
    std::sort(order.begin(), order.end());
    double extent = 0, off_plane = 0;
    for (const auto& [tag, n] : order) {
      const double* x = &coordinates[3 * n];
      tags_.push_back(tag);
      mesh.position.push_back({x[0], x[1]});
      extent = std::max({extent, std::abs(x[0]), std::abs(x[1])});
      off_plane = std::max(off_plane, std::abs(x[2]));
    }
    if (off_plane > coincidence * extent)
      refuse_file(file_, "has nodes at z = " + in_words(off_plane) + " m; a plane scene lies in z = 0.",
                  "Draw the structure in the x-y plane, y upward.");
  }
  int operator()(std::size_t tag) const {
    const auto found = std::lower_bound(tags_.begin(), tags_.end(), tag);
    if (found == tags_.end() || *found != tag)
      refuse_file(file_, "has a cell at node " + std::to_string(tag) + ", which is not there.", "Mesh it again.");
    return static_cast<int>(found - tags_.begin());
  }

 private:
  std::string file_;
  std::vector<std::size_t> tags_;
};

/// Elements of one entity, all of first order: their nodes per element, element by element.
struct Elements {
  int nodes_each = 0;
  std::vector<std::size_t> nodes;
};

std::vector<Elements> read_elements(const std::string& file, int dimension, int entity) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
  std::vector<Elements> elements;
  for (std::size_t t = 0; t < types.size(); ++t) {
    const int line = 1, triangle = 2, quadrilateral = 3;  // types of the MSH format
    const int count = types[t] == line ? 2 : types[t] == triangle ? 3 : types[t] == quadrilateral ? 4 : 0;
    if (count == 0 && !tags[t].empty())
      refuse_file(file,
                  "has on " + std::string(dimension == 2 ? "surface " : "curve ") + std::to_string(entity) +
                      " cells with " + std::to_string(nodes[t].size() / tags[t].size()) +
                      " nodes; only triangles with 3, quadrilaterals with 4 and edges with 2 nodes are known.",
                  "Set Mesh.ElementOrder = 1 and mesh again.");
    elements.push_back({count, std::move(nodes[t])});
  }
  return elements;
}

SurfaceMesh read_surfaces(const GmshParameters& p) {
  SurfaceMesh mesh;
  const NodeNumbers number(p.file, mesh);
  Groups surface_groups = read_groups(p.file, 2), curve_groups = read_groups(p.file, 1);
  mesh.block_sets = surface_groups.names;
  mesh.facet_sets = curve_groups.names;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, 2);
  std::sort(entities.begin(), entities.end());
  if (entities.empty())
    refuse_file(p.file, "has no surface; every surface becomes a block.", "Add Plane Surfaces to the file.");
  bool quadrilaterals = false;
  for (const auto& [dim, tag] : entities) {
    SurfaceMesh::Surface surface;
    surface.tag = tag;
    surface.sets = surface_groups.of_entity[tag];
    for (const Elements& elements : read_elements(p.file, dim, tag)) {
      quadrilaterals = quadrilaterals || elements.nodes_each == 4;
      for (std::size_t first = 0; first < elements.nodes.size(); first += elements.nodes_each) {
        Cell cell;
        cell.count = elements.nodes_each;
        for (int k = 0; k < cell.count; ++k) cell.node[k] = number(elements.nodes[first + k]);
        surface.cells.push_back(cell);
      }
    }
    mesh.surfaces.push_back(std::move(surface));
  }
  if (p.cells == CellType::quadrilateral && !quadrilaterals)
    refuse_mesh("gmsh > cells", "quadrilateral", "cannot be had: the mesh of " + p.file + " has triangles only.",
                "Let the file recombine its surfaces when the number `recombine` is 1, or choose triangle.");
  for (const auto& [curve, sets] : curve_groups.of_entity)
    for (const Elements& elements : read_elements(p.file, 1, curve))
      for (std::size_t first = 0; first < elements.nodes.size(); first += 2)
        for (const int set : sets)
          mesh.lines.push_back({{number(elements.nodes[first]), number(elements.nodes[first + 1])}, set});
  return mesh;
}

}  // namespace

std::unique_ptr<BlockSource<2>> read_gmsh(const GmshParameters& parameters, const Teuchos::Comm<int>& comm) {
  BlockList<2> list;
  on_rank_zero(comm, [&] {
    const auto work = [&] {
      Gmsh gmsh_itself;
      open_file(gmsh_itself, parameters);
      return bytes_of(read_surfaces(parameters));
    };
    const auto died = [&](const std::string& signal) {
      refuse_file(parameters.file, "made gmsh crash (" + signal + ").",
                  "Open the file in gmsh itself; where it is damaged, save it anew in format 4.1.");
    };
    list = blocks_of_surfaces(surface_mesh_of(in_child_process(work, died)));
  });
  broadcast_blocks(comm, list);
  return make_source(std::move(list));
}

}  // namespace voussoir
