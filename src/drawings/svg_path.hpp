// The outlines of an SVG: the d of a path, in the axes of its element.
#pragma once

#include <string>
#include <vector>

#include "drawings/outlined_stone.hpp"

namespace voussoir {

struct SvgLoop {
  DrawnLoop loop;  ///< where it is closed its last corner may be the first one again
  bool closed = false;
};

/// What a path cannot be read for, in words.
struct SvgFault {
  std::string why;
};

/// Numbers in a text, separated by blanks or commas, or by nothing where a sign or a point begins the next. Throws
/// SvgFault for anything else.
std::vector<double> svg_numbers(const std::string&);

/// The loops of a path: M, L, H, V, C, S, Q, T, A and Z, absolute and relative. Throws SvgFault.
std::vector<SvgLoop> loops_of_path(const std::string& d);

/// An ellipse as a closed loop.
SvgLoop loop_of_ellipse(const Vector<2>& centre, double rx, double ry);

}  // namespace voussoir
