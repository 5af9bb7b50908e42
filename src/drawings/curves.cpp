#include "drawings/curves.hpp"

#include <algorithm>
#include <cmath>

namespace voussoir {
namespace {

void add(DrawnLoop& loop, const Vector<2>& x, bool curved) {
  loop.corners.push_back(x);
  loop.curved.push_back(curved ? 1 : 0);
}

}  // namespace

int chords_of(double angle) {
  constexpr double most = 720;  // ten turns: numbers of a damaged file
  return static_cast<int>(std::clamp(std::ceil(std::abs(angle) / chord_turn - 1e-9), 1.0, most));
}

void add_arc(DrawnLoop& loop, const Vector<2>& centre, double radius, double from, double to, const Vector<2>& last) {
  const int chords = chords_of(to - from);
  for (int k = 1; k < chords; ++k) {
    const double at = from + (to - from) * k / chords;
    add(loop, centre + radius * Vector<2>{std::cos(at), std::sin(at)}, true);
  }
  add(loop, last, false);
}

void add_bulge(DrawnLoop& loop, const Vector<2>& first, const Vector<2>& last, double bulge) {
  const Vector<2> chord = last - first;
  const double angle = 4 * std::atan(bulge);
  if (norm(chord) == 0 || std::abs(angle) < 1e-9) return add(loop, last, false);
  const double to_centre = (1 / bulge - bulge) / 4;  // of the chord, to its left: half of it by tan(angle / 2)
  const Vector<2> centre = 0.5 * (first + last) + to_centre * Vector<2>{-chord[1], chord[0]};
  const Vector<2> arm = first - centre;
  const double from = std::atan2(arm[1], arm[0]);
  add_arc(loop, centre, norm(arm), from, from + angle, last);
}

void add_bezier(DrawnLoop& loop, const Vector<2>& first, const std::vector<Vector<2>>& control) {
  std::vector<Vector<2>> points{first};
  points.insert(points.end(), control.begin(), control.end());
  double turn = 0;
  std::vector<Vector<2>> ways;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    if (norm(points[k + 1] - points[k]) > 0) ways.push_back(points[k + 1] - points[k]);
  for (std::size_t k = 0; k + 1 < ways.size(); ++k)
    turn += std::abs(std::atan2(cross(ways[k], ways[k + 1]), dot(ways[k], ways[k + 1])));
  const int chords = chords_of(2 * turn);  // a curve turns unevenly along its parameter
  for (int k = 1; k < chords; ++k) {
    const double t = static_cast<double>(k) / chords;
    auto between = points;  // de Casteljau
    for (std::size_t left = between.size() - 1; left > 0; --left)
      for (std::size_t i = 0; i < left; ++i) between[i] = (1 - t) * between[i] + t * between[i + 1];
    add(loop, between[0], true);
  }
  add(loop, points.back(), false);
}

}  // namespace voussoir
