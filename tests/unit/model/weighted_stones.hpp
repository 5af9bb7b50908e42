// Stones of rectangular cells whose meshes do not match, put on each other by hand: points have weights.
#pragma once

#include <memory>
#include <vector>

#include "joints/mortar_finder.hpp"
#include "linalg/linear_solver.hpp"
#include "mesh/block_list.hpp"
#include "model/contact_problem.hpp"
#include "nonlinear/contact_solver.hpp"
#include "unit/linalg/systems.hpp"

namespace voussoir::test {

/// A rectangle [m] with its cells.
struct Stone {
  double left, right, bottom, top;
  int across, up;
};

constexpr double young = 1e9, poisson = 0.2, pressure = 1e5;  // Pa, -, Pa; 1 m thick, plane stress

inline Block<2> block_of(BlockId id, const Stone& s) {
  Block<2> block;
  block.id = id;
  block.name = "stone " + std::to_string(id);
  const auto number = [&](int i, int j) { return j * (s.across + 1) + i; };
  for (int j = 0; j <= s.up; ++j)
    for (int i = 0; i <= s.across; ++i) {
      block.position.push_back({s.left + i * (s.right - s.left) / s.across, s.bottom + j * (s.top - s.bottom) / s.up});
      // The same place has the same vertex in all stones.
      const auto& x = block.position.back();
      block.vertex.push_back(std::llround(x[1] * 1e6) * 1000000000 + std::llround(x[0] * 1e6));
    }
  for (int j = 0; j < s.up; ++j)
    for (int i = 0; i < s.across; ++i) {
      Cell cell;
      cell.count = 4;
      cell.node = {number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)};
      block.cells.push_back(cell);
    }
  return block;
}

/// Every stone is a neighbour of every other: what meets without sharing vertices must be.
class MeetingStones : public BlockSource<2> {
 public:
  explicit MeetingStones(const std::vector<Stone>& stones) {
    BlockList<2> list;
    for (const auto& s : stones) list.blocks.push_back(block_of(static_cast<BlockId>(list.blocks.size()), s));
    listed_ = make_source<2>(std::move(list));
  }
  BlockId block_count() const override { return listed_->block_count(); }
  int node_count(BlockId b) const override { return listed_->node_count(b); }
  Block<2> block(BlockId b) const override { return listed_->block(b); }
  std::vector<Neighbour> neighbours(BlockId b) const override {
    std::vector<Neighbour> all;
    for (BlockId other = 0; other < block_count(); ++other)
      if (other != b) all.push_back({other, 1});
    return all;
  }
  const SetNames& block_sets() const override { return listed_->block_sets(); }
  const std::vector<std::string>& facet_sets() const override { return listed_->facet_sets(); }

 private:
  std::unique_ptr<BlockSource<2>> listed_;
};

inline std::vector<int> dealt_out(int blocks, const Teuchos::Comm<int>& comm) {
  std::vector<int> owner;
  for (int b = 0; b < blocks; ++b) owner.push_back(b % comm.getSize());
  return owner;
}

/// Stones under uniform pressure on all that looks up, on a base that holds them vertically; held at x = 0, or at their
/// left ends, where they would be if they stretched freely. Points that can be tied are, others are selected.
struct PressedStones {
  BlockId last;
  double way;  // m
  MeetingStones source;
  Structure<2> structure;
  ContactPoints points;
  Held held;
  std::vector<char> selected;
  std::vector<double> load, prescribed, stiffness, no_gap, displacement;
  PointField lambda, slip_origin;

  /// @param slid  [m] to the right by the last stone since it was drawn, where it meets others with other nodes
  explicit PressedStones(const std::vector<Stone>& stones, double slid = 0, const Comm& comm = everyone())
      : last(static_cast<BlockId>(stones.size()) - 1),
        way(slid),
        source(stones),
        structure(
            source, share_of_owners(source, dealt_out(source.block_count(), *comm), comm->getRank()), {},
            [](const Block<2>&) {
              return Material{young, poisson, 2000};
            },
            comm),
        points(source, structure, meeting_now()),
        held(std::vector<char>(2 * structure.nodes(), 0)),
        selected(points.untieable()),
        load(held.size(), 0.0),
        prescribed(held.size(), 0.0),
        stiffness(points.size(), young),
        lambda(2 * points.size(), 0.0) {
    selected.resize(points.size(), 0);
    auto now = stones;
    now.back().left += slid;
    now.back().right += slid;
    for (const auto& b : structure.blocks()) {
      const auto& s = now[b.mesh.id];
      for (int n = 0; n < static_cast<int>(b.mesh.position.size()); ++n) {
        const int node = b.first_local + n;
        const auto x = place(node);
        const bool alone_at_left = std::abs(x[0] - s.left) < 1e-12;
        if (alone_at_left) held[2 * node] = 1;
        if (std::abs(x[1]) < 1e-12) held[2 * node + 1] = 1;
        for (int c = 0; c < 2; ++c) prescribed[2 * node + c] = exact(node)[c];
        if (std::abs(x[1] - s.top) < 1e-12) load[2 * node + 1] = -pressure * open_to_the_sky(now, s, x[0]);
      }
    }
  }

