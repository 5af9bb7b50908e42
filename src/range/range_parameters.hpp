// From where on a motion is told, and from where on it is out of what the model can tell; in plane and space.
#pragma once

namespace voussoir {

struct RangeParameters {
  /// Points that carry less than this share of the largest force press as little as what solvers leave.
  static constexpr double negligible = 1e-6;
  /// A joint whose force passes to more than a tenth where one of its faces has ended is wrong by that tenth.
  static constexpr double borne_by_nothing = 0.1;
  /// A point stands for half a cell on either side: so far beyond the end of a face its force may be one of the face.
  static constexpr double share_of_a_cell = 0.5;
  /// A force within 60 degrees of a block's own loads adds to them: the cosine.
  static constexpr double weighs = 0.5;
  /// What the check of a drawing takes for touching (mesh/border_check.cpp): so much of the shortest side of a cell.
  static constexpr double counts_as_touching = 0.01;
};

}  // namespace voussoir
