#include "loads/acceleration_unit.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "base/words.hpp"

namespace voussoir {
namespace {

constexpr double standard_gravity = 9.80665;  // [m/s2] what records call g

/// Small letters without blanks: "CM / S ^ 2" is "cm/s^2".
std::string plain(const std::string& text) {
  std::string small;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c))) small += c;
  return in_small_letters(small);
}

std::optional<AccelerationUnit> unit_written(const std::string& text) {
  std::string unit = plain(text);
  for (const char* second : {"sec", "s"})
    for (const char* square : {"^2", "**2", "\xC2\xB2", "2"}) {
      const std::string ending = std::string("/") + second + square;
      if (unit.size() > ending.size() && unit.compare(unit.size() - ending.size(), ending.size(), ending) == 0)
        unit = unit.substr(0, unit.size() - ending.size()) + "/s/s";
    }
  const auto twice = unit.find("/sec/sec");
  if (twice != std::string::npos) unit = unit.substr(0, twice) + "/s/s";
  if (unit == "g") return AccelerationUnit::g;
  if (unit == "gal" || unit == "gals") return AccelerationUnit::gal;
  if (unit == "m/s/s") return AccelerationUnit::m_per_s2;
  if (unit == "cm/s/s") return AccelerationUnit::cm_per_s2;
  if (unit == "mm/s/s") return AccelerationUnit::mm_per_s2;
  return {};
}

/// What stands where a heading puts units: in brackets, or the word behind "units of", "units:" and the like.
std::vector<std::string> places_of_units(const std::string& line) {
  std::vector<std::string> places;
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}})
    for (std::size_t from = line.find(open); from != std::string::npos; from = line.find(open, from + 1)) {
      const auto to = line.find(close, from);
      if (to != std::string::npos) places.push_back(line.substr(from + 1, to - from - 1));
    }
  const std::string small = in_small_letters(line);
  for (const char* word : {"units of ", "units:", "unit:", "units=", "unit="})
    if (const auto at = small.find(word); at != std::string::npos) {
      const auto from = small.find_first_not_of(" \t", at + std::string(word).size());
      if (from == std::string::npos) continue;
      const auto to = small.find_first_of(" \t,;", from);
      places.push_back(small.substr(from, to == std::string::npos ? to : to - from));
    }
  return places;
}

}  // namespace

const std::vector<std::pair<std::string, AccelerationUnit>>& acceleration_units() {
  static const std::vector<std::pair<std::string, AccelerationUnit>> units{{"m/s2", AccelerationUnit::m_per_s2},
                                                                           {"g", AccelerationUnit::g},
                                                                           {"cm/s2", AccelerationUnit::cm_per_s2},
                                                                           {"gal", AccelerationUnit::gal},
                                                                           {"mm/s2", AccelerationUnit::mm_per_s2}};
  return units;
}

std::string word_of(AccelerationUnit unit) {
  for (const auto& [word, known] : acceleration_units())
    if (known == unit) return word;
  return "";
}

double in_si(AccelerationUnit unit) {
  switch (unit) {
    case AccelerationUnit::g:
      return standard_gravity;
    case AccelerationUnit::cm_per_s2:
    case AccelerationUnit::gal:
      return 1e-2;
    case AccelerationUnit::mm_per_s2:
      return 1e-3;
    case AccelerationUnit::m_per_s2:
      break;
  }
  return 1;
}

std::optional<AccelerationUnit> unit_named_in(const std::vector<std::string>& heading) {
  std::optional<AccelerationUnit> found;
  for (const auto& line : heading)
    for (const auto& place : places_of_units(line)) {
      const auto unit = unit_written(place);
      if (!unit) continue;
      if (found && in_si(*found) != in_si(*unit)) return {};
      found = unit;
    }
  return found;
}

bool names_other_motion(const std::vector<std::string>& heading) {
  bool other = false, acceleration = false;
  for (const auto& line : heading) {
    const std::string small = plain(line);
    other |= small.find("velocitytimeseries") != std::string::npos ||
             small.find("displacementtimeseries") != std::string::npos;
    acceleration |= small.find("accelerationtimeseries") != std::string::npos;
  }
  return other && !acceleration;
}

}  // namespace voussoir
