#include "selection/rest.hpp"

#include <algorithm>

namespace voussoir {

Rest rested(const std::vector<double>& gap, int points, int patience) {
  Rest rest;
  rest.place = gap;
  rest.steps.assign(points, patience);
  rest.needed.assign(points, patience);
  rest.bonded.assign(points, 0.0);
  return rest;
}

bool bond_what_rests(Rest& rest, std::vector<char>& selected, const std::vector<double>& gap,
                     const std::vector<double>& stiffness, const std::vector<char>& calm, double energy, int patience,
                     const RestParameters& numbers) {
  const std::size_t points = selected.size();
  if (points == 0) return false;
  const std::size_t components = gap.size() / points;
  if (rest.place.size() != gap.size() || rest.steps.size() != points || rest.needed.size() != points ||
      rest.bonded.size() != points) {
    rest = rested(gap, static_cast<int>(points), patience);
    rest.steps.assign(points, 0.0);
  }
  bool any = false;
  for (std::size_t k = 0; k < points; ++k) {
    auto& steps = rest.steps[k];
    auto& needed = rest.needed[k];
    if (!selected[k]) {
      if (rest.bonded[k] != 0 && ++steps > numbers.longest_wait * needed) needed = patience;
      continue;
    }
    if (rest.bonded[k] != 0) {
      rest.bonded[k] = steps = 0;
      needed = std::min(2 * needed, numbers.longest_wait * patience);
    }
    double moved = 0;
    for (std::size_t i = k * components; i < (k + 1) * components; ++i)
      moved += stiffness[k] / 2 * (gap[i] - rest.place[i]) * (gap[i] - rest.place[i]);
    if (moved > energy || !calm[k]) {
      std::copy_n(gap.begin() + static_cast<std::ptrdiff_t>(k * components), components,
                  rest.place.begin() + static_cast<std::ptrdiff_t>(k * components));
      steps = 0;
    } else if (++steps >= needed) {
      selected[k] = 0;
      rest.bonded[k] = 1;
      steps = 0;
      any = true;
    }
  }
  return any;
}

}  // namespace voussoir
