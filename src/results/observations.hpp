// Motion at the places that a scene observes and the forces of its supports, as further columns of the history.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/model.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// What a step leaves to be looked at.
struct Observed {
  const std::vector<double>& displacement;  ///< [m, dim x local node copies]
  const std::vector<double>& velocity;      ///< [m/s, likewise]; nothing in load steps
  const std::vector<double>& reaction;      ///< [N, likewise] of supports at held nodes; nothing where none is observed
  const std::vector<char>& absent;          ///< 1 for local blocks that are not there; empty where all are
};

/// Weights of owned nodes whose sum is the motion of each place: one node, the volumes of a set of blocks, or the edges
/// or faces of a support.
class Observations {
 public:
  /// Holds nothing for a scene without observations. Collective; throws InputError on every rank when no node is near.
  Observations(const Scene&, const Model&);

  /// "ux_m of crown", ...: displacements, and velocities when the scene has stages with a duration. Of a support also
  /// its force on the structure, "fx_N of pier", ...
  const std::vector<std::string>& columns() const { return columns_; }
  /// Whether a support is observed.
  bool ask_reactions() const { return ask_reactions_; }
  /// A value per column, the same on every rank: of the stones that are there, and no number where none is. Velocities
  /// are no numbers in load steps. Collective unless empty.
  std::vector<double> values(const Observed&) const;

 private:
  struct Weight {
    int at;  ///< dim x local node + component
    double weight;
  };
  enum class Field { displacement, velocity, reaction };
  struct Sum {
    Field field;
    std::vector<Weight> weights;
  };

  const BlockSystem& structure_;
  std::vector<Sum> sums_;  ///< by column
  std::vector<std::string> columns_;
  bool ask_reactions_ = false;
};

}  // namespace voussoir
