#include "joints/coarse_joint.hpp"

#include <algorithm>
#include <cmath>

namespace voussoir {
namespace {

// Below half of its strength a joint is not near to breaking, however coarse it is.
constexpr double near_strength = 0.5;

/// Of a joint that bends without being pressed or pulled.
double overrating_in_bending(int cells) { return 1 / (1 - 2.0 / (3 * cells)) - 1; }

/// Of a joint whose shear is that of a beam, a parabola 1 - x^2 from edge to edge: the point next to the middle has the
/// mean of it, weighted by its shape function; with one cell both have that of the whole joint.
double overrating_in_shear(int cells) {
  if (cells == 1) return 0.5;
  const double x = cells % 2 == 0 ? 0.0 : 1.0 / cells, cell = 2.0 / cells;
  return 1 / (1 - x * x - cell * cell / 6) - 1;
}

}  // namespace

CoarseJoint coarse_joint(const std::vector<BrittlePoint>& points, double tension, double cohesion, double friction) {
  CoarseJoint found;
  found.cells = static_cast<int>(points.size()) - 1;
  if (found.cells < 1) return found;
  double area = 0, middle = 0, force = 0, shear = 0, first = points[0].along, last = first, pull = 0;
  bool broken = false;
  for (const auto& p : points) {
    area += p.area;
    middle += p.area * p.along;
    force += p.normal_force;
    shear += p.shear;
    first = std::min(first, p.along);
    last = std::max(last, p.along);
    pull = std::max(pull, -p.normal_force / p.area);
    broken |= p.broken;
  }
  middle /= area;
  const double length = last - first;
  if (!(length > 0)) return found;
  if (broken) {
    found.overrating = tension > 0 ? overrating_in_bending(found.cells) : overrating_in_shear(found.cells);
    return found;
  }
  double moment = 0;
  for (const auto& p : points) moment += p.normal_force * (p.along - middle);
  moment = std::abs(moment);
  if (tension > 0) {
    const double edge = 6 * moment / (area * length) - force / area;
    found.edge_use = std::max(0.0, edge / tension);
    found.point_use = pull / tension;
    if (found.edge_use > near_strength)
      found.overrating = found.edge_use / std::max(found.point_use, near_strength) - 1;
  } else if (force > 0) {
    // Where no tension is borne the pressed part of the joint is three times as long as the resultant is off its edge.
    const double pressed = 3 * (0.5 - moment / (force * length)), borne = cohesion * area + friction * force;
    found.point_use = std::abs(shear) / borne;
    const double left = cohesion * area * std::max(pressed, 0.0) + friction * force;
    found.edge_use = std::abs(shear) / left;
    if (pressed < 1 && found.point_use > near_strength) found.overrating = borne / left - 1;
  }
  found.overrating = std::max(0.0, found.overrating);
  return found;
}

}  // namespace voussoir
