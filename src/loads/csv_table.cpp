#include "loads/csv_table.hpp"

#include <cctype>
#include <cmath>
#include <fstream>

#include "base/text.hpp"
#include "mesh/on_rank_zero.hpp"

namespace voussoir {
namespace {

constexpr std::size_t most_rows = 10'000'000;  // a day at 100 Hz; more is no record of a bridge

std::vector<double> read_rows(const std::string& file, std::size_t columns, const std::string& where) {
  const auto refuse = [&](const std::string& why, const std::string& advice) {
    throw InputError(where + " = " + in_quotes(file) + "\n  " + why + ".\n  " + advice + ".");
  };
  std::ifstream in(file);
  if (!in) refuse("cannot be read", "Give the path of a CSV file");
  std::vector<double> values;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    for (char& c : line)
      if (c == ';' || c == '\t' || c == '\r' || c == ',') c = ' ';
    line = trimmed(line);
    if (line.empty() || line[0] == '#' || std::isalpha(static_cast<unsigned char>(line[0]))) continue;
    const auto row = numbers_in(line);
    bool finite = row.has_value() && row->size() >= columns;
    for (std::size_t k = 0; finite && k < columns; ++k) finite = std::isfinite((*row)[k]);
    if (!finite)
      refuse("line " + std::to_string(number) + " must hold " + std::to_string(columns) + " finite numbers, but is " +
                 in_quotes(shortened(line, 80)),
             "Write rows like \"0.01, -0.23\"");
    values.insert(values.end(), row->begin(), row->begin() + static_cast<long>(columns));
    if (values.size() > most_rows * columns) refuse("has more than ten million rows", "Resample it");
  }
  if (values.empty()) refuse("holds no rows of numbers", "Write rows like \"0.01, -0.23\"");
  return values;
}

}  // namespace

CsvTable read_csv(const std::string& file, std::size_t columns, const std::string& where,
                  const Teuchos::Comm<int>& comm) {
  std::vector<double> values;
  on_rank_zero(comm, [&] { values = read_rows(file, columns, where); });
  broadcast_values(comm, values);
  CsvTable table;
  table.columns.resize(columns);
  for (std::size_t i = 0; i < values.size(); ++i) table.columns[i % columns].push_back(values[i]);
  return table;
}

}  // namespace voussoir
