#include "performance/count_table.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace voussoir::test {
namespace {

constexpr auto table = VOUSSOIR_SOURCE_DIR "/tests/performance/solve_counts.csv";
constexpr auto head = "scene,solves,krylov,whole,patches";

std::string difference(const char* name, long long kept, long long counted) {
  std::string text = std::string(name) + " " + std::to_string(kept);
  if (counted != kept) text += " -> " + std::to_string(counted);
  return text;
}

}  // namespace

void Counts::add(const Counts& more) {
  solves += more.solves;
  krylov += more.krylov;
  whole += more.whole;
  patches += more.patches;
}

std::string Counts::text() const {
  return std::to_string(solves) + "," + std::to_string(krylov) + "," + std::to_string(whole) + "," +
         std::to_string(patches);
}

Change change_of(long long kept, long long counted) {
  const long long off = counted - kept, size = off < 0 ? -off : off;
  if (size <= 1 || 10 * size <= kept) return Change::none;
  return off > 0 ? Change::more : Change::fewer;
}

Change change_of(const Counts& kept, const Counts& counted) {
  bool fewer = false;
  for (const auto count : {&Counts::solves, &Counts::krylov, &Counts::whole, &Counts::patches}) {
    const Change change = change_of(kept.*count, counted.*count);
    if (change == Change::more) return change;
    fewer = fewer || change == Change::fewer;
  }
  return fewer ? Change::fewer : Change::none;
}

std::map<std::string, Counts> read_counts(const std::string& csv) {
  std::map<std::string, Counts> rows;
  std::istringstream lines(csv);
  std::string line;
  if (!std::getline(lines, line) || line != head)
    throw std::runtime_error(std::string(table) + ": the first line must be " + head);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string scene;
    Counts c;
    char comma;
    std::getline(fields, scene, ',');
    fields >> c.solves >> comma >> c.krylov >> comma >> c.whole >> comma >> c.patches;
    if (!fields || fields.peek() != EOF || scene.empty() || !rows.emplace(scene, c).second)
      throw std::runtime_error(std::string(table) + ": the line \"" + line + "\" is no new scene with four counts");
  }
  return rows;
}

bool as_in_table(const std::string& scene, const Counts& counted, std::ostream& out) {
  std::ostringstream text;
  text << std::ifstream(table).rdbuf();
  const auto rows = read_counts(text.str());
  const auto row = rows.find(scene);
  const Counts kept = row == rows.end() ? Counts() : row->second;
  out << scene << ": " << difference("solves", kept.solves, counted.solves) << ", "
      << difference("krylov", kept.krylov, counted.krylov) << ", " << difference("whole", kept.whole, counted.whole)
      << ", " << difference("patches", kept.patches, counted.patches) << "\n";
  const Change change = change_of(kept, counted);
  if (row != rows.end() && change == Change::none) return true;
  if (row != rows.end() && change == Change::more)
    out << "  A count rose by more than a tenth. Where that is the price of something wanted, the line for " << table
        << " is:\n";
  else
    out << "  " << (row == rows.end() ? "The scene is new. " : "A count fell by more than a tenth. ") << "Put into "
        << table << ":\n";
  out << "  " << scene << "," << counted.text() << "\n";
  return false;
}

}  // namespace voussoir::test
