// What the checks of a model's range say of stones, in the plane and in space.
#pragma once

#include <string>

#include "base/words.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Whether a support holds anything of a local block.
inline bool is_held(const Model& model, int block) {
  const auto& b = model.structure().nodes_of(block);
  const auto n = static_cast<std::size_t>(model.components());
  const auto first = n * static_cast<std::size_t>(b.first_local), end = first + n * static_cast<std::size_t>(b.nodes);
  bool any = false;
  for (auto i = first; i < end; ++i) any |= model.held()[i] != 0;
  return any;
}

inline std::string names_of(const Model& model, BlockId i, BlockId j) {
  return model.block_name(i) + " / " + model.block_name(j);
}

/// "; likewise in 3 other places"
inline std::string and_in_others(std::size_t others) {
  if (others == 0) return "";
  return "; likewise in " + counted(others, "other place");
}

}  // namespace voussoir
