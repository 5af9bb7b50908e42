// Circular arches of equal voussoirs, on piers if asked for.
//
// Lattice of the ring: line i = 0 .. cells_radial from intrados to extrados, ray j = 0 .. voussoirs * cells_along from
// the right springing to the left one. Rows of a pier lie below ray 0 or the last ray and continue its lines downward.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

const double pi = std::acos(-1.0);

enum ArchFacets { springing_left, springing_right, extrados, intrados };
enum ArchBlocks { ring, pier_left, pier_right };

class Arch final : public BlockSource<2> {
 public:
  explicit Arch(const ArchParameters&);

  BlockId block_count() const override { return p_.voussoirs + (has_piers() ? 2 * p_.pier_courses : 0); }
  int node_count(BlockId b) const override { return (p_.cells_radial + 1) * (cells_up(b) + 1); }
  Block<2> block(BlockId) const override;
  std::vector<Neighbour> neighbours(BlockId) const override;
  const SetNames& block_sets() const override { return block_sets_; }
  const std::vector<std::string>& facet_sets() const override { return facet_sets_; }

 private:
  bool has_piers() const { return p_.pier_height > 0; }
  /// Cells of a block in the direction of the thrust.
  int cells_up(BlockId b) const { return b < p_.voussoirs ? p_.cells_along : pier_cells_up_; }
  double line_radius(int i) const { return p_.radius - p_.thickness / 2 + p_.thickness * i / p_.cells_radial; }
  Vector<2> ring_position(int i, int ray) const;
  VertexId ring_vertex(int i, int ray) const { return static_cast<VertexId>(ray) * (p_.cells_radial + 1) + i; }
  void build_voussoir(Block<2>&) const;
  void build_pier_block(Block<2>&) const;

  ArchParameters p_;
  int rays_;               ///< number of the last ray
  int pier_cells_up_ = 0;  ///< per block of a pier
  SetNames block_sets_{"ring"};
  std::vector<std::string> facet_sets_{"springing left", "springing right", "extrados", "intrados"};
};

void validate(const ArchParameters& p) {
  require_positive("arch > radius", p.radius, "m");
  require_positive("arch > thickness", p.thickness, "m");
  require_positive("arch > embrace", p.embrace, "degree");
  require_at_least("arch > voussoirs", p.voussoirs, 1);
  require_at_least("arch > cells radial", p.cells_radial, 1);
  require_at_least("arch > cells along", p.cells_along, 1);
  if (p.thickness >= 2 * p.radius)
    refuse_mesh("arch > thickness", in_words(p.thickness) + " [m]",
                "must be < 2 x radius = " + in_words(2 * p.radius) + " m (the intrados would have no radius left).",
                "The radius is that of the middle line; bridges have a thickness of 0.05 to 0.3 radii.");
  if (p.embrace >= 360)
    refuse_mesh("arch > embrace", in_words(p.embrace) + " [degree]",
                "must be < 360 (both springings would lie on each other).",
                "The embrace is the angle between the springings; a semicircle has 180.");
  const double cell_angle = p.embrace / p.voussoirs / p.cells_along;
  if (cell_angle > 60)
    refuse_mesh("arch > voussoirs", std::to_string(p.voussoirs) + " [-]",
                "makes cells of " + in_words(cell_angle) + " degrees; straight edges follow the circle up to 60.",
                "Give more voussoirs or more \"cells along\".");
  if ((p.voussoirs + 1.0) * p.cells_along > 1e9 || (p.cells_radial + 1.0) * (p.cells_along + 1.0) > 1e9)
    refuse_mesh("arch > voussoirs", std::to_string(p.voussoirs) + " [-]",
                "makes over 1e9 lattice lines, more than numbers here can count.", "Give fewer voussoirs or cells.");
  if (!(p.pier_height >= 0 && std::isfinite(p.pier_height)))
    refuse_mesh("arch > pier height", in_words(p.pier_height) + " [m]", "must be a finite number >= 0.",
                "Give 0 for an arch without piers.");
  if (p.pier_height > 0 && p.embrace != 180)
    refuse_mesh(
        "arch > pier height", in_words(p.pier_height) + " [m]",
        "needs an embrace of 180 degrees, not " + in_words(p.embrace) + " (vertical piers continue a semicircle).",
        "Give embrace 180 or pier height 0.");
  if (p.pier_height > 0) require_at_least("arch > pier courses", p.pier_courses, 1);
}

Arch::Arch(const ArchParameters& p) : p_(p) {
  validate(p_);
  rays_ = p_.voussoirs * p_.cells_along;
  if (!has_piers()) return;
  block_sets_ = {"ring", "pier left", "pier right"};
  const double square_cells = p_.pier_height / p_.pier_courses / (p_.thickness / p_.cells_radial);
  const double rows = std::max(1.0, std::round(square_cells));
  if (rows * p_.pier_courses * (p_.cells_radial + 1.0) > std::numeric_limits<int>::max())
    refuse_mesh("arch > pier height", in_words(p_.pier_height) + " [m]",
                "makes " + in_words(rows) + " rows of cells per block of a pier.",
                "Give a pier in proportion to the thickness.");
  pier_cells_up_ = static_cast<int>(rows);
}

