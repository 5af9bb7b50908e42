// Where joints are springs beside being contact.
#pragma once

#include <vector>

#include "model/model.hpp"

namespace voussoir {

/// Whether a point has mortar that gives way along a component, the normal first.
inline bool yields(const Model& model, int point, int component = 0) {
  return !model.compliance().empty() && model.compliance()[point].along(component) > 0;
}

/// What is added to the gaps of a time step, half of those at its end where joints are rigid, for those of its middle.
inline std::vector<double> gaps_to_middle(const Model& model) {
  auto gap = model.initial_gap();
  for (std::size_t k = 0; k < gap.size(); ++k)
    if (yields(model, static_cast<int>(k))) gap[k] = 0;
  return gap;
}

}  // namespace voussoir
