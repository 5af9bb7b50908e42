#include "range/plane/stone_places.hpp"

#include "base/text.hpp"

namespace voussoir {

std::string place_text(const Vector<2>& x) {
  return "(" + formatted("%.3f", x[0]) + ", " + formatted("%.3f", x[1]) + ") m";
}

}  // namespace voussoir
