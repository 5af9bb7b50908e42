// What is handed to steps, books and checks belongs to the model that they are about: sizes of fields, finite numbers.
#pragma once

#include "model/model.hpp"
#include "model/step.hpp"

namespace voussoir {

/// Whether a field has a vector for every local node copy.
template <int dim>
bool is_of_nodes(const Model<dim>& model, const std::vector<double>& field) {
  return field.size() == static_cast<std::size_t>(dim) * model.structure().nodes();
}

/// Whether a field has a vector for every local point.
template <int dim>
bool is_of_points(const Model<dim>& model, const PointField& field) {
  return field.size() == static_cast<std::size_t>(dim) * model.points().size();
}

/// Whether a list has an entry for every local point.
template <int dim, class List>
bool is_per_point(const Model<dim>& model, const List& list) {
  return list.size() == static_cast<std::size_t>(model.points().size());
}

/// The contract of all that take a state: a broken one is a mistake of the program (base/check.hpp).
template <int dim>
void expect_state(const Model<dim>&, const ContactState&);
/// Likewise of what a step is to do.
template <int dim>
void expect_input(const Model<dim>&, const StepInput&);

extern template void expect_state<2>(const Model<2>&, const ContactState&);
extern template void expect_input<2>(const Model<2>&, const StepInput&);

}  // namespace voussoir
