#include "joints/coarse_joint.hpp"

#include <algorithm>
#include <cmath>

namespace voussoir {
namespace {

// Below half of its strength a joint is not near to breaking, however coarse it is.
constexpr double near_strength = 0.5;
// Along an axis that has less than a tenth of the bending, or of the shear, of the other nothing has broken.
constexpr double has_part = 0.1;
// What has opened alike everywhere but for this share, as solvers leave it, was pulled apart and not bent.
constexpr double uneven = 1e-6;

/// What points at the edge show of a stress that is linear over a depth of so many cells.
double shown_at_edges(int cells) { return 1 - 2.0 / (3 * cells); }

/// Of a joint that bends without being pressed or pulled.
double overrating_in_bending(int cells) { return 1 / shown_at_edges(cells) - 1; }

/// Of a joint whose shear is that of a beam, a parabola 1 - x^2 from edge to edge: the point next to the middle has the
/// mean of it, weighted by its shape function; with one cell both have that of the whole joint.
double overrating_in_shear(int cells) {
  if (cells == 1) return 0.5;
  const double x = cells % 2 == 0 ? 0.0 : 1.0 / cells, cell = 2.0 / cells;
  return 1 / (1 - x * x - cell * cell / 6) - 1;
}

/// What all points bear together.
struct Sums {
  double force = 0, pull = 0;  ///< [N]; [Pa] the largest of a point
  Vector<2> moment{};          ///< [N m] of the normal forces about the middle, along the axes
  Vector<2> shear{};           ///< [N]
  double opened = 0;           ///< [m3] integral of the widest openings
  Vector<2> opening{};         ///< [m4] their moment: which way a crack has run
  bool broken = false;

  Sums(const JointSection& section, const std::vector<BrittlePoint>& points) {
    for (const auto& p : points) {
      const auto arm = p.place - section.middle;
      force += p.normal_force;
      shear = shear + p.shear;
      moment = moment + p.normal_force * arm;
      opened += p.area * p.opened;
      opening = opening + (p.area * p.opened) * arm;
      pull = std::max(pull, -p.normal_force / p.area);
      broken |= p.broken;
    }
  }
};

/// The fewest cells along an axis that has a part in a direction; 0 where it has none.
int cells_along(const JointSection& section, const Vector<2>& direction, double nothing) {
  const double most = std::max(std::abs(direction[0]), std::abs(direction[1]));
  int fewest = 0;
  for (int a = 0; a < section.axes(); ++a) {
    if (!(most > nothing) || std::abs(direction[a]) < has_part * most) continue;
    if (fewest == 0 || section.cells[a] < fewest) fewest = section.cells[a];
  }
  return fewest;
}

/// Of a joint some of whose points have broken. With two axes the widest openings tell which way it was bent, if at
/// all; where nothing has opened, as with cohesion alone, the shear tells along which it was sheared.
double overrating_of_broken(const JointSection& section, const Sums& sums, bool pulls) {
  if (section.axes() == 1)
    return pulls ? overrating_in_bending(section.cells[0]) : overrating_in_shear(section.cells[0]);
  const bool bent = pulls && sums.opened > 0;
  const double evenly = uneven * sums.opened * std::max(section.length[0], section.length[1]);
  const int cells = bent ? cells_along(section, sums.opening, evenly) : cells_along(section, sums.shear, 0);
  if (cells == 0) return 0;
  return bent ? overrating_in_bending(cells) : overrating_in_shear(cells);
}

/// Stress that is linear over the section as the forces of its points have it, its slope [Pa/m].
Vector<2> slope(const JointSection& section, const Vector<2>& moment) {
  const auto& i = section.second_moment;
  if (section.axes() == 1) return {moment[0] / i[0][0], 0};
  const double det = i[0][0] * i[1][1] - i[0][1] * i[1][0];
  return {(i[1][1] * moment[0] - i[0][1] * moment[1]) / det, (i[0][0] * moment[1] - i[1][0] * moment[0]) / det};
}

/// The largest tension of that stress [Pa], along fine axes as points show it.
double pull_at_edge(const JointSection& section, const std::vector<BrittlePoint>& points, const Sums& sums) {
  const auto steep = slope(section, sums.moment);
  double pull = 0;
  for (const auto& p : points) {
    double pressure = sums.force / section.area;
    for (int a = 0; a < section.axes(); ++a) {
      const bool fine = section.axes() > 1 && section.cells[a] >= cells_of_a_fine_joint;
      pressure += (fine ? shown_at_edges(section.cells[a]) : 1.0) * steep[a] * (p.place[a] - section.middle[a]);
    }
    pull = std::max(pull, -pressure);
  }
  return pull;
}

/// Where no tension is borne the pressed part of a joint is three times as long as the resultant is off its edge. Where
/// that is off two edges the parts along both are multiplied: 0.25 for the 0.22 of a resultant a sixth off either.
double pressed_part(const JointSection& section, const Sums& sums) {
  double part = 1;
  for (int a = 0; a < section.axes(); ++a)
    part *= std::clamp(3 * (0.5 - std::abs(sums.moment[a]) / (sums.force * section.length[a])), 0.0, 1.0);
  return part;
}

}  // namespace

bool JointSection::is_fine() const {
  for (int a = 0; a < axes(); ++a)
    if (cells[a] < cells_of_a_fine_joint) return false;
  return true;
}

CoarseJoint coarse_joint(const JointSection& section, const std::vector<BrittlePoint>& points, double tension,
                         double cohesion, double friction) {
  CoarseJoint found;
  if (section.cells[0] < 1) return found;
  for (int a = 0; a < section.axes(); ++a)
    if (!(section.length[a] > 0)) return found;
  const Sums sums(section, points);
  if (sums.broken) {
    found.overrating = overrating_of_broken(section, sums, tension > 0);
    return found;
  }
  if (tension > 0) {
    found.edge_use = pull_at_edge(section, points, sums) / tension;
    found.point_use = sums.pull / tension;
    if (found.edge_use > near_strength)
      found.overrating = found.edge_use / std::max(found.point_use, near_strength) - 1;
  } else if (sums.force > 0) {
    const double shear = norm(sums.shear), pressed = pressed_part(section, sums);
    const double borne = cohesion * section.area + friction * sums.force;
    const double left = cohesion * section.area * pressed + friction * sums.force;
    found.point_use = shear / borne;
    found.edge_use = shear / left;
    if (pressed < 1 && found.point_use > near_strength) found.overrating = borne / left - 1;
  }
  found.overrating = std::max(0.0, found.overrating);
  return found;
}

}  // namespace voussoir
