// Which of the effects the program knows a scene has in play.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace voussoir {

struct Effect {
  std::string name;  ///< of a type of load, "friction", ...
  std::string by;    ///< the members of the scene that name it; empty when it is absent
  bool in_play() const { return !by.empty(); }
};

/// Every effect, in a fixed order.
std::vector<Effect> effects_of(const Scene&);

/// The table that stands before a run.
void print_effects(std::ostream&, const Scene&);

}  // namespace voussoir
