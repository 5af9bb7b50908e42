#include "performance/count_table.hpp"
#include "support/repository.hpp"

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace voussoir::test {
namespace {

const std::string table = repository("/tests/performance/solve_counts.csv");
constexpr auto head = "scene,solves,krylov,whole,patches";

std::string difference(const char* name, const Range& kept, long long counted) {
  const std::string text = std::string(name) + " " + std::to_string(counted);
  const bool there = kept.least <= counted && counted <= kept.most;
  return there ? text : text + " (kept: " + kept.text() + ")";
}

/// "6", "6-8" or "~12-197"; false for any other text.
bool read(const std::string& field, Range& range) {
  const char *at = field.data(), *const end = at + field.size();
  range.jumps = at != end && *at == '~';
  const auto number = [&](long long& n) {
    const auto parsed = std::from_chars(at, end, n);
    at = parsed.ptr;
    return parsed.ec == std::errc();
  };
  at += range.jumps;
  if (!number(range.least)) return false;
  range.most = range.least;
  if (at != end && (*at++ != '-' || !number(range.most))) return false;
  return at == end && 0 <= range.least && range.least <= range.most;
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

std::string Range::text() const {
  const std::string bounds = std::to_string(least) + (most > least ? "-" + std::to_string(most) : "");
  return (jumps ? "~" : "") + bounds;
}

std::string CountRanges::text() const {
  return solves.text() + "," + krylov.text() + "," + whole.text() + "," + patches.text();
}

Change change_of(const Range& kept, long long counted) {
  if (kept.jumps) return counted > 2 * kept.most ? Change::more : Change::none;
  const auto beyond = [](long long bound, long long off) { return off > 1 && 10 * off > bound; };
  if (beyond(kept.most, counted - kept.most)) return Change::more;
  return beyond(kept.least, kept.least - counted) ? Change::fewer : Change::none;
}

Change change_of(const CountRanges& kept, const Counts& counted) {
  const Change changes[] = {change_of(kept.solves, counted.solves), change_of(kept.krylov, counted.krylov),
                            change_of(kept.whole, counted.whole), change_of(kept.patches, counted.patches)};
  bool fewer = false;
  for (const Change change : changes) {
    if (change == Change::more) return change;
    fewer = fewer || change == Change::fewer;
  }
  return fewer ? Change::fewer : Change::none;
}

std::map<std::string, CountRanges> read_counts(const std::string& csv) {
  std::map<std::string, CountRanges> rows;
  std::istringstream lines(csv);
  std::string line;
  bool headed = false;
  while (std::getline(lines, line)) {
    if (!line.empty() && line.front() == '#') continue;
    if (!headed && line != head) break;
    if (!std::exchange(headed, true)) continue;
    std::istringstream fields(line);
    std::vector<std::string> field;
    for (std::string one; std::getline(fields, one, ',');) field.push_back(one);
    CountRanges c;
    if (field.size() != 5 || line.back() == ',' || field[0].empty() || !read(field[1], c.solves) ||
        !read(field[2], c.krylov) || !read(field[3], c.whole) || !read(field[4], c.patches) ||
        !rows.emplace(field[0], c).second)
      throw std::runtime_error(std::string(table) + ": the line \"" + line + "\" is no new scene with four counts");
  }
  if (!headed) throw std::runtime_error(std::string(table) + ": the first line must be " + head);
  return rows;
}

bool as_in_table(const std::string& scene, const Counts& counted, std::ostream& out) {
  std::ostringstream text;
  text << std::ifstream(table).rdbuf();
  const auto rows = read_counts(text.str());
  const auto row = rows.find(scene);
  const CountRanges kept = row == rows.end() ? CountRanges() : row->second;
  out << scene << ": " << difference("solves", kept.solves, counted.solves) << ", "
      << difference("krylov", kept.krylov, counted.krylov) << ", " << difference("whole", kept.whole, counted.whole)
      << ", " << difference("patches", kept.patches, counted.patches) << "\n";
  out << "  counted: " << scene << "," << counted.text() << "\n";
  const Change change = change_of(kept, counted);
  if (row != rows.end() && change == Change::none) return true;
  out << "  ";
  if (row == rows.end())
    out << "The scene is new.";
  else if (change == Change::more)
    out << "A count rose beyond what processors differ by. Is that the price of something wanted?";
  else
    out << "A count fell below what processors differ by: what is gained is kept.";
  out << " Then measure " << table << " anew: tests/performance/count_ranges.py\n";
  return false;
}

}  // namespace voussoir::test
