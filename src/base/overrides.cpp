// Paths on the command line: how they are read, and what is said when they lead nowhere.
#include "base/parameter_reader.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

std::string as_typed(const std::string& path) {
  std::string typed;
  for (const std::string& piece : split(path, " > "))
    if (!(typed.empty() && piece == "scene")) typed += (typed.empty() ? "" : "/") + piece;
  return typed;
}

/// The known path most like one that leads nowhere: alike as a whole, or alike in its last key.
std::string nearest_path(const std::string& path, const std::vector<std::string>& known) {
  const std::string whole = nearest(path, known);
  if (!whole.empty()) return whole;
  std::vector<std::string> keys;
  for (const std::string& other : known) keys.push_back(split(other, " > ").back());
  const std::string key = nearest(split(path, " > ").back(), keys);
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (!key.empty() && keys[i] == key) return known[i];
  return "";
}

}  // namespace

Overrides read_overrides(const std::vector<std::string>& texts, InputProblems& problems) {
  Overrides overrides;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    std::string path, key = equals == std::string::npos ? "" : text.substr(0, equals);
    for (const std::string& raw : split(key, key.find(" > ") == std::string::npos ? "/" : " > ")) {
      const std::string piece = trimmed(raw);
      if (piece.empty() || (path.empty() && piece == "scene")) continue;
      path += " > " + piece;
    }
    if (path.empty() || !is_plain_text(text))
      problems.add("--set " + (is_plain_text(text) ? text : std::string("(not shown)")),
                   "\n  must be path=value in UTF-8 text.\n  For instance: --set selection/mode=all");
    else
      overrides["scene" + path] = trimmed(text.substr(equals + 1));
  }
  return overrides;
}

void ParameterReader::finish() {
  leave();
  for (const auto& [path, text] : overrides_) {
    if (used_.count(path)) continue;
    const std::string best = nearest_path(path, paths_);
    problems_.add("--set " + as_typed(path) + "=" + text,
                  "\n  names no parameter of this scene" +
                      (best.empty() ? std::string() : " (did you mean " + in_quotes(as_typed(best)) + "?)") +
                      ".\n  A path goes from section to key as in the scene, for instance selection/mode; a new "
                      "material, joint, support, load or stage must be written in the scene itself.");
  }
}

}  // namespace voussoir
