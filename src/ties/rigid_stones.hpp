// The blocks of a model as rigid stones between springs: what ties are judged by.
#pragma once

#include <algorithm>
#include <vector>

#include "model/handed_over.hpp"
#include "model/model.hpp"
#include "ties/dependent_stones.hpp"
#include "ties/error_estimate.hpp"
#include "ties/stone_relaxation.hpp"

namespace voussoir {

/// Stiffness of the springs [N/m]: that of the softest point, for all alike. Which stones find a balance is a matter of
/// places and laws; springs that differ by orders of magnitude would only make them wait for each other. Collective.
double stiffness_of_springs(const Model&);

/// 1 for each owned block that is not there, all its joints far open; empty for none.
std::vector<char> absent_here(const Model&);

/// Which stones depend on which, from what every rank knows of its own. Collective.
DependentStones dependent_stones(const Model&, const std::vector<char>& absent);

template <int dim>
Vector<dim> at_node(const std::vector<double>& field, int node) {
  Vector<dim> value;
  std::copy_n(field.begin() + static_cast<long>(dim) * node, dim, value.begin());
  return value;
}

/// The points as springs, each with the nearest force that its law admits; an open one bears none.
template <int dim>
std::vector<StonePoint<dim>> springs(const Model& model, const PointLaws& law, const ContactState& state,
                                     const std::vector<int>& cluster) {
  std::vector<StonePoint<dim>> springs(model.points().size());
  const auto open = open_points(model);
  PointField gap;  // where a point bears nothing
  for (int k = 0; k < model.points().size(); ++k) {
    auto& spring = springs[k];
    spring.law = law[k];
    const bool tied = is_tied(model.points().points()[k], cluster), is_open = !open.empty() && open[k];
    if (!is_open || !tied) {
      spring.force = nearest_lawful(spring.law, at_node<dim>(state.lambda, k));
      if (spring.force[0] > -spring.law.tension) continue;
    }
    if (tied && !is_open) continue;
    if (gap.empty()) gap = model.gaps(state.displacement);
    spring.gap = std::max(0.0, gap[dim * k]);
  }
  return springs;
}

template <int dim>
StoneVector<dim> sum_over(const BlockSystem& s, const NodesOfBlock& block, const Vector<dim>& middle,
                          const std::vector<double>& nodal) {
  StoneVector<dim> sum{};
  const int first = block.first_local, count = block.nodes;
  for (int i = first; i < first + count; ++i)
    sum = sum + wrench(in_dimension<dim>(s.place(i)) - middle, at_node<dim>(nodal, i));
  return sum;
}

/// Sum of the magnitudes of nodal forces of a block [N].
template <int dim>
double magnitudes_over(const NodesOfBlock& block, const std::vector<double>& nodal) {
  double sum = 0;
  const int first = block.first_local, count = block.nodes;
  for (int i = first; i < first + count; ++i) sum += norm(at_node<dim>(nodal, i));
  return sum;
}

/// The blocks as rigid bodies where they are; supports hold a node as a point does.
template <int dim>
std::vector<Stone<dim>> stones_of(const Model& model, const DependentStones& dependent, double stiffness) {
  const auto& s = model.structure();
  std::vector<Stone<dim>> stones;
  for (int b = 0; b < s.local_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    Stone<dim> stone;
    const int first = block.first_local, count = block.nodes;
    for (int i = first; i < first + count; ++i)
      stone.middle = stone.middle + (1.0 / count) * in_dimension<dim>(s.place(i));
    for (int i = first; i < first + count; ++i) {
      const Vector<dim> arm = in_dimension<dim>(s.place(i)) - stone.middle;
      stone.radius = std::max(stone.radius, norm(arm));
      for (int c = 0; c < dim; ++c) {
        if (!model.held()[dim * i + c]) continue;
        Vector<dim> along{};
        along[c] = 1;
        along = model.held().from_own(i, along);
        const auto way = wrench(arm, along);
        for (int w = 0; w < ways_of_stone(dim); ++w) stone.support[w] += stiffness * way[w] * way[w];
      }
    }
    if (const BlockId under = dependent.depends_on(block.id); under >= 0) stone.rides_on = s.local_block(under);
    stones.push_back(stone);
  }
  return stones;
}

}  // namespace voussoir
