#include "range/plane/stone_places.hpp"

#include <cstdio>

namespace voussoir {
namespace {

std::string digits(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string three_digits(double value) { return digits("%.3g", value); }

std::string place_text(const Vector<2>& x) { return "(" + digits("%.3f", x[0]) + ", " + digits("%.3f", x[1]) + ") m"; }

}  // namespace voussoir
