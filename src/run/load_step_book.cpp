#include "run/load_step_book.hpp"

#include "joints/friction_work.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

template <int dim>
using Tangential = std::array<double, dim - 1>;

template <int dim>
Tangential<dim> tangential(const PointField& field, int k) {
  Tangential<dim> t;
  for (int c = 1; c < dim; ++c) t[c - 1] = field[dim * k + c];
  return t;
}

template <int dim>
double bound_of(const Model<dim>& model, const ContactState& state, int k) {
  auto law = model.law()[k];
  if (state.broken[k]) law.cohesion = law.tension = 0;
  return friction_bound(law, state.lambda[dim * k]);
}

}  // namespace

template <int dim>
LoadStepBook<dim>::LoadStepBook(const Model<dim>& model, const AdaptiveStep<dim>& step, const ContactState& before,
                                const std::vector<double>& load_before)
    : model_(model),
      step_(step),
      before_(before),
      load_before_(load_before),
      reaction_before_(step.residual(before, load_before)),
      gap_before_(step.stone_gaps(before)) {}

template <int dim>
typename LoadStepBook<dim>::OfPoints LoadStepBook<dim>::of_points(const ContactState& after) const {
  OfPoints sum;
  const auto gap = step_.stone_gaps(after);
  for (int k = 0; k < model_.points().owned(); ++k) {
    if (!after.selected[k]) continue;
    double by_mean = 0;  // what contact forces take by the mean of start and end
    if (after.broken[k] && !before_.broken[k]) {
      for (int i = dim * k; i < dim * (k + 1); ++i)
        by_mean -= (before_.lambda[i] + after.lambda[i]) / 2 * (gap[i] - gap_before_[i]);
      sum.fracture += by_mean;
      continue;
    }
    const auto force_before = tangential<dim>(before_.lambda, k), force = tangential<dim>(after.lambda, k);
    const auto slip = tangential<dim>(gap, k) - tangential<dim>(gap_before_, k);
    const double taken = friction_work(bound_of(model_, after, k), force, slip, model_.local_stiffness()[k]);
    if (taken == 0) continue;
    by_mean = -0.5 * dot(force_before + force, slip);
    const double by_bounds = (bound_of(model_, before_, k) * norm(slip) + taken) / 2;
    sum.friction += taken;
    sum.to_work += by_bounds - by_mean;
  }
  return sum;
}

template <int dim>
EnergyOfStep LoadStepBook<dim>::close(const ContactState& after, const std::vector<double>& load) const {
  const auto& s = model_.structure();
  const auto reaction = step_.residual(after, load);
  const auto deformation = s.deformation(after.displacement);
  std::vector<double> ku;
  s.apply_stiffness(deformation, ku);
  double elastic = 0, work = 0;
  for (int i = 0; i < dim * s.owned_nodes(); ++i) {
    elastic += deformation[i] * ku[i] / 2;
    const double moved = after.displacement[i] - before_.displacement[i];
    work += moved * (load_before_[i] + load[i]) / 2;
    if (model_.held()[i]) work += moved * (reaction_before_[i] + reaction[i]) / 2;
  }
  elastic += model_.mortar_energy(after.lambda);
  const auto points = of_points(after);
  const auto& comm = *s.comm();
  return {total_over_ranks(comm, elastic),
          0,
          total_over_ranks(comm, work + points.to_work),
          total_over_ranks(comm, points.friction),
          total_over_ranks(comm, points.fracture),
          0};
}

template class LoadStepBook<2>;

}  // namespace voussoir
