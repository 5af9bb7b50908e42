// A small wall held at its base, with some of its contact points selected.
#pragma once

#include <memory>

#include "homogenisation/continuum.hpp"
#include "homogenisation/system_matrix.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace voussoir::test {

/// some: every other point by chance, so that vertices are tied in part; few: one joint of a larger wall.
enum class Selected { none, few, some, all };

struct SelectedWall {
  std::unique_ptr<BlockSource<2>> source;
  Structure<2> structure;
  ContactPoints points;
  std::vector<char> held, selected;
  MergedSpace space;

  explicit SelectedWall(Selected what, const Comm& comm = everyone())
      : source(wall(what == Selected::few ? 12 : 5, what == Selected::few ? 8 : 3)),
        structure(structure_of(*source, comm)),
        points(*source, structure),
        held(at_base(structure)),
        selected(chosen(points, what)),
        space(structure, points, selected, held) {}

  /// Statuses by chance: open, sticking, slipping. As stiff as the stones (1e9 N/m).
  std::vector<PointStiffness> statuses() const {
    std::vector<PointStiffness> stiffness;
    for (const auto& p : points.points()) {
      const double dice = noise(7 * p.id + 3);
      stiffness.push_back({dice > -0.4 ? 1e9 : 0.0, dice > 0.3 ? 1e9 : 0.0});
    }
    return stiffness;
  }

  /// A hundredth of the stiffness of the stones holds blocks whose points are all open.
  std::vector<double> proximal() const { return std::vector<double>(2 * space.owned_clusters(), 1e7); }

  /// 1 for every local block with a selected point. All points of a block in this wall are with those who know it, or
  /// its owner tells.
  std::vector<char> active() const {
    std::vector<double> of_node(structure.nodes(), 0.0);
    for (int k = 0; k < points.size(); ++k) {
      if (!selected[k]) continue;
      for (const BlockId b : {points.joint_of(k).block_i, points.joint_of(k).block_j}) {
        const auto& block = structure.nodes_of(structure.local_block(b));
        std::fill_n(of_node.begin() + block.first_local, block.nodes, 1.0);
      }
    }
    structure.node_exchange().update(of_node, 1);
    std::vector<char> active;
    for (int b = 0; b < structure.local_blocks(); ++b) active.push_back(of_node[structure.nodes_of(b).first_local] > 0);
    return active;
  }

 private:
  static std::unique_ptr<BlockSource<2>> wall(int courses, int blocks_per_course) {
    WallParameters p;
    p.courses = courses;
    p.blocks_per_course = blocks_per_course;
    return make_wall(p);
  }
  static std::vector<char> at_base(const Structure<2>& s) {
    std::vector<char> marks(2 * s.nodes(), 0);
    for (int i = 0; i < s.nodes(); ++i)
      if (s.position()[i][1] == 0) marks[2 * i] = marks[2 * i + 1] = 1;
    return marks;
  }
  static std::vector<char> chosen(const ContactPoints& points, Selected what) {
    std::vector<char> marks;
    for (const auto& p : points.points()) {
      const auto& joint = points.joints()[p.joint];
      const bool one_of_few = joint.block_i == 40 && joint.block_j > 45;  // on the bed above it
      marks.push_back(what == Selected::all || (what == Selected::few && one_of_few) ||
                      (what == Selected::some && noise(p.id) > 0));
    }
    return marks;
  }
};

/// Statuses of the wall; points that stick slip in one direction instead, with friction that follows the pressure.
inline std::vector<PointStiffness> slipping(const SelectedWall& w, double direction) {
  auto stiffness = w.statuses();
  for (auto& s : stiffness)
    if (s.resists_slip()) s = {s.normal, 0, 0.6 * direction * s.normal};
  return stiffness;
}

/// r = 0 where the displacement is prescribed.
inline Teuchos::RCP<TpetraVector> load(const SelectedWall& w) {
  auto r = noise_vector(w.space.map());
  for (int i = 0; i < 2 * w.space.owned_clusters(); ++i)
    if (w.space.held()[i]) local_view_to_write(*r)[i] = 0;
  return r;
}

}  // namespace voussoir::test
