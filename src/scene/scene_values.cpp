#include "scene/scene_values.hpp"

#include <cstdio>

#include "base/digest.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "scene/scene_sections.hpp"
#include "scene/scene_xml.hpp"
#include "scene/xml_printer.hpp"

namespace voussoir {
namespace {

/// The whole of a short text; of a long one its start and a digest, for messages and tables.
std::string brief(const std::string& text) {
  constexpr std::size_t longest = 120;
  if (text.size() <= longest) return text;
  char all[32];
  std::snprintf(all, sizeof all, "%016llx", static_cast<unsigned long long>(digest(text.data(), text.size())));
  return shortened(text, longest) + " (" + counted(text.size(), "letter") + ", digest " + all + ")";
}

std::string with_unit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " [" + unit + "]";
}

/// Adds a parameter; a sublist of numbers as a key for each, so that one of them can be told from the others.
void add(SceneValues& values, const std::string& path, const Parameter& p) {
  if (const auto* numbers = std::get_if<std::map<std::string, double>*>(&p.value)) {
    for (const auto& [name, number] : **numbers)
      values.emplace_back(path + " > " + name, with_unit(number_text(number), p.unit));
  } else if (const auto* list = std::get_if<Teuchos::ParameterList*>(&p.value)) {
    std::string text;  // of one line
    for (const auto& line : split(xml_from_list(**list, 0), "\n")) text += trimmed(line);
    values.emplace_back(path, brief(text));
  } else {
    values.emplace_back(path, brief(with_unit(value_text(p), p.unit)));
  }
}

}  // namespace

void ParameterWalk::visit(const Parameter& p) {
  if (parameter) parameter(path(p.name), p);
}

void ParameterWalk::visit(const Subsection& section, const std::function<void()>& declare) {
  if (!section.chosen) return;
  const std::string outer = path_;
  if (!section.name.empty()) path_ = path(section.name);
  declare();
  path_ = outer;
}

void ParameterWalk::visit(const Family& members) {
  if (family) family(path(members.name), members.names);
  const std::string outer = path_;
  for (const std::string& name : members.names) {
    path_ = (outer.empty() ? "" : outer + " > ") + members.name + " > " + name;
    members.declare(name);
  }
  path_ = outer;
}

void ParameterWalk::wonder(const std::string& name, const std::string& value, const std::string& why,
                           const std::string& advice) {
  if (doubt) doubt(path(name), value, why, advice);
}

SceneValues scene_values(const Scene& scene, const std::function<std::string(const std::string& file)>& content) {
  Scene copy = scene;
  for (auto& load : copy.loads)
    for (const auto& file : load.files())
      if (!file.file->empty()) *file.file = content(*file.file);
  SceneValues values;
  ParameterWalk walk;
  walk.parameter = [&](const std::string& path, const Parameter& p) { add(values, path, p); };
  walk.family = [&](const std::string& path, const std::vector<std::string>& names) {
    std::string all;
    for (const auto& name : names) all += (all.empty() ? "" : ", ") + in_quotes(name);
    if (!names.empty()) values.emplace_back(path, brief(all));
  };
  declare(copy, walk);
  Internals usual;
  SceneValues as_usual, internals;
  walk.parameter = [&](const std::string& path, const Parameter& p) { add(as_usual, path, p); };
  declare_internals(usual, walk);
  walk.parameter = [&](const std::string& path, const Parameter& p) { add(internals, path, p); };
  declare_internals(copy.internals, walk);
  for (std::size_t k = 0; k < internals.size(); ++k)
    if (internals[k] != as_usual[k]) values.push_back(internals[k]);
  return values;
}

}  // namespace voussoir
