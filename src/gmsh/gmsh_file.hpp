// A file of gmsh in gmsh: opened, and what it holds by entities and physical groups.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gmsh/gmsh_session.hpp"
#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// Runs commands; what gmsh tells of their failure becomes an InputError about the file.
/// @param what  "mesh the file"
void run_on_file(Gmsh&, const std::string& file, const std::string& what, const std::function<void()>& commands);

/// Opens a finished mesh; one cannot change its cells.
void open_mesh(Gmsh&, const GmshParameters&);

/// Opens a .geo with numbers set in it.
void open_geo(Gmsh&, const GmshParameters&, const std::map<std::string, double>& numbers);

/// Cells of that length [units of the file] everywhere, whatever points and fields of the file say.
void set_mesh_size(double size);

/// The names of physical groups of a dimension, and for each entity the groups it is in, by tag.
struct Groups {
  std::vector<std::string> names;
  std::map<int, std::vector<int>> of_entity;      ///< indices of names, ascending
  std::map<int, std::vector<std::string>> named;  ///< a name for each group, though groups may have the same
};
Groups read_groups(const std::string& file, int dimension);

/// Nodes of each element of one entity, all of first order. Formats that list no entities have an element once for each
/// of its groups: it is kept once.
std::vector<std::vector<std::size_t>> read_elements(const std::string& file, int dimension, int entity, Groups&);

}  // namespace voussoir
