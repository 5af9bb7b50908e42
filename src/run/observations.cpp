#include "run/observations.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "loads/loads.hpp"
#include "step/scene_fit.hpp"

namespace voussoir {
namespace {

constexpr const char* axis[] = {"x", "y", "z"};

template <int dim>
std::vector<std::pair<int, double>> node_near(const ObservationParameters& p, const std::string& where,
                                              const Structure<dim>& s, const std::vector<char>& observed) {
  const auto node = nearest_node(s, Vector<dim>{p.x, p.y}, observed);
  if (node.distance > p.tolerance)
    throw InputError(where + " > tolerance = " + number_text(p.tolerance) +
                     " [m]\n  is exceeded: the node nearest to (" + number_text(p.x) + ", " + number_text(p.y) +
                     ") m is " + number_text(node.distance) +
                     " m away.\n  Move the point to the structure, or give a larger tolerance.");
  if (node.local < 0 || node.local >= s.owned_nodes()) return {};
  return {{node.local, 1.0}};
}

template <int dim>
std::vector<std::pair<int, double>> mean_of(const Structure<dim>& s, const std::vector<char>& observed) {
  std::vector<std::pair<int, double>> weights;
  double mine = 0, all = 0;
  for (int n = 0; n < s.owned_blocks(); ++n) {
    const auto& b = s.blocks()[n];
    if (!observed[b.first_local]) continue;
    const auto volume = nodal_volumes(b.mesh, s.model().thickness);
    for (std::size_t i = 0; i < volume.size(); ++i) {
      weights.emplace_back(b.first_local + static_cast<int>(i), volume[i]);
      mine += volume[i];
    }
  }
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  for (auto& [node, weight] : weights) weight /= all;
  return weights;
}

}  // namespace

template <int dim>
Observations<dim>::Observations(const Scene& scene, const BlockSource<dim>& source, const Structure<dim>& s)
    : comm_(s.comm()) {
  for (const auto& stage : scene.stages) in_time_ |= stage.dynamic();
  for (const auto& [name, p] : scene.observations) {
    std::vector<char> observed(s.nodes(), 0);
    for (const auto& b : s.blocks())
      if (in_set(source, b.mesh, p.blocks)) std::fill_n(observed.begin() + b.first_local, b.mesh.position.size(), 1);
    const std::string where = scene.file + ": scene > observations > " + name;
    places_.push_back(p.place == ObservationParameters::Place::mean ? mean_of(s, observed)
                                                                    : node_near(p, where, s, observed));
    for (int c = 0; c < dim; ++c) columns_.push_back(std::string("u") + axis[c] + "_m of " + name);
    for (int c = 0; c < dim && in_time_; ++c) columns_.push_back(std::string("v") + axis[c] + "_m_per_s of " + name);
  }
}

template <int dim>
std::vector<double> Observations<dim>::values(const std::vector<double>& displacement,
                                              const std::vector<double>& velocity, bool moving) const {
  std::vector<double> mine(columns_.size(), 0.0), all(columns_.size());
  if (columns_.empty()) return all;
  std::size_t column = 0;
  const auto add = [&](const std::vector<double>& field, const Weights& weights) {
    for (int c = 0; c < dim; ++c, ++column)
      for (const auto& [node, weight] : weights) mine[column] += weight * field[dim * node + c];
  };
  for (const auto& weights : places_) {
    add(displacement, weights);
    if (in_time_ && moving) add(velocity, weights);
    if (in_time_ && !moving) column += dim;
  }
  Teuchos::reduceAll(*comm_, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  if (in_time_ && !moving)
    for (std::size_t k = 0; k < all.size(); ++k)
      if (k / dim % 2 == 1) all[k] = std::numeric_limits<double>::quiet_NaN();
  return all;
}

template class Observations<2>;

}  // namespace voussoir
