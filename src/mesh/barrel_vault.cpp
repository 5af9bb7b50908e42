// Barrel vaults: courses of stones along the axis, from springing to springing.
//
// Lattice: direction 0 from intrados to extrados, 1 along the axis, 2 round it from the right springing to the left
// one; each ground has one storey beyond its springing.
#include <algorithm>

#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"
#include "mesh/lattice_in_space.hpp"
#include "mesh/round_masonry.hpp"

namespace voussoir {
namespace {

constexpr int right_ground = 1, left_ground = 2;  // parts

void validate(const BarrelVaultParameters& p) {
  const std::string vault = "barrel vault > ";
  require_positive(vault + "radius", p.radius, "m");
  require_positive(vault + "thickness", p.thickness, "m");
  require_positive(vault + "embrace", p.embrace, "degree");
  require_positive(vault + "length", p.length, "m");
  require_at_least(vault + "voussoirs", p.voussoirs, 1);
  require_at_least(vault + "stones along", p.stones_along, 1);
  require_at_least(vault + "cells radial", p.cells_radial, 1);
  require_at_least(vault + "cells round", p.cells_round, 1);
  require_at_least(vault + "cells along", p.cells_along, 1);
  if (p.ground_height != 0) require_positive(vault + "ground height", p.ground_height, "m");
  if (p.thickness >= 2 * p.radius)
    refuse_mesh(vault + "thickness", in_words(p.thickness) + " [m]",
                "must be < 2 x radius = " + in_words(2 * p.radius) + " m (the intrados would have no radius left).",
                "The radius is that of the middle surface; vaults have a thickness of 0.05 to 0.3 radii.");
  if (p.embrace >= 360)
    refuse_mesh(vault + "embrace", in_words(p.embrace) + " [degree]",
                "must be < 360 (both springings would lie on each other).",
                "The embrace is the angle between the springings; a semicircle has 180.");
  if (p.bond == WallBond::running && p.cells_along % 2 != 0)
    refuse_mesh(vault + "cells along", std::to_string(p.cells_along) + " [-]",
                "must be even in running bond (a half stone has half of the cells, so that nodes of two courses meet).",
                "Give " + std::to_string(p.cells_along + 1) + ", or bond = stack.");
  const double turn = p.embrace / p.voussoirs / (p.faces == StoneFaces::plane ? 1 : p.cells_round);
  if (turn > 60)
    refuse_mesh(vault + "voussoirs", std::to_string(p.voussoirs) + " [-]",
                "makes edges over " + in_words(turn) + " degrees; straight ones follow the circle up to 60.",
                "Give more voussoirs or more \"cells round\".");
  const double corners = (p.cells_radial + 1.0) * (p.cells_along + 1.0) * (p.cells_round + 1.0);
  require_countable(vault + "voussoirs", p.voussoirs, (p.voussoirs + 2.0) * (p.stones_along + 1.0),
                    std::max({corners, p.stones_along * double(p.cells_along), (p.voussoirs + 2.0) * p.cells_round}));
}

/// Angles are measured from the crown, where left and right differ by their sign alone: the mesh is its own mirror
/// image.
class VaultPlaces {
 public:
  explicit VaultPlaces(const BarrelVaultParameters& p)
      : p_(p), rays_(p.voussoirs * p.cells_round), stride_(p.faces == StoneFaces::round ? 1 : p.cells_round) {}

  Vector<3> operator()(const LatticeIndex& at) const {
    const double r = p_.radius - p_.thickness / 2 + p_.thickness * at[0] / p_.cells_radial;
    const double y = p_.length * at[1] / (double(p_.stones_along) * p_.cells_along);
    if (at[2] < 0 || at[2] > rays_) return beyond(r, y, at[2]);
    return stretched(stretch_of(at[2], stride_), [&](int ray) { return place(r, y, ray); });
  }

 private:
  Vector<2> direction(int ray) const { return direction_at(p_.embrace * (2.0 * ray - rays_) / (2.0 * rays_)); }
  Vector<3> place(double r, double y, int ray) const {
    const Vector<2> from_crown = direction(ray);
    return {-r * from_crown[1], y, r * from_crown[0]};
  }
  /// Straight on from a springing.
  Vector<3> beyond(double r, double y, int ray) const {
    const int springing = ray < 0 ? 0 : rays_;
    const Vector<2> from_crown = direction(springing);
    const double h = ray < 0 ? p_.ground_height : -p_.ground_height;
    return place(r, y, springing) + Vector<3>{h * from_crown[0], 0, h * from_crown[1]};
  }

  BarrelVaultParameters p_;
  int rays_, stride_;  ///< number of the last ray; rays between those on the circle
};

/// Stones along the axis, half ones at the ends of odd courses in running bond.
void add_course(Masonry& m, const BarrelVaultParameters& p, int course, int below, int above) {
  const bool odd = p.bond == WallBond::running && course % 2 == 1;
  const int rows = p.stones_along * p.cells_along, first = odd ? p.cells_along / 2 - p.cells_along : 0;
  int number = 0;
  for (int row = first; row < rows; row += p.cells_along)
    m.stones.push_back({{0, std::max(row, 0), below},
                        {p.cells_radial, std::min(row + p.cells_along, rows), above},
                        static_cast<int>(m.groups.size()) - 1,
                        number++});
}

void add_ground(Masonry& m, const BarrelVaultParameters& p, bool left) {
  const std::string name = left ? "ground left" : "ground right";
  const int rays = p.voussoirs * p.cells_round;
  m.groups.push_back({name, {p.voussoirs + (left ? 0 : 1)}, left ? left_ground : right_ground});
  add_course(m, p, left ? p.voussoirs - 1 : 0, left ? rays : -1, left ? rays + 1 : 0);
}

}  // namespace

std::unique_ptr<BlockSource<3>> make_barrel_vault(const BarrelVaultParameters& p) {
  validate(p);
  const int rays = p.voussoirs * p.cells_round;
  const bool has_ground = p.ground_height > 0;
  Masonry m;
  m.low = {0, 0, -1};
  m.high = {p.cells_radial, p.stones_along * p.cells_along, rays + 1};
  m.facet_sets = {"springing left", "springing right", "intrados", "extrados", "front", "back"};
  m.sides = {{0, 2, true, rays, true}, {1, 2, false, 0, true}, {2, 0, false}, {3, 0, true},
             {4, 1, false, 0},         {5, 1, true, m.high[1]}};
  if (has_ground) {
    add_ground_sides(m, "ground left", left_ground);
    add_ground_sides(m, "ground right", right_ground);
    add_ground(m, p, false);
  }
  for (int course = 0; course < p.voussoirs; ++course) {
    const std::string name = "course " + std::to_string(course);
    m.block_sets.push_back(name);
    m.groups.push_back({name, {course}, 0});
    add_course(m, p, course, course * p.cells_round, (course + 1) * p.cells_round);
  }
  if (has_ground) {
    add_ground(m, p, true);
    for (const char* name : {"ground left", "ground right"}) m.block_sets.push_back(name);
  }
  m.place = VaultPlaces(p);
  return make_lattice_in_space(std::move(m));
}

}  // namespace voussoir