  double slid_by(BlockId b) const { return b == last ? way : 0.0; }
  /// Where a node has slid to, undeformed [m].
  Vector<2> place(int node) const {
    const auto& x = structure.position()[node];
    return {x[0] + slid_by(structure.blocks()[structure.block_of_node()[node]].mesh.id), x[1]};
  }
  /// Displacement by uniform pressure [m].
  Vector<2> exact(int node) const {
    const auto x = place(node);
    return {x[0] - structure.position()[node][0] + poisson * pressure / young * x[0], -pressure / young * x[1]};
  }
  PointFinder<2> meeting_now() const {
    return [this](const BlockWithBorder<2>& i, const BlockWithBorder<2>& j) {
      auto moved_i = i, moved_j = j;
      for (auto* b : {&moved_i, &moved_j})
        for (auto& x : b->block.position) x[0] += slid_by(b->block.id);
      auto found = mortar_points(moved_i, moved_j);
      for (auto& p : found) p.place[0] -= slid_by(p.shares_i.is_one() ? i.block.id : j.block.id);  // as drawn
      return found;
    };
  }
  /// Integral of the shape function of a node at the top of a stone over what no stone lies on [m].
  static double open_to_the_sky(const std::vector<Stone>& stones, const Stone& s, double at) {
    const double h = (s.right - s.left) / s.across;
    double open = hat(at, h, s.left, s.right);
    for (const auto& other : stones)
      if (std::abs(other.bottom - s.top) < 1e-12)
        open -= hat(at, h, std::max(s.left, other.left), std::min(s.right, other.right));
    return open;
  }
  /// Integral of 1 - |x - at| / h between two places.
  static double hat(double at, double h, double from, double to) {
    const auto until = [&](double x) {
      const double t = std::min(1.0, std::max(-1.0, (x - at) / h));
      return h * (t < 0 ? (t + 1) * (t + 1) / 2 : 1 - (1 - t) * (1 - t) / 2);
    };
    return to > from ? until(to) - until(from) : 0.0;
  }

  NewtonReport solve(double friction, double tolerance = 1e-12) {
    const PointLaws law(points.size(), {friction, 0, 0});
    const Internals internals;
    const PreconditionerParameters preconditioner;
    if (slip_origin.empty()) slip_origin.assign(lambda.size(), 0.0);
    LinearSolver solver{SolverParameters{}};
    const Continuum continuum(structure, points, held, {}, internals.preconditioner, stiffness);
    ContactProblem problem({structure, points, continuum, held, stiffness, no_gap, preconditioner, internals, solver},
                           selected, {law, slip_origin, load, prescribed});
    displacement.resize(held.size(), 0.0);
    const auto x = problem.unknowns(displacement);
    NewtonParameters newton;
    newton.tolerance = tolerance;
    FastWay fast;
    Damage no_damage;
    const auto report =
        ContactSolver(problem, newton, internals.methods, fast).solve({*x, lambda, no_damage}, {tolerance});
    problem.displacement(*x, displacement);
    return report;
  }
  /// Of displacements, relative to the largest, over all ranks.
  double off() const {
    double worst = 0, largest = 0;
    for (int n = 0; n < structure.owned_nodes(); ++n)
      for (int c = 0; c < 2; ++c) {
        const double u = exact(n)[c];
        worst = std::max(worst, std::abs(displacement[2 * n + c] - u));
        largest = std::max(largest, std::abs(u));
      }
    return largest_of_ranks(*structure.comm(), worst) / largest_of_ranks(*structure.comm(), largest);
  }
  /// Of tractions at points that are selected, relative to the pressure, over all ranks.
  double tractions_off() const {
    double worst = 0;
    for (int k = 0; k < points.owned(); ++k) {
      if (!selected[k]) continue;
      const double force = pressure * points.points()[k].area;
      worst = std::max({worst, std::abs(lambda[2 * k] - force) / force, std::abs(lambda[2 * k + 1]) / force});
    }
    return largest_of_ranks(*structure.comm(), worst);
  }
};

}  // namespace voussoir::test
