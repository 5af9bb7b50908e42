// A structure to put loads on, and what they add up to.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "loads/load.hpp"
#include "model/loads_at_work.hpp"
#include "scene/scene.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace voussoir::test {

constexpr double thickness = 0.4, density = 2000;

/// Sum of nodal forces over all owned nodes, and their moment about the origin.
struct Resultant {
  double x = 0, y = 0, moment = 0;
};

inline Resultant resultant(const Structure<2>& s, const std::vector<double>& force) {
  Resultant r;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    const Vector<2> f{force[2 * i], force[2 * i + 1]};
    r.x += f[0];
    r.y += f[1];
    r.moment += cross(s.position()[i], f);
  }
  return {sum_over_ranks(*everyone(), r.x), sum_over_ranks(*everyone(), r.y), sum_over_ranks(*everyone(), r.moment)};
}

/// Blocks, with loads called "tested". A wall of 2 m x 1 m, four courses of four stones, unless told otherwise.
class LoadCase {
 public:
  LoadCase() : LoadCase(wall()) {}
  explicit LoadCase(Plane plane) : LoadCase(wall(), plane) {}
  explicit LoadCase(std::unique_ptr<BlockSource<2>> source, Plane plane = Plane::stress)
      : source_(std::move(source)),
        structure_(structure_of(*source_, everyone(), {plane, thickness}, {1e9, 0.2, density})) {}

  const Structure<2>& s() const { return structure_; }

  template <class Parameters>
  std::unique_ptr<Load<2>> made(const Parameters& p) const {
    LoadParameters load;
    load.kind = p;
    return make_load(load, LoadSite<2>{structure_, *source_, {}, "scene > loads > tested"});
  }

  template <class Parameters>
  LoadsAtWork at_work(const Parameters& p) const {
    Scene scene;
    LoadParameters load;
    load.name = "tested";
    load.kind = p;
    scene.loads = {load};
    return LoadsAtWork(scene, *source_, structure_);
  }

  template <class Parameters>
  Resultant resultant(const Parameters& p, double factor = 1.0, double time = 0.0) const {
    BlockForces force(structure_);
    std::vector<double> prescribed(force.of_nodes.size(), 0.0);
    made(p)->add({{time, factor}}, force, prescribed);
    return test::resultant(structure_, force.of_nodes);
  }

 private:
  static std::unique_ptr<BlockSource<2>> wall() {
    WallParameters p;
    p.courses = p.blocks_per_course = 4;
    return make_wall(p);
  }

  std::unique_ptr<BlockSource<2>> source_;
  Structure<2> structure_;
};

}  // namespace voussoir::test
