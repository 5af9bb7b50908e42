// Where the stones of a rank are now, as the checks of a model's range need it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mesh/outline.hpp"
#include "model/plane/plane_model.hpp"
#include "range/stone_names.hpp"

namespace voussoir {

inline Vector<2> place_now(const Structure<2>& s, const std::vector<double>& u, int node) {
  return s.drawn_position()[node] + Vector<2>{u[2 * node], u[2 * node + 1]};
}

/// Where a side of a point is.
inline Vector<2> place_now(const Structure<2>& s, const std::vector<double>& u, const PointOperator& p, Side side) {
  Vector<2> place{};
  p.each_of(side, [&](int node, double weight) { place = place + weight * place_now(s, u, node); });
  return place;
}

/// Border of a local block where a displacement has moved it.
inline Outline outline_now(const Structure<2>& s, const std::vector<double>& u, int block) {
  Outline outline;
  const int first = s.blocks()[block].first_local;
  for (const auto& [a, b] : border_of(s.blocks()[block].mesh.cells))
    outline.push_back({place_now(s, u, first + a), place_now(s, u, first + b)});
  return outline;
}

/// Edges of that border between some of the nodes.
inline Outline face_now(const Structure<2>& s, const std::vector<double>& u, int block, std::vector<int> nodes) {
  std::sort(nodes.begin(), nodes.end());
  const auto known = [&](int node) { return std::binary_search(nodes.begin(), nodes.end(), node); };
  Outline face;
  const int first = s.blocks()[block].first_local;
  for (const auto& [a, b] : border_of(s.blocks()[block].mesh.cells))
    if (known(first + a) && known(first + b)) face.push_back({place_now(s, u, first + a), place_now(s, u, first + b)});
  return face;
}

/// To the millimetre.
std::string place_text(const Vector<2>&);

}  // namespace voussoir
