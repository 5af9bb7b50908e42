// Curved parts of outlines in chords that turn by five degrees at most (chord_turn).
#pragma once

#include "drawings/outlined_stone.hpp"

namespace voussoir {

/// Appends the points of an arc behind its first one, its last included; those between are marked as curved.
/// @param from, to  [rad] counter-clockwise where `to` is larger
void add_arc(DrawnLoop&, const Vector<2>& centre, double radius, double from, double to, const Vector<2>& last);

/// The same of the arc of a polyline in CAD. @param bulge  the tangent of a quarter of its angle, positive to the left
void add_bulge(DrawnLoop&, const Vector<2>& first, const Vector<2>& last, double bulge);

/// The same of a Bezier curve. @param control  its two or three control points and its last one, behind the first
void add_bezier(DrawnLoop&, const Vector<2>& first, const std::vector<Vector<2>>& control);

/// How many chords an angle takes [rad].
int chords_of(double angle);

}  // namespace voussoir
