#include "results/largest_mover.hpp"

#include <cmath>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"

namespace voussoir {

MechanismSummary largest_mover(const Model& model, const std::vector<double>& motion) {
  VOUSSOIR_EXPECT(is_of_nodes(model, motion) && "motion: of node copies");
  const auto& s = model.structure();
  const int dim = model.components();
  double size = -1;
  int block = -1;
  for (int i = 0; i < s.owned_nodes(); ++i) {
    double square = 0;
    for (int c = 0; c < dim; ++c) square += motion[dim * i + c] * motion[dim * i + c];
    if (std::sqrt(square) > size) size = std::sqrt(square), block = s.nodes_of(s.block_of_node()[i]).id;
  }
  const double largest = largest_over_ranks(*s.comm(), size);
  const int found = largest_over_ranks(*s.comm(), size == largest ? block : -1);
  return {found, model.block_name(found), largest, false};
}

}  // namespace voussoir
