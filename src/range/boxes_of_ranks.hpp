// Where the stones of each rank are: stones of two ranks can meet only where these boxes do.
#pragma once

#include <cmath>
#include <vector>

#include "linalg/gather.hpp"
#include "mesh/box_tree.hpp"

namespace voussoir {

/// Overlaps nothing, and grows to whatever is added.
template <int dim>
Box<dim> empty_box() {
  Box<dim> box;
  box.low.fill(INFINITY);
  box.high.fill(-INFINITY);
  return box;
}

/// The box that each rank gives. Collective.
template <int dim>
std::vector<Box<dim>> boxes_of_ranks(const Box<dim>& mine, const Teuchos::Comm<int>& comm) {
  return all_gather(std::vector<Box<dim>>{mine}, comm, WhyWhole{"a box of each rank"});
}

}  // namespace voussoir
