// Domes of courses that go round a vertical axis.
//
// Lattice: direction 0 from intrados to extrados, 1 round the axis, closed, 2 along the meridians from the springing to
// the oculus; the ground has one storey below the springing.
#include <algorithm>

#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"
#include "mesh/lattice_in_space.hpp"
#include "mesh/round_masonry.hpp"

namespace voussoir {
namespace {

bool half_turned(const DomeParameters& p, int course) { return p.bond == WallBond::running && course % 2 == 1; }

void validate(const DomeParameters& p) {
  require_positive("dome > radius", p.radius, "m");
  require_positive("dome > thickness", p.thickness, "m");
  require_positive("dome > oculus", p.oculus, "degree");
  require_at_least("dome > courses", p.courses, 1);
  require_at_least("dome > lunes", p.lunes, 3);
  require_at_least("dome > cells radial", p.cells_radial, 1);
  require_at_least("dome > cells round", p.cells_round, 1);
  require_at_least("dome > cells up", p.cells_up, 1);
  if (p.ground_height != 0) require_positive("dome > ground height", p.ground_height, "m");
  if (p.thickness >= 2 * p.radius)
    refuse_mesh("dome > thickness", in_words(p.thickness) + " [m]",
                "must be < 2 x radius = " + in_words(2 * p.radius) + " m (the intrados would have no radius left).",
                "The radius is that of the middle surface; domes have a thickness of 0.03 to 0.2 radii.");
  if (!(p.oculus < p.springing && p.springing < 180))
    refuse_mesh("dome > springing", in_words(p.springing) + " [degree]",
                "must lie between the oculus at " + in_words(p.oculus) + " and 180 degrees from the crown.",
                "A half sphere has 90.");
  if (p.bond == WallBond::running && p.cells_round % 2 != 0)
    refuse_mesh("dome > cells round", std::to_string(p.cells_round) + " [-]",
                "must be even in running bond (odd courses are turned by half a stone, and nodes of two courses meet).",
                "Give " + std::to_string(p.cells_round + 1) + ", or bond = stack.");
  const bool plane = p.faces == StoneFaces::plane;
  const int halves = p.bond == WallBond::running ? 2 : 1;
  const double turn = 360.0 / (double(p.lunes) * (plane ? halves : p.cells_round));
  const double rise = (p.springing - p.oculus) / (double(p.courses) * (plane ? 1 : p.cells_up));
  if (turn > 120 || rise > 60)
    refuse_mesh(turn > 120 ? "dome > lunes" : "dome > courses",
                std::to_string(turn > 120 ? p.lunes : p.courses) + " [-]",
                "makes edges that follow the round surface over " + in_words(turn > 120 ? turn : rise) +
                    " degrees; straight ones follow it up to " + (turn > 120 ? "120 round the axis." : "60."),
                "Give more stones, or more cells in each.");
  const double corners = (p.cells_radial + 1.0) * (p.cells_round + 1.0) * (p.cells_up + 1.0);
  require_countable("dome > courses", p.courses, (p.courses + 1.0) * p.lunes,
                    std::max({corners, p.lunes * double(p.cells_round), p.courses * double(p.cells_up)}));
}

class DomePlaces {
 public:
  explicit DomePlaces(const DomeParameters& p)
      : p_(p),
        stride_round_(p.faces == StoneFaces::round ? 1
                      : p.bond == WallBond::stack  ? p.cells_round
                                                   : p.cells_round / 2),
        stride_up_(p.faces == StoneFaces::round ? 1 : p.cells_up) {}

  Vector<3> operator()(const LatticeIndex& at) const {
    const double r = p_.radius - p_.thickness / 2 + p_.thickness * at[0] / p_.cells_radial;
    return stretched(stretch_of(at[1], stride_round_), [&](int ray) {
      if (at[2] < 0) return below(r, ray);
      return stretched(stretch_of(at[2], stride_up_), [&](int ring) { return place(r, ray, ring); });
    });
  }

 private:
  Vector<2> azimuth(int ray) const { return direction_at(360.0 * ray / (double(p_.lunes) * p_.cells_round)); }
  Vector<3> place(double r, int ray, int ring) const {
    const int rings = p_.courses * p_.cells_up;
    // The last ring lies at the oculus to the last bit, whatever the sum would round to.
    const double degrees = ring == rings ? p_.oculus : p_.springing - (p_.springing - p_.oculus) * ring / double(rings);
    const Vector<2> from_crown = direction_at(degrees), a = azimuth(ray);
    return {r * from_crown[1] * a[0], r * from_crown[1] * a[1], r * from_crown[0]};
  }
  /// Down along the meridian.
  Vector<3> below(double r, int ray) const {
    const Vector<2> from_crown = direction_at(p_.springing), a = azimuth(ray);
    const double h = p_.ground_height;
    return place(r, ray, 0) + Vector<3>{h * from_crown[0] * a[0], h * from_crown[0] * a[1], -h * from_crown[1]};
  }

  DomeParameters p_;
  int stride_round_, stride_up_;  ///< lattice lines between those on the round surface
};

void add_ring(Masonry& m, const DomeParameters& p, int first_ray, int below, int above) {
  for (int lune = 0; lune < p.lunes; ++lune) {
    const int from = first_ray + lune * p.cells_round;
    m.stones.push_back(
        {{0, from, below}, {p.cells_radial, from + p.cells_round, above}, static_cast<int>(m.groups.size()) - 1, lune});
  }
}

}  // namespace

std::unique_ptr<BlockSource<3>> make_dome(const DomeParameters& p) {
  validate(p);
  Masonry m;
  m.low = {0, 0, -1};
  m.high = {p.cells_radial, p.lunes * p.cells_round, p.courses * p.cells_up};
  m.closed = true;
  m.facet_sets = {"base", "oculus", "intrados", "extrados"};
  m.sides = {{0, 2, false, 0, true}, {1, 2, true, m.high[2]}, {2, 0, false}, {3, 0, true}};
  if (p.ground_height > 0) {
    add_ground_sides(m, "ground", ground_part);
    m.groups.push_back({"ground", {p.courses}, ground_part});
    add_ring(m, p, 0, -1, 0);
  }
  for (int course = 0; course < p.courses; ++course) {
    const std::string name = "course " + std::to_string(course);
    m.block_sets.push_back(name);
    m.groups.push_back({name, {course}, 0});
    add_ring(m, p, half_turned(p, course) ? p.cells_round / 2 : 0, course * p.cells_up, (course + 1) * p.cells_up);
  }
  if (p.ground_height > 0) m.block_sets.push_back("ground");
  m.place = DomePlaces(p);
  return make_lattice_in_space(std::move(m));
}

}  // namespace voussoir
