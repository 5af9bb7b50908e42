// Numbers of the system of block motions.
#pragma once

namespace voussoir {

struct BlockMotionParameters {
  /// motions up to which the first of several ranks factors them for all: with 50 000 in the plane two ranks take as
  /// long to factor them as one, and below that what MUMPS sends takes longer than what it saves
  static constexpr long long most_on_first = 50000;
};

}  // namespace voussoir
