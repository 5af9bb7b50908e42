#include "mesh/gmsh_numbers.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "base/file_ending.hpp"
#include "mesh/geo_commands.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

/// Names on the left of an equals sign inside DefineConstant[ ... ];
std::set<std::string> defined_constants(const std::string& text) {
  std::set<std::string> names;
  static const std::regex assignment("([A-Za-z_][A-Za-z0-9_]*)\\s*=");
  for (std::size_t at = text.find("DefineConstant"); at != std::string::npos;
       at = text.find("DefineConstant", at + 1)) {
    const std::string statement = text.substr(at, text.find(';', at) - at);
    for (std::sregex_iterator it(statement.begin(), statement.end(), assignment), end; it != end; ++it)
      names.insert((*it)[1]);
  }
  return names;
}

/// A .geo without comments, and those it includes.
struct Code {
  std::string text;
  bool complete = true;  ///< all that it includes was found
};

void read_code(const std::filesystem::path& path, std::set<std::string>& seen, Code& code) {
  if (!seen.insert(path.lexically_normal().string()).second) return;
  std::ifstream file(path);
  std::ostringstream contents;
  contents << file.rdbuf();
  if (!file) code.complete = false;
  const std::string text = without_comments(contents.str(), Strings::kept);
  code.text += text + "\n";
  static const std::regex included("\\b(Include|Merge)\\b\\s*(\"([^\"]*)\")?");
  for (std::sregex_iterator it(text.begin(), text.end(), included), end; it != end; ++it) {
    const std::filesystem::path name((*it)[3].str());
    if (name.empty()) code.complete = false;  // a name that is computed
    // Other formats (.step, .brep, .msh) define no numbers.
    if (lower_ending(name.string()) == ".geo" || (*it)[1] == "Include")
      read_code(path.parent_path() / name, seen, code);
  }
}

/// Refuses a number that the geometry file cannot be given.
void check_number(const GmshParameters& p, const std::string& name, double value, const Code& code,
                  const std::set<std::string>& defined) {
  const bool in_geometry = p.geometry.count(name) > 0;
  const std::string key = in_geometry              ? "gmsh > geometry > " + name
                          : name == "element_size" ? "gmsh > element size"
                                                   : "gmsh > cells";
  const std::string shown = name == "recombine" && !in_geometry ? "quadrilateral" : in_words(value);
  if (!std::isfinite(value))
    refuse_mesh(key, shown, "must be a finite number.", "Give the value in the units of the file.");
  if (!std::regex_match(name, std::regex("[A-Za-z_][A-Za-z0-9_]*")))
    refuse_mesh(key, shown, "is no name a .geo file can have.", "Use letters, digits and _.");
  if (!code.complete || defined.count(name) > 0) return;
  std::string offered;
  for (const std::string& other : defined) offered += (offered.empty() ? "" : ", ") + other;
  refuse_mesh(key, shown,
              "cannot be set: " + p.file + " has no DefineConstant for " + name +
                  (offered.empty() ? "." : " (it has: " + offered + ")."),
              "Write DefineConstant[ " + name + " = ... ]; in the file and use the number there, or remove the key.");
}

}  // namespace

std::map<std::string, double> numbers_to_set(const GmshParameters& p, const std::string& path) {
  std::map<std::string, double> numbers = p.geometry;
  if (p.cells == CellType::quadrilateral) numbers["recombine"] = 1;

  Code code;
  std::set<std::string> seen;
  read_code(path, seen, code);
  const std::set<std::string> defined = defined_constants(code.text);
  if (p.element_size > 0 && (!code.complete || defined.count("element_size")))
    numbers["element_size"] = p.element_size / p.unit;
  for (const auto& [name, value] : numbers) check_number(p, name, value, code, defined);
  return numbers;
}

std::string geo_with_numbers(const std::map<std::string, double>& numbers, const std::string& absolute_path) {
  std::string text;
  for (const auto& [name, value] : numbers) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    text += name + " = " + digits + ";\n";
  }
  return text + "Include \"" + absolute_path + "\";\n";
}

}  // namespace voussoir
