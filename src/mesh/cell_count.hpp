// How many cells a drawing or a generator asks for, known before the first is made.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// A stone as drawn, and how finely its border is to be divided.
struct DrawnStone {
  double area = 0;                    ///< [m2] negative where its border runs clockwise
  double border = 0;                  ///< [m] length
  double edges = 0;                   ///< on the border
  std::map<int, double> length_of{};  ///< [m] of curves of the border
};

/// What is known of a drawing when its curves are.
struct Drawing {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double from[2] = {infinity, infinity}, to[2] = {-infinity, -infinity};  ///< [m] the box around it
  std::vector<DrawnStone> stones;

  /// Counts a curve of the border of the last stone, by points along it [m].
  /// @param curve  its number; negative where the border runs against it
  void add(int curve, const std::vector<Vector<2>>& points);
  /// Divides all borders into edges of a length [m].
  void divide(double length);
  /// Divides each curve into so many edges, one where nothing is said.
  void divide(const std::map<int, double>& edges);

 private:
  Vector<2> first_{};  ///< [m] about which areas are taken: far from the origin they would have no digits
};

/// At least so many edges each curve has, told from as many as it has with sizes so many times as large. One that has
/// had as many with sizes larger still follows no sizes: the file divides it itself.
/// @param coarser  edges with those larger sizes; empty at first
std::map<int, double> least_edges(const std::map<int, double>& edges, const std::map<int, double>& coarser,
                                  double times);

/// Area over the square of the mean edge of the border, for each stone: the cells it is divided into, within a factor
/// of two or three by their shape.
double cells_of(const Drawing&);
/// Of a generator; of a file, which has to be read, nothing.
double cells_of(const MeshParameters&);

/// The most cells that this machine could compute with. A fixed number for each cell, because the cost of a cell in
/// memory depends little on the structure, and the whole memory, because what is free now may be more in a minute.
double most_cells();

/// Why so many cells are too many for this machine; "" where they are not.
std::string too_many_cells(double cells);

/// Throws InputError for a drawing that asks for more cells than this machine could compute with, with its size and how
/// many: probably its unit is another.
void refuse_too_many_cells(const GmshParameters&, const Drawing&);
/// The same for a generator.
void refuse_too_many_cells(const MeshParameters&);

/// Why gmsh may fail on a drawing that lies far from its origin; "" for one that does not.
std::string far_from_origin(const Drawing&);

}  // namespace voussoir