/// The angle is measured from the crown, where left and right differ by its sign alone: the mesh is its own mirror
/// image.
Vector<2> Arch::ring_position(int i, int ray) const {
  const double degrees = p_.embrace * (2 * ray - rays_) / (2.0 * rays_);
  const double r = line_radius(i);
  if (std::abs(degrees) == 90)
    return {degrees < 0 ? r : -r, 0.0};  // cos(pi / 2) is 6e-17 in doubles; springings are level
  return {-r * std::sin(degrees * pi / 180), r * std::cos(degrees * pi / 180)};
}

void Arch::build_voussoir(Block<2>& block) const {
  const int radial = p_.cells_radial, along = p_.cells_along, first_ray = block.id * along;
  block.name = "block " + std::to_string(block.id) + " (voussoir " + std::to_string(block.id) + ")";
  block.sets = {ring};
  for (int ray = first_ray; ray <= first_ray + along; ++ray)
    for (int i = 0; i <= radial; ++i) {
      block.position.push_back(ring_position(i, ray));
      block.vertex.push_back(ring_vertex(i, ray));
    }
  if (!has_piers() && block.id == 0) add_lattice_facets(block, radial, along, LatticeSide::bottom, springing_right);
  if (!has_piers() && block.id == p_.voussoirs - 1)
    add_lattice_facets(block, radial, along, LatticeSide::top, springing_left);
  add_lattice_facets(block, radial, along, LatticeSide::right, extrados);
  add_lattice_facets(block, radial, along, LatticeSide::left, intrados);
}

void Arch::build_pier_block(Block<2>& block) const {
  const int radial = p_.cells_radial, up = pier_cells_up_, rows = up * p_.pier_courses;
  const bool at_left = block.id >= p_.voussoirs + p_.pier_courses;
  const int course = (block.id - p_.voussoirs) % p_.pier_courses;
  block.name = "block " + std::to_string(block.id) + " (pier " + (at_left ? "left" : "right") + ", course " +
               std::to_string(course) + ")";
  block.sets = {at_left ? pier_left : pier_right};
  const int springing_ray = at_left ? rays_ : 0;
  const VertexId first_vertex =
      ring_vertex(0, rays_ + 1) + (at_left ? static_cast<VertexId>(rows) * (radial + 1) : VertexId(0));
  for (int row = course * up; row <= (course + 1) * up; ++row)
    for (int column = 0; column <= radial; ++column) {
      const int i = at_left ? radial - column : column;  // columns run to the right, lines outward
      const Vector<2> above = ring_position(i, springing_ray);
      if (row == rows) {
        block.position.push_back(above);
        block.vertex.push_back(ring_vertex(i, springing_ray));
      } else {
        block.position.push_back({above[0], p_.pier_height * row / rows - p_.pier_height});
        block.vertex.push_back(first_vertex + static_cast<VertexId>(row) * (radial + 1) + i);
      }
    }
  if (course == 0)
    add_lattice_facets(block, radial, up, LatticeSide::bottom, at_left ? springing_left : springing_right);
}

Block<2> Arch::block(BlockId b) const {
  VOUSSOIR_EXPECT(b >= 0 && b < block_count());
  Block<2> block;
  block.id = b;
  block.position.reserve(static_cast<std::size_t>(node_count(b)));
  block.vertex.reserve(block.position.capacity());
  if (b < p_.voussoirs)
    build_voussoir(block);
  else
    build_pier_block(block);
  block.cells = lattice_cells(p_.cells_radial, cells_up(b), p_.cells);
  return block;
}

std::vector<Neighbour> Arch::neighbours(BlockId b) const {
  const int last = p_.voussoirs - 1, right_head = p_.voussoirs + p_.pier_courses - 1;
  const int left_head = right_head + p_.pier_courses;
  std::vector<BlockId> beside;
  if (b < p_.voussoirs) {
    if (b > 0) beside.push_back(b - 1);
    if (b < last) beside.push_back(b + 1);
    if (has_piers() && b == 0) beside.push_back(right_head);
    if (has_piers() && b == last) beside.push_back(left_head);
  } else {
    const bool foot = (b - p_.voussoirs) % p_.pier_courses == 0;
    if (!foot) beside.push_back(b - 1);
    beside.push_back(b == right_head ? 0 : b == left_head ? last : b + 1);
  }
  std::sort(beside.begin(), beside.end());
  std::vector<Neighbour> all;
  for (const BlockId other : beside) all.push_back({other, p_.cells_radial + 1});  // joints run across the thickness
  return all;
}

}  // namespace

std::unique_ptr<BlockSource<2>> make_arch(const ArchParameters& parameters) {
  return std::make_unique<Arch>(parameters);
}

}  // namespace voussoir
