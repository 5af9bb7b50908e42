// How curves that a .geo divides by itself (Transfinite Curve) follow a wanted size of cells.
//
// Opposite sides of a transfinite surface must have equally many cells, each side perhaps of several curves. What keeps
// all such sums right without knowing them is one factor for all curves: cells = m x (cells of the file / their
// greatest common divisor), with the smallest m for which no cell is longer than wanted.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace voussoir {

/// A curve whose number of cells no mesh size changes.
struct DividedCurve {
  int tag = 0;
  std::vector<double> lengths;  ///< [m] of its cells, from its beginning
};

/// New division of a curve: cells whose lengths grow by a ratio from one to the next.
struct Division {
  int tag = 0;
  int cells = 0;
  double ratio = 1;
};

/// Divisions with cells as long as wanted and not longer; empty when those of the file are.
/// Throws InputError when the file's divisions are finer than wanted and cannot be joined, or graded in a way other
/// than by a constant ratio.
/// @param wanted  [m] length of cells
/// @param file    for messages
std::vector<Division> divisions_for(const std::vector<DividedCurve>&, double wanted, const std::string& file);

/// The curves that two meshes divide into as many cells. [m]
/// @param one, other  lengths of cells by curve [units of the file]
std::vector<DividedCurve> curves_divided_alike(const std::map<int, std::vector<double>>& one,
                                               const std::map<int, std::vector<double>>& other, double unit);

/// Lengths of the edges of a curve from its beginning.
/// @param along  place of each node on the curve, in any order;  @param x  its coordinates, three each
std::vector<double> edge_lengths(const std::vector<double>& along, const std::vector<double>& x);

}  // namespace voussoir
