// The door to the nodes of a contact point: how it moves with them, what its force does to them, and where it stands in
// matrices. Whoever is above joints sees a point through it alone.
//
//   motion B u = axes (sum_j w u - sum_i w u)        forces B^T f        matrices B^T D B
#pragma once

#include <cmath>

#include "blocks/block_system.hpp"
#include "blocks/held.hpp"
#include "joints/contact_point.hpp"

namespace voussoir {

enum class Side { i, j };

class PointOperator {
 public:
  /// @param components  of displacements: 2 in the plane, 3 in space
  PointOperator(const ContactPoint& point, int components) : point_(point), components_(components) {}

  /// Every node with its weight, negative on side i: f(node, weight).
  template <class F>
  void each(F&& f) const {
    for (const auto& share : point_.shares_i) f(share.node, -share.weight);
    for (const auto& share : point_.shares_j) f(share.node, share.weight);
  }
  /// Every pair of nodes that the point couples, with the product of their weights: f(row, column, weight).
  template <class F>
  void each_pair(F&& f) const {
    each([&](int row, double of_row) { each([&](int column, double weight) { f(row, column, of_row * weight); }); });
  }
  template <class F>
  void each_of(Side side, F&& f) const {
    for (const auto& share : shares(side)) f(share.node, share.weight);
  }
  /// Whether a condition holds for some node; for all.
  template <class F>
  bool any(F&& holds) const {
    bool found = false;
    each([&](int node, double) { found = found || holds(node); });
    return found;
  }
  template <class F>
  bool all(F&& holds) const {
    return !any([&](int node) { return !holds(node); });
  }

  /// Whether a node of either side is free to move along the normal. Where supports hold both sides nothing determines
  /// the force of a point: it bears none, and loses nothing.
  /// @param place_of  where a node is among those held
  template <class F>
  bool may_part(const Held& held, F&& place_of) const {
    return any([&](int node) {
      const int place = place_of(node);
      const auto along = held.to_own(place, point_.axis[0]);
      double free2 = 0;
      for (int c = 0; c < components_; ++c)
        if (!held[static_cast<std::size_t>(components_) * place + c]) free2 += along[c] * along[c];
      return std::sqrt(free2) > (held.has_frame(place) ? turned_off : 0.0);
    });
  }

  /// How much further side j moves than side i, along the axes of the drawing; along those of the point.
  /// @param u  on node copies
  Vector<3> difference(const std::vector<double>& u) const {
    return components_ == 2 ? difference_in<2>(u) : difference_in<3>(u);
  }
  Vector<3> motion(const std::vector<double>& u) const { return components_ == 2 ? motion_in<2>(u) : motion_in<3>(u); }
  /// Adds what a force of block i on block j, along the axes of the point, does to nodes.
  void add_forces(const double* force, double factor, std::vector<double>& nodal) const {
    components_ == 2 ? add_forces_in<2>(force, factor, nodal) : add_forces_in<3>(force, factor, nodal);
  }

  /// Where a side is [m].
  /// @param position  of nodes
  template <class Place>
  Place place(Side side, const std::vector<Place>& position) const {
    Place sum{};
    for (const auto& share : shares(side)) sum = sum + share.weight * position[share.node];
    return sum;
  }
  Vector<3> place(Side side, const BlockSystem& blocks) const {
    Vector<3> sum{};
    for (const auto& share : shares(side)) sum = sum + share.weight * blocks.place(share.node);
    return sum;
  }
  /// Stiffness of one side as the point sees it, from that at each of its nodes [N/m]: of_node(node).
  template <class F>
  double stiffness(Side side, F&& of_node) const {
    if (shares(side).is_one()) return of_node(shares(side).first());
    double give = 0;
    for (const auto& share : shares(side)) give += share.weight * share.weight / of_node(share.node);
    return 1 / give;
  }
  /// Speed that an impulse along an axis gives the sides against each other [1/kg], from the mass at each node:
  /// of_node(node, component), infinite where it is held, by components along the axes of the node.
  template <class F>
  double mobility(int axis, const Held& held, F&& of_node) const {
    double sum = 0;
    each([&](int node, double weight) {
      const auto along = held.to_own(node, point_.axis[axis]);
      for (int c = 0; c < components_; ++c) sum += weight * weight * along[c] * along[c] / of_node(node, c);
    });
    return sum;
  }
  /// The node of a side that counts most: for pictures and tables, which show one.
  int main_node(Side side) const {
    const auto* most = shares(side).begin();
    for (const auto& share : shares(side))
      if (share.weight > most->weight) most = &share;
    return most->node;
  }

 private:
  const PointSide& shares(Side side) const { return side == Side::i ? point_.shares_i : point_.shares_j; }

  template <int n>
  Vector<3> difference_in(const std::vector<double>& u) const {
    Vector<3> before{}, sum{};
    for (const auto& share : point_.shares_i)
      for (int c = 0; c < n; ++c) before[c] += share.weight * u[n * share.node + c];
    for (const auto& share : point_.shares_j)
      for (int c = 0; c < n; ++c) sum[c] += share.weight * u[n * share.node + c];
    return sum - before;
  }
  template <int n>
  Vector<3> motion_in(const std::vector<double>& u) const {
    const auto between = difference_in<n>(u);
    Vector<3> motion{};
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < n; ++c) motion[a] += between[c] * point_.axis[a][c];
    return motion;
  }
  template <int n>
  void add_forces_in(const double* along, double factor, std::vector<double>& nodal) const {
    for (int a = 0; a < n; ++a)
      for (int c = 0; c < n; ++c) {
        const double force = factor * along[a] * point_.axis[a][c];
        for (const auto& share : point_.shares_j) nodal[n * share.node + c] += share.weight * force;
        for (const auto& share : point_.shares_i) nodal[n * share.node + c] -= share.weight * force;
      }
  }

  // A unit vector whose part that is free is shorter lies along what is held, to the rounding of a turned drawing.
  static constexpr double turned_off = 1e-9;

  const ContactPoint& point_;
  int components_;
};

}  // namespace voussoir
