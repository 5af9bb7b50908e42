// Motion at the places that a scene observes, as further columns of the history.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "blocks/structure.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Weights of owned nodes whose sum is the motion of each place: one node, or the volumes of a set of blocks.
template <int dim>
class Observations {
 public:
  /// Holds nothing for a scene without observations. Collective; throws InputError on every rank when no node is near.
  Observations(const Scene&, const BlockSource<dim>&, const Structure<dim>&);

  /// "ux_m of crown", ...: displacements, and velocities when the scene has stages with a duration.
  const std::vector<std::string>& columns() const { return columns_; }
  /// A value per column, the same on every rank; velocities are not numbers in load steps. Collective unless empty.
  /// @param displacement, velocity  [m, m/s, dim x local node copies]
  /// @param moving  false in load steps, which have no velocity
  std::vector<double> values(const std::vector<double>& displacement, const std::vector<double>& velocity,
                             bool moving) const;

 private:
  using Weights = std::vector<std::pair<int, double>>;  ///< local node, weight
  std::vector<Weights> places_;
  std::vector<std::string> columns_;
  bool in_time_ = false;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
};

extern template class Observations<2>;

}  // namespace voussoir
