#include "loads/record_layout_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {

namespace {

constexpr int most_columns = 1000;         // far more than tables of records have
constexpr double most_header_lines = 1e5;  // lines

}  // namespace

void RecordLayoutParameters::declare(ParameterSection& section) {
  section.add_choice<RecordLayout>("layout", layout,
                                   {{"time and value", RecordLayout::time_and_value},
                                    {"values", RecordLayout::values},
                                    {"peer at2", RecordLayout::peer_at2}},
                                   "of the file: a row for each time; values alone, however many a line, at equal "
                                   "times; values below a heading with NPTS and DT");
  section.add("header lines", header_lines, "-", between(0, most_header_lines),
              "left out at the top of the file; those that begin with neither digit, sign nor point are anyway");
  section.add("time column", time_column, "-", between(0, most_columns),
              "of longer rows, from 1; 0: rows hold two numbers, the time [s] and the value");
  section.add("record time step", time_step, "s", at_least(0),
              "between values where layout = values; the first is at 0");
}

void RecordLayoutParameters::check(ParameterSection& section, const std::vector<ValueColumn>& columns) const {
  const bool rows = layout == RecordLayout::time_and_value;
  const bool timed = layout == RecordLayout::values;
  section.check(timed == (time_step > 0), "record time step", number_text(time_step) + " s",
                timed ? "must be > 0 (values alone do not tell their times)"
                      : "must be 0 (layout = values alone takes its times from it)",
                timed ? "Give the time between two values" : "Leave it out, or give layout = values");
  section.check(layout != RecordLayout::peer_at2 || header_lines == 0, "header lines", std::to_string(header_lines),
                "must be 0 (the heading of an AT2 file tells how many values follow)", "Leave it out");
  section.check(rows || time_column == 0, "time column", std::to_string(time_column),
                "must be 0 (only layout = time and value has columns)", "Leave it out");
  for (const auto& c : columns) {
    const std::string number = std::to_string(c.number);
    section.check(rows || c.number == 0, c.key, number, "must be 0 (only layout = time and value has columns)",
                  "Leave it out");
    if (!rows || !c.in_use) continue;
    section.check((c.number > 0) == (time_column > 0), c.key, number,
                  c.number > 0 ? "must have a time column beside it (rows of more than two numbers need both)"
                               : "must be > 0 where a time column is given",
                  "Give the numbers of both columns, the first being 1");
    section.check(c.number == 0 || c.number != time_column, c.key, number,
                  "must be another than time column (a time is no value)", "Count columns from 1");
  }
}

}  // namespace voussoir
