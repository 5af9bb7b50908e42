// Nodes of a file as nodes of a mesh: numbered anew in the order of their tags, in metres.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mesh/gmsh_failures.hpp"
#include "mesh/lattice.hpp"
#include "mesh/surface_mesh.hpp"

namespace voussoir {

/// Nodes in the order of their tags.
class NodeNumbers {
 public:
  /// @param coordinates  three of each node [units of the file]
  NodeNumbers(std::string file, double unit, const std::vector<std::size_t>& tags,
              const std::vector<double>& coordinates, SurfaceMesh& mesh)
      : file_(std::move(file)) {
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t n = 0; n < tags.size(); ++n) order.emplace_back(tags[n], n);
    std::sort(order.begin(), order.end());
    double extent = 0, off_plane = 0;
    for (const auto& [tag, n] : order) {
      const double* x = &coordinates[3 * n];
      tags_.push_back(tag);
      mesh.position.push_back({unit * x[0], unit * x[1]});
      extent = std::max({extent, std::abs(x[0]), std::abs(x[1])});
      off_plane = std::max(off_plane, std::abs(x[2]));
    }
    if (off_plane > coincidence * extent)
      refuse_file(file_, "has nodes at z = " + in_words(unit * off_plane) + " m; a plane scene lies in z = 0.",
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

}  // namespace voussoir
