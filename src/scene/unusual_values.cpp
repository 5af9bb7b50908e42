#include "scene/unusual_values.hpp"

#include <cmath>

#include "base/text.hpp"
#include "scene/scene_sections.hpp"
#include "scene/scene_values.hpp"

namespace voussoir {
namespace {

/// A sentence inside another: without its full stop.
std::string inside(std::string text) {
  while (!text.empty() && text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

Warnings unusual_values(const Scene& scene) {
  Scene copy = scene;
  Warnings all;
  const auto warn = [&](const std::string& path, double how_much, const std::string& text) {
    all.push_back({"unusual_value", scene.file + ": scene > " + path, "", how_much, text});
  };
  ParameterWalk walk;
  const auto look = [&](const std::string& path, const Parameter& p, double value) {
    if (p.range.is_usual(value)) return;
    const std::string unit = p.unit == "-" ? " (a pure number)" : " " + p.unit;
    warn(path, value,
         number_text(value) + unit + " is unusual, usual is " + p.range.usual_text() + unit +
             "; is it meant in this unit? " + inside(p.advice.empty() ? p.text : p.advice));
  };
  walk.parameter = [&](const std::string& path, const Parameter& p) {
    if (const auto* number = std::get_if<double*>(&p.value)) look(path, p, **number);
    if (const auto* numbers = std::get_if<std::map<std::string, double>*>(&p.value))
      for (const auto& [name, number] : **numbers) look(path + " > " + name, p, number);
  };
  walk.doubt = [&](const std::string& path, const std::string& value, const std::string& why,
                   const std::string& advice) { warn(path, 0, value + " " + why + "; " + inside(advice)); };
  declare(copy, walk);
  return all;
}

}  // namespace voussoir
