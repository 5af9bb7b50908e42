#include "base/rotation_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

constexpr const char* letter[] = {"x", "y", "z"};

}  // namespace

void add_if_given(std::vector<KeyOfSpace>& keys, const std::string& key, double value, const std::string& unit,
                  double otherwise) {
  if (value != otherwise) keys.push_back({key, " = " + number_text(value) + " [" + unit + "]"});
}

void RotationParameters::declare(ParameterSection& section, const std::string& unit, double usual_least,
                                 double usual_most, const std::string& text, const std::string& turns) {
  section.add("rotation", rotation, unit, any_number().usually(usual_least, usual_most), text);
  for (int c = 0; c < 3; ++c)
    section.add(std::string("axis ") + letter[c], axis[c], "-", any_number(),
                std::string("of the rotation in space, a direction of any length; by default it points to z") +
                    (c == 2 ? "" : ", so that this is 0"));
  for (int c = 0; c < 3; ++c)
    section.add(std::string("about ") + letter[c], about[c], "m", any_number().or_infinite(),
                std::string("a point of the axis") + (c == 2 ? ", in space" : "") + "; inf: " + turns);
  section.check(norm(axis) > 0, "axis z", number_text(axis[2]), "is no direction: axis x, axis y and axis z are 0",
                "Give the direction of the axis, such as 1 for one of them");
}

std::vector<KeyOfSpace> RotationParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  for (int c = 0; c < 3; ++c) add_if_given(keys, std::string("axis ") + letter[c], axis[c], "-", c == 2 ? 1 : 0);
  add_if_given(keys, "about z", about[2], "m", middle);
  return keys;
}

}  // namespace voussoir
