#include "range/plane/stone_overlap.hpp"

#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "base/text.hpp"
#include "blocks/rigid_motion.hpp"
#include "linalg/gather.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "mesh/box_tree.hpp"
#include "model/plane/plane_model.hpp"
#include "range/boxes_of_ranks.hpp"
#include "range/gaps_as_drawn.hpp"
#include "range/plane/stone_places.hpp"
#include "range/range_parameters.hpp"

namespace voussoir {
namespace {

// What the check of a drawing (mesh/border_check.cpp) takes for inside: so much of the shortest side of a cell, above
// round-off and what stones bend by.
constexpr double well_inside = 1e-3;

/// Where a stone is and how it has moved: what tells quickly that two of them cannot overlap.
struct StoneBox {
  BlockId block;
  int owner;
  Box<2> place, motion;  ///< [m] of its nodes: where they are, how they have moved
  double side;           ///< [m] the shortest of its cells
  double swollen;        ///< [m] by which a small rotation makes it larger than it is
};

/// [m] how deep two boxes lie in each other along the axis along which it is least; negative when they do not
double depth_of(const Box<2>& a, const Box<2>& b) {
  double depth = INFINITY;
  for (int c = 0; c < 2; ++c) depth = std::min(depth, std::min(a.high[c], b.high[c]) - std::max(a.low[c], b.low[c]));
  return depth;
}

/// [m] the most that any node of one has moved against any of the other
double largest_difference(const Box<2>& a, const Box<2>& b) {
  Vector<2> difference{};
  for (int c = 0; c < 2; ++c) difference[c] = std::max(a.high[c] - b.low[c], b.high[c] - a.low[c]);
  return norm(difference);
}

/// [m] a depth of a share of the shorter side, and what the stones are larger than they are
double tolerance(const StoneBox& a, const StoneBox& b, double share) {
  return share * std::min(a.side, b.side) + a.swollen + b.swollen;
}

Box<2> motions_here(const PlaneModel& model, const StepEnd& end) {
  auto all = empty_box<2>();
  const auto& u = end.state.displacement;
  for (int n = 0; n < model.structure().owned_nodes(); ++n)
    all.add({{u[2 * n], u[2 * n + 1]}, {u[2 * n], u[2 * n + 1]}});
  return all;
}

/// The largest difference between motions anywhere in the structure [m]. Collective.
double spread(const PlaneModel& model, const StepEnd& end) {
  const auto mine = motions_here(model, end);
  const std::array<double, 4> ends{-mine.low[0], -mine.low[1], mine.high[0], mine.high[1]};
  const auto all = largest_of_each(*model.structure().comm(), ends);
  return std::hypot(all[0] + all[2], all[1] + all[3]);
}

std::vector<StoneBox> boxes_here(const PlaneModel& model, const StepEnd& end,
                                 const std::vector<double>& shortest_side) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const bool followed = is_followed(model, end);
  std::vector<StoneBox> boxes;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    const auto& block = s.blocks()[b];
    StoneBox box{block.mesh.id, s.comm()->getRank(), empty_box<2>(), empty_box<2>(), 0, 0};
    for (int n = block.first_local; n < block.first_local + static_cast<int>(block.mesh.position.size()); ++n) {
      const auto x = place_now(s, u, n);
      const Vector<2> moved{u[2 * n], u[2 * n + 1]};
      box.place.add({x, x});
      box.motion.add({moved, moved});
    }
    box.side = shortest_side[b];
    if (!followed) {
      // x + theta x r is farther from the centre than r by theta^2 / 2 of it.
      const auto rigid = rigid_motion(s.drawn_position(), block, u);
      box.swollen = rigid.rotation * rigid.rotation * rigid.radius / 2;
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// Those of this rank, and of others those that are where this rank has some. Collective.
std::vector<StoneBox> boxes_near(const PlaneModel& model, const StepEnd& end,
                                 const std::vector<double>& shortest_side) {
  const auto& comm = *model.structure().comm();
  auto stones = boxes_here(model, end, shortest_side);
  auto around = empty_box<2>();
  for (const auto& stone : stones) around.add(stone.place);
  const auto boxes = boxes_of_ranks(around, comm);
  Post<StoneBox> post(comm);
  for (int rank = 0; rank < comm.getSize(); ++rank)
    for (const auto& stone : stones)
      if (rank != comm.getRank() && boxes[rank].overlaps(stone.place)) post.add(rank, stone);
  const auto others = std::move(post).send_all();
  stones.insert(stones.end(), others.begin(), others.end());
  std::sort(stones.begin(), stones.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
  return stones;
}

/// Pairs of stones whose boxes overlap and that have moved far enough against each other, of which the lower is one of
/// this rank.
std::vector<std::pair<int, int>> suspects(const std::vector<StoneBox>& stones, int rank) {
  std::vector<Box<2>> boxes;
  for (const auto& stone : stones) boxes.push_back(stone.place);
  const BoxTree<2> tree(std::move(boxes));
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < static_cast<int>(stones.size()); ++a) {
    if (stones[a].owner != rank) continue;
    tree.visit_overlaps(stones[a].place, [&](int b) {
      if (b <= a) return;
      const double least = tolerance(stones[a], stones[b], RangeParameters::counts_as_touching);
      if (depth_of(stones[a].place, stones[b].place) > least &&
          largest_difference(stones[a].motion, stones[b].motion) > least)
        pairs.emplace_back(a, b);
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Outlines of the stones of some pairs, whichever ranks they are on. Collective.
std::map<BlockId, Outline> outlines_of(const PlaneModel& model, const StepEnd& end, const std::vector<StoneBox>& stones,
                                       const std::vector<std::pair<int, int>>& pairs) {
  struct EdgeOfBlock {
    BlockId block;
    OutlineEdge edge;
  };
  const auto& s = model.structure();
  std::vector<std::pair<BlockId, int>> wanted;
  for (const auto& [a, b] : pairs)
    for (const int stone : {a, b}) wanted.emplace_back(stones[stone].block, stones[stone].owner);
  sort_unique(wanted);
  Post<BlockId> ask(*s.comm());
  for (const auto& [block, owner] : wanted) ask.add(owner, block);
  Post<EdgeOfBlock> answer(*s.comm());
  for (const auto& asked : std::move(ask).send())
    for (const BlockId block : asked.items)
      for (const auto& edge : outline_now(s, end.state.displacement, s.local_block(block)))
        answer.add(asked.rank, {block, edge});
  std::map<BlockId, Outline> outlines;
  for (const auto& [block, edge] : std::move(answer).send_all()) outlines[block].push_back(edge);
  return outlines;
}

struct Overlap {
  BlockId a, b;
  double depth;  ///< [m]
};

}  // namespace

RangeFindings look_at_outlines(const PlaneModel& model, const StepEnd& end, const std::vector<double>& shortest_side,
                               double smallest_side) {
  VOUSSOIR_EXPECT(shortest_side.size() == static_cast<std::size_t>(model.structure().owned_blocks()) &&
                  "sides: per owned block");
  VOUSSOIR_EXPECT(smallest_side > 0 && "smallest side: positive");
  // Stones do not lie in each other as drawn: deeper than they have moved against each other they cannot be.
  if (spread(model, end) <= RangeParameters::counts_as_touching * smallest_side) return {};
  const auto& comm = *model.structure().comm();
  const auto stones = boxes_near(model, end, shortest_side);
  const auto pairs = suspects(stones, comm.getRank());
  const auto outlines = outlines_of(model, end, stones, pairs);
  const GapsAsDrawn gaps(model);
  std::vector<Overlap> mine;
  for (const auto& [first, second] : pairs) {
    const auto &a = stones[first], &b = stones[second];
    const double as_drawn = gaps.between(a.block, b.block);
    const double depth =
        overlap_depth(outlines.at(a.block), outlines.at(b.block), tolerance(a, b, well_inside) + as_drawn);
    if (depth > tolerance(a, b, RangeParameters::counts_as_touching) + as_drawn)
      mine.push_back({a.block, b.block, depth});
  }
  auto found = all_gather(mine, comm, WhyWhole{"stones that lie in each other"});
  if (found.empty()) return {};
  std::sort(found.begin(), found.end(), [](const Overlap& a, const Overlap& b) {
    return std::make_tuple(-a.depth, a.a, a.b) < std::make_tuple(-b.depth, b.a, b.b);
  });
  const auto& worst = found.front();
  RangeFindings findings;
  findings.warnings.push_back({"stones_overlap", names_of(model, worst.a, worst.b), end.when, worst.depth,
                               "these stones lie " + three_digits(worst.depth) +
                                   " m in each other: contact is known between stones that are "
                                   "drawn touching, along the joint they are drawn with; from where they met on, "
                                   "forces and motions are not those "
                                   "of stones that press each other" +
                                   and_in_others(found.size() - 1)});
  return findings;
}

}  // namespace voussoir
