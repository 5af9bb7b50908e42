#include "output/history.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/error.hpp"
#include "linalg/agree.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

std::string field(long long number) { return std::to_string(number); }
std::string field(int number) { return std::to_string(number); }

/// The shortest text that reads back as the same number; nothing for one that is not finite.
std::string field(double number) {
  if (!std::isfinite(number)) return "";
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// Quoted when it has to be (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// Fields of a line as they are written, with their quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    quoted ^= c == '"';
    if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

/// A line under another heading: what it has of each column, nothing where it has none.
std::string moved(const std::string& line, const std::vector<std::string>& from, const std::vector<std::string>& to) {
  const auto fields = fields_of(line);
  std::string text;
  for (std::size_t k = 0; k < to.size(); ++k) {
    const auto column = static_cast<std::size_t>(std::find(from.begin(), from.end(), to[k]) - from.begin());
    text += (k == 0 ? "" : ",") + (column < fields.size() ? fields[column] : "");
  }
  return text;
}

/// Names of columns and values of a row, in their order: terms of the energy book stand before what it leaves.
template <class Add>
void each_column(const HistoryRow& row, const Add& add) {
  add("step", field(row.step));
  add("stage", field(row.stage));
  add("load_factor", field(row.load_factor));
  add("time_s", field(row.time));
  each_number(
      [&](const char*, const std::string& name, OverSteps, const auto& value) {
        if (name.find('.') == std::string::npos) add(name, field(value));
      },
      row);
  for (const auto& term : energy_terms) add(term.name, field(row.energy.*term.value));
  add("imbalance_J", field(row.imbalance));
  add("imbalance_in_time_J", field(row.imbalance_in_time));
  add("largest_displacement_m", field(row.largest_displacement));
  add("seconds", field(row.seconds));
}

}  // namespace

std::string History::heading(const std::vector<std::string>& further) {
  std::string line;
  each_column({}, [&](const std::string& name, const std::string&) { line += (line.empty() ? "" : ",") + name; });
  for (std::string name : further) {
    // A name may hold anything; a row is a line.
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    line += ',' + field(name);
  }
  return line;
}

History::History(std::string path, Teuchos::RCP<const Teuchos::Comm<int>> comm, int rows,
                 const std::vector<std::string>& further)
    : path_(std::move(path)), comm_(std::move(comm)) {
  on_first_rank(*comm_, [&] {
    const std::string now = heading(further);
    std::string kept = now + '\n', line, then;
    std::ifstream before(path_);
    if (rows > 0) std::getline(before, then);
    for (int k = 0; k < rows && std::getline(before, line); ++k)
      kept += (then == now ? line : moved(line, fields_of(then), fields_of(now))) + '\n';
    before.close();
    replace_file(path_, kept);
    file_.open(path_, std::ios::app);
    if (!file_) throw ResourceError(cannot_write(path_, std::strerror(errno)));
  });
}

void History::append(const HistoryRow& row) {
  on_first_rank(*comm_, [this, &row] {
    std::string line;
    each_column(
        row, [&](const std::string& name, const std::string& value) { line += (name == "step" ? "" : ",") + value; });
    for (const double value : row.observed) line += ',' + field(value);
    put(line);
  });
}

void History::put(const std::string& line) {
  if (file_ << line << '\n' << std::flush) return;
  throw ResourceError(cannot_write(path_, std::strerror(errno)));
}

}  // namespace voussoir
