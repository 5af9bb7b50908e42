#include "blocks/supports.hpp"

#include <cmath>
#include <map>

namespace voussoir {
namespace {

// What is left of a unit vector beside others, below which it is one of theirs: normals of drawn faces differ by their
// rounding, and what two supports hold along directions that part by less no structure tells apart.
constexpr double same_direction = 1e-6;

// Cosine of the angle up to which facets that meet are taken for parts of one smooth surface, 30 degrees: from there on
// programs that draw and mesh surfaces take what they meet in for an edge.
const double smooth = std::cos(std::acos(-1.0) / 6);

/// The normals at a node of facets that meet in an edge; those of one smooth surface have one.
template <class V>
void add_normal(std::vector<V>& sums, const V& across) {
  for (auto& sum : sums) {
    const double along = dot(sum, across);
    if (std::abs(along) < smooth * norm(sum) * norm(across)) continue;
    sum = sum + (along < 0 ? -1.0 : 1.0) * across;
    return;
  }
  sums.push_back(across);
}

template <int dim>
Vector<dim> axis(int component) {
  Vector<dim> e{};
  e[component] = 1;
  return e;
}

/// Own axes of a node: what is held first, square to each other, and what completes them.
template <int dim>
Matrix<3> frame_of(const Directions<dim>& held) {
  auto all = held;
  while (all.count() < dim) {  // the axis that is farthest from what is there
    int best = 0;
    for (int c = 1; c < dim; ++c)
      if (norm(all.across(axis<dim>(c))) > norm(all.across(axis<dim>(best)))) best = c;
    all.add(axis<dim>(best));
  }
  Matrix<3> frame{};
  frame[2][2] = 1;
  for (int i = 0; i < dim; ++i)
    for (int c = 0; c < dim; ++c) frame[i][c] = all[i][c];
  return frame;
}

}  // namespace

Vector<2> across(const Block<2>& block, const TaggedFacet& edge) {
  const auto along = block.position[edge.node[1]] - block.position[edge.node[0]];
  return {along[1], -along[0]};
}

/// Half the product of the diagonals across each other.
Vector<3> across(const Block<3>& block, const TaggedFacet& face) {
  const auto& x = block.position;
  const int last = face.count - 1;
  return 0.5 * cross(x[face.node[2]] - x[face.node[0]], x[face.node[last]] - x[face.node[1]]);
}

template <int dim>
Vector<dim> Directions<dim>::across(Vector<dim> v) const {
  for (int repeat = 0; repeat < 2; ++repeat)  // the second takes what rounding has left
    for (int i = 0; i < count_; ++i) v = v - dot(v, along_[i]) * along_[i];
  return v;
}

template <int dim>
bool Directions<dim>::add(const Vector<dim>& along) {
  if (count_ == dim) return false;
  const auto rest = across(along);
  const double length = norm(rest);
  if (!(length > same_direction)) return false;
  along_[count_++] = (1 / length) * rest;
  return true;
}

template <int dim>
std::vector<HeldAlong<dim>> held_along(const Structure<dim>& s, const SupportParameters& support, const FacetSet& set) {
  std::map<int, std::vector<Vector<dim>>> of_node;
  for (const auto& b : s.blocks())
    for (const auto& f : b.mesh.facets) {
      if (!set.has(b.mesh, f)) continue;
      for (int i = 0; i < f.count; ++i) {
        auto& along = of_node[b.first_local + f.node[i]];
        if (support.along_normal()) add_normal(along, across(b.mesh, f));
      }
    }
  std::vector<HeldAlong<dim>> all;
  for (auto& [node, along] : of_node) {
    for (auto& normal : along) normal = (1 / norm(normal)) * normal;
    for (int c = 0; c < dim; ++c)
      if (support.holds(c)) along.push_back(axis<dim>(c));
    all.push_back({node, std::move(along)});
  }
  return all;
}

template <int dim>
Held held_by(const Structure<dim>& s, const std::vector<SupportedFacets>& supports) {
  std::vector<char> along(dim * static_cast<std::size_t>(s.nodes()), 0);
  std::map<int, std::vector<Vector<dim>>> normals;
  for (const auto& [support, facets] : supports) {
    if (!support.along_normal()) {
      hold(s, support, facets, along);
      continue;
    }
    for (const auto& at : held_along(s, support, facets))
      normals[at.node].insert(normals[at.node].end(), at.along.begin(), at.along.end());
  }
  Held held(std::move(along));
  for (const auto& [node, of_node] : normals) {
    Directions<dim> own;
    for (int c = 0; c < dim; ++c)
      if (held[dim * static_cast<std::size_t>(node) + c]) own.add(axis<dim>(c));
    for (const auto& normal : of_node) own.add(normal);
    held.set_frame(node, frame_of(own));
    for (int c = 0; c < dim; ++c) held[dim * static_cast<std::size_t>(node) + c] = c < own.count();
  }
  return held;
}

template class Directions<2>;
template class Directions<3>;
template std::vector<HeldAlong<2>> held_along(const Structure<2>&, const SupportParameters&, const FacetSet&);
template std::vector<HeldAlong<3>> held_along(const Structure<3>&, const SupportParameters&, const FacetSet&);
template Held held_by(const Structure<2>&, const std::vector<SupportedFacets>&);
template Held held_by(const Structure<3>&, const std::vector<SupportedFacets>&);

}  // namespace voussoir
