#include "mesh/geo_commands.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/file_ending.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

// Longer texts between quotation marks gmsh cuts, and takes the rest for commands.
constexpr std::size_t longest_string = 1023;

struct Command {
  const char *word, *does;
};
constexpr auto runs = "runs programs", files = "reads or writes other files",
               ends_gmsh = "ends gmsh before it has meshed";
constexpr Command commands[] = {
    {"System", runs},
    {"SystemCall", runs},
    {"NonBlockingSystemCall", runs},
    {"OnelabRun", runs},
    {"ExternalProcess", runs},
    {"Include", files},
    {"Merge", files},
    {"MergeWithBoundingBox", files},
    {"Save", files},
    {"Print", files},
    {"CreateDir", files},
    {"SendToServer", files},
    {"ShapeFromFile", files},
    {"ListFromFile", files},
    {"Plugin", files},
    {"Exit", ends_gmsh},
};
constexpr const char* printing[] = {"Printf", "Error", "Warning"};  // > "file" and >> "file" behind them write files

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_of_word(char c) { return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Where a word stands, from a place on; digits before it belong to a number.
std::size_t find_word(const std::string& code, const std::string& word, std::size_t from) {
  for (std::size_t at = code.find(word, from); at != std::string::npos; at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_letter(code[at - 1])) && (end == code.size() || !is_of_word(code[end]))) return at;
  }
  return std::string::npos;
}

std::size_t next_sign(const std::string& code, std::size_t at) {
  while (at < code.size() && is_blank(code[at])) ++at;
  return at;
}

/// Behind the parenthesis that closes the one at a place.
std::size_t behind_parentheses(const std::string& code, std::size_t at) {
  int depth = 0;
  for (; at < code.size(); ++at) {
    depth += (code[at] == '(') - (code[at] == ')');
    if (depth == 0) return at + 1;
  }
  return at;
}

std::string in_line(const std::string& code, std::size_t at, const std::string& what) {
  const auto lines = std::count(code.begin(), code.begin() + static_cast<long>(at), '\n');
  return "line " + std::to_string(lines + 1) + " has " + what;
}

/// A category of options (Print.Text = 0) or a variable of that name is no command.
bool is_command(const std::string& code, std::size_t end) {
  const std::size_t next = next_sign(code, end);
  if (next == code.size()) return true;
  const bool assigned = code[next] == '=' && (next + 1 == code.size() || code[next + 1] != '=');
  return code[next] != '.' && !assigned;
}

std::string writes_a_file(const std::string& code) {
  for (const std::string word : printing)
    for (std::size_t at = find_word(code, word, 0); at != std::string::npos; at = find_word(code, word, at + 1)) {
      const std::size_t open = next_sign(code, at + word.size());
      if (open == code.size() || code[open] != '(') continue;
      const std::size_t next = next_sign(code, behind_parentheses(code, open));
      if (next < code.size() && code[next] == '>') return in_line(code, at, word + " into a file, which " + files);
    }
  return "";
}

/// Options that name files or programs, Field[1].FileName = "...".
std::string names_a_file(const std::string& code) {
  for (const auto& [ending, does] : {Command{"FileName", files}, Command{"CommandLine", runs}})
    for (std::size_t at = code.find(ending); at != std::string::npos; at = code.find(ending, at + 1)) {
      const std::size_t end = at + std::string(ending).size();
      if (end < code.size() && is_of_word(code[end])) continue;
      std::size_t begin = at;
      while (begin > 0 && is_of_word(code[begin - 1])) --begin;
      while (begin > 0 && is_blank(code[begin - 1])) --begin;
      if (begin > 0 && code[begin - 1] == '.') return in_line(code, at, std::string(ending) + ", which " + does);
    }
  return "";
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// gmsh knows a mesh by its first line; anything else it carries out as a script.
bool begins_as_mesh(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::getline(file, line);
  for (const char* start : {"$MeshFormat", "$Comments", "$NO", "$PTS", "$ELM", "$PARA"})
    if (line.rfind(start, 0) == 0) return true;
  return false;
}

}  // namespace

std::string without_comments(const std::string& text, Strings strings) {
  std::string rest;
  const auto skip = [&](std::size_t& at, std::size_t end, bool keep) {  // lines stay lines
    for (end = std::min(end, text.size()); at < end; ++at)
      if (keep || text[at] == '\n') rest += text[at];
    --at;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (text.compare(i, 2, "//") == 0) {
      skip(i, text.find('\n', i), false);
    } else if (text.compare(i, 2, "/*") == 0) {
      rest += ' ';
      const auto end = text.find("*/", i + 2);
      skip(i, end == std::string::npos ? end : end + 2, false);
    } else if (c == '"' || c == '\'') {
      const auto end = text.find(c, i + 1);
      if (strings == Strings::blank) rest += "\"\"";
      skip(i, end == std::string::npos ? end : end + 1, strings == Strings::kept);
    } else {
      rest += c;
    }
  }
  return rest;
}

std::string forbidden_command(const std::string& text) {
  if (text.find('\0') != std::string::npos) return "it has a letter of number 0, at which gmsh ends comments and texts";
  const std::string code = without_comments(text, Strings::blank);
  const std::string with_strings = without_comments(text, Strings::kept);
  for (std::size_t i = 0; i < with_strings.size(); ++i) {
    if (with_strings[i] != '"' && with_strings[i] != '\'') continue;
    const auto end = std::min(with_strings.find(with_strings[i], i + 1), with_strings.size());
    if (end - i > longest_string) return "it has a text of more than 1023 letters, whose end gmsh takes for commands";
    i = end;
  }
  std::size_t first = std::string::npos;
  std::string found;
  for (const auto& [word, does] : commands)
    for (std::size_t at = find_word(code, word, 0); at != std::string::npos; at = find_word(code, word, at + 1))
      if (at < first && is_command(code, at + std::string(word).size())) {
        first = at;
        found = in_line(code, at, std::string(word) + ", which " + does);
      }
  if (found.empty()) found = writes_a_file(code);
  return found.empty() ? names_a_file(code) : found;
}

void refuse_commands(const std::string& file, const std::string& path) {
  const std::string trust = "If the file is yours, or you trust who made it, say --trust.";
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  if (lower_ending(path) == ".msh") {
    if (!begins_as_mesh(path))
      refuse_mesh("gmsh > file", file, "does not begin with $MeshFormat, so it is no mesh.", "Save it anew in gmsh.");
    if (const std::string beside = path + ".opt"; std::filesystem::exists(beside, error))
      refuse_mesh("gmsh > file", file,
                  "has options of gmsh beside it, " + beside + ", which are carried out like a script.",
                  "Take them away. " + trust);
    return;
  }
  const std::string what = forbidden_command(contents(path));
  if (what.find(ends_gmsh) != std::string::npos) refuse_mesh("gmsh > file", file, what + ".", "Take it out.");
  if (!what.empty())
    refuse_mesh("gmsh > file", file, what + " (drawings of strangers must not, and none needs it).",
                "Take it out, or draw what it brings in the file itself. " + trust);
}

}  // namespace voussoir
