// What is handed to steps, books and checks belongs to the model that they are about: sizes of fields, finite numbers.
#pragma once

#include "model/model.hpp"
#include "model/step.hpp"

namespace voussoir {

/// Whether a field has a vector for every local node copy.
inline bool is_of_nodes(const Model& model, const std::vector<double>& field) {
  return field.size() == static_cast<std::size_t>(model.components()) * model.structure().nodes();
}

/// Whether a field has a vector for every local point.
inline bool is_of_points(const Model& model, const PointField& field) {
  return field.size() == static_cast<std::size_t>(model.components()) * model.points().size();
}

/// Whether a list has an entry for every local point.
template <class List>
bool is_per_point(const Model& model, const List& list) {
  return list.size() == static_cast<std::size_t>(model.points().size());
}

/// The contract of all that take a state: a broken one is a mistake of the program (base/check.hpp).
void expect_state(const Model&, const ContactState&);
/// Likewise of what a step is to do.
void expect_input(const Model&, const StepInput&);

}  // namespace voussoir
