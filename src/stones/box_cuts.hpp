// Where lattice planes cut stones that are boxes: at the corners of their joints, and where planes of neighbours meet a
// joint.
#pragma once

#include <optional>
#include <vector>

#include "stones/box_shape.hpp"

namespace voussoir {

/// Values from 0 to 1 of one coordinate of a box, ascending; those closer than `same` are one.
struct Cuts {
  std::vector<double> at{0, 1};
  double same = 0;

  /// The number of a value, or how many there are.
  std::size_t find(double value) const;
  /// Whether it was not there.
  bool add(double value);
};

struct CutBox {
  BoxShape shape;
  std::array<Cuts, 3> cuts;
};

/// How a direction of one box runs along one of another: a joint has an edge from the values `from` to `to`.
struct Along {
  std::array<int, 2> stone{}, direction{};
  std::array<double, 2> from{}, to{};
  std::array<double, 2> low{}, high{};  ///< of the whole joint

  /// The value on the other side.
  double across(int side, double value) const {
    return from[1 - side] + (value - from[side]) / (to[side] - from[side]) * (to[1 - side] - from[1 - side]);
  }
};

class BoxCuts {
 public:
  explicit BoxCuts(const StoneStructure&);

  /// Nothing for a stone that gets no hexahedra.
  const std::optional<CutBox>& operator[](std::size_t stone) const { return box_[stone]; }
  /// Per stone and direction the number of cells between neighbouring cuts: across joints the same.
  std::vector<std::array<std::vector<int>, 3>> cells() const;

 private:
  bool cut_by(const ImprintedCell&);
  void add_joint(int cell);
  void spread();
  void leave_out();

  const StoneStructure& s_;
  std::vector<std::optional<CutBox>> box_;  ///< per stone
  std::vector<Along> along_;
};

}  // namespace voussoir
