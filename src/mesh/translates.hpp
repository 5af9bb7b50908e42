// What is a translate of something known: places in any order, with lists that tie them together.
//
// Stones that are drawn alike differ by where they stand and by round-off, and what was found of them comes in an order
// that hangs on their neighbours: corners that joints have made, faces by area, cells. So places are put in an order of
// their own, by coordinates, and compared in it.
#pragma once

#include <map>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// [m] The largest coordinate of some places, without its sign.
double largest_coordinate(const std::vector<Vector<3>>&);

/// What the coordinates of a drawing are known to, by the power of two that none of them reaches.
class DrawnNumbers {
 public:
  /// @param largest  [m] coordinate of the drawing
  explicit DrawnNumbers(double largest);

  /// [m] How far places may differ and be drawn alike: round-off. A coordinate is known to 2^-53 of the largest; where
  /// joints cut a face comes of some dozens of operations. So 2^9 times as much, below the thirteenth digit.
  double within() const { return largest_ / (1LL << 44); }
  /// Rounded to 2^-50 of the largest coordinate, which no drawing knows. Sums and differences of two such places are
  /// exact: they are whole numbers of steps, fewer than 2^53.
  Vector<3> rounded(Vector<3>) const;

 private:
  double largest_;  ///< [m] a power of two above all coordinates
};

class Translates {
 public:
  /// @param within  [m] how far the coordinates of things that are alike may differ
  explicit Translates(double within) : within_(within) {}

  struct Match {
    int shape = 0;           ///< number of the shape, from 0 in the order of their first ones
    bool is_first = true;    ///< of its shape
    std::vector<int> order;  ///< per place of the first one of the shape the place here that is where it is
  };
  /// @param places  [m]
  /// @param width   how many places each part ties together
  /// @param parts   their numbers, part by part, in any order: ends of edges, corners of triangles or cells
  Match add(const std::vector<Vector<3>>& places, int width, const std::vector<int>& parts);
  int shapes() const { return static_cast<int>(first_.size()); }

 private:
  struct Shape {
    std::vector<int> order;           ///< of places by coordinates
    std::vector<Vector<3>> relative;  ///< [m] in that order, around the first
    std::vector<int> parts;           ///< by places in that order: each ascending, and all of them
    double spread = 0;                ///< [m] sum of all distances from the first
  };
  Shape shape_of(const std::vector<Vector<3>>& places, int width, const std::vector<int>& parts) const;
  bool alike(const Shape&, const Shape&) const;

  double within_;
  std::vector<Shape> first_;
  std::multimap<double, int> by_spread_;
};

}  // namespace voussoir
