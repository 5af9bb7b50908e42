#include "loads/time_series.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>

#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"

namespace voussoir {
namespace {

constexpr std::size_t most_rows = 10'000'000;    // a day at 100 Hz; more is no record of a bridge
constexpr std::size_t longest_heading = 10'000;  // lines kept of a heading, which is read for its units alone
constexpr std::size_t longest_line = 80;         // letters of a line that a message shows
constexpr std::size_t lines_of_at2 = 10;         // PEER's heading has four lines

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// A line of numbers, or what is wrong with it.
struct Row {
  std::vector<double> numbers;
  std::string problem;
};

bool digit_at(const std::string& text, std::size_t at) {
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

/// Some comma stands between two digits.
bool comma_within_number(const std::string& text) {
  for (std::size_t at = 1; at < text.size(); ++at)
    if (text[at] == ',' && digit_at(text, at - 1) && digit_at(text, at + 1)) return true;
  return false;
}

bool holds(const std::string& line, char c) { return line.find(c) != std::string::npos; }

/// Whether commas of a line seem to be those of decimals.
/// @param alone   lines hold values alone, so that nothing but its form tells 0,5 from two numbers
/// @param spread  some field between separators holds more than one number
bool has_decimal_commas(const std::string& line, bool alone, bool spread) {
  if (!holds(line, ',')) return false;
  if (holds(line, ';')) return true;
  return comma_within_number(line) && (spread || (alone && !holds(line, '.')));
}

/// @param alone  lines hold values alone
Row row_of(const std::string& line, bool alone) {
  const std::string decimal = "has commas in its numbers, it seems, where points are read";
  if (has_decimal_commas(line, alone, false)) return {{}, decimal};
  Row row;
  const auto fields = split(line, holds(line, ';') ? ";" : ",");
  bool spread = false;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (trimmed(fields[k]).empty() && k > 0 && k + 1 == fields.size()) break;  // a separator that ends the line
    const auto numbers = numbers_in(fields[k]);
    if (!numbers) return {{}, "holds what is no number"};
    if (numbers->empty()) return {{}, "has an empty field"};
    spread |= numbers->size() > 1;
    row.numbers.insert(row.numbers.end(), numbers->begin(), numbers->end());
  }
  if (has_decimal_commas(line, alone, spread)) return {{}, decimal};
  for (const double number : row.numbers)
    if (!std::isfinite(number)) return {{}, "holds a number that is not finite"};
  return row;
}

/// The first number of a text behind a word, without regard to signs of equality and blanks between.
std::optional<double> number_behind(const std::string& text, const std::string& word) {
  auto at = text.find(word);
  if (at == std::string::npos) return {};
  at = text.find_first_not_of(" =:\t", at + word.size());
  if (at == std::string::npos) return {};
  const auto end = text.find_first_not_of("0123456789.+-E", at);
  return number_in(text.substr(at, end == std::string::npos ? end : end - at));
}

/// What the line "NPTS= 200, DT= .01000 SEC", or "200 .01 NPTS, DT" of older files, says.
struct AtTwo {
  double values = 0, time_step = 0;  ///< number of values, [s]
};

std::optional<AtTwo> heading_of_at2(const std::string& line) {
  const std::string text = upper(line);
  if (text.find("NPTS") == std::string::npos || text.find("DT") == std::string::npos) return {};
  const auto count = number_behind(text, "NPTS"), step = number_behind(text, "DT");
  if (count && step) return AtTwo{*count, *step};
  const auto before = numbers_in(text.substr(0, std::min(text.find("NPTS"), text.find("DT"))));
  if (before && before->size() == 2) return AtTwo{(*before)[0], (*before)[1]};
  return AtTwo{};
}

/// One file on its way to times and values.
class Reading {
 public:
  Reading(const std::string& file, const RecordLayoutParameters& layout, const ValueColumn& column,
          const std::string& where)
      : file_(file), where_(where), p_(layout), column_(column), in_(file) {
    if (!in_) refuse("cannot be read", "Give the path of a file of numbers");
  }

  TimeSeries all() {
    for (std::string text; std::getline(in_, text);)  // one of several lines where they end in "\r" alone
      for (const auto& line : text.empty() ? std::vector<std::string>{text} : lines_of(text)) read(line);
    if (p_.layout == RecordLayout::peer_at2 && !at2_) refuse_heading();
    if (series_.value.empty()) refuse("holds no rows of numbers", "Write rows like \"0.01, -0.23\"");
    finish();
    return std::move(series_);
  }

 private:
  void read(std::string text) {
    ++number_;
    std::replace(text.begin(), text.end(), '\t', ' ');
    line_ = trimmed(text);
    if (number_ == 1 && line_.rfind("\xEF\xBB\xBF", 0) == 0) line_ = trimmed(line_.substr(3));  // mark of UTF-8
    if (line_.empty()) return;
    if (heading_ && is_heading()) {
      if (series_.heading.size() < longest_heading) series_.heading.push_back(line_);
      return;
    }
    if (line_[0] == '#') return;
    heading_ = false;
    take();
    if (series_.value.size() > most_rows) refuse("has more than ten million rows", "Resample it");
  }

  [[noreturn]] void refuse(const std::string& why, const std::string& advice) const {
    throw InputError(where_ + " = " + in_quotes(file_) + "\n  " + why + ".\n  " + advice + ".");
  }
  std::string here() const { return "line " + std::to_string(number_); }
  std::string shown() const { return in_quotes(shortened(line_, longest_line)); }

  /// The line belongs to what stands above the numbers.
  bool is_heading() {
    if (p_.layout == RecordLayout::peer_at2) {
      if (at2_) return false;
      at2_ = heading_of_at2(line_);
      if (!at2_ && static_cast<std::size_t>(number_) >= lines_of_at2) refuse_heading();
      return true;
    }
    if (number_ <= p_.header_lines || line_[0] == '#') return true;
    if (std::string("+-.0123456789").find(line_[0]) != std::string::npos) return false;
    const auto numbers = numbers_in(line_);  // "nan, 2" is no heading
    return !numbers || numbers->empty();
  }

  [[noreturn]] void refuse_heading() const {
    refuse("must begin with the heading of an AT2 file, whose last line is like \"NPTS= 4000, DT= .0050 SEC\"",
           "Give the layout of the file as it is: time and value, or values with a record time step");
  }

  static constexpr auto advice_of_at2 = "Its heading is that of PEER's AT2 files, values alone: give layout = peer at2";

  bool looks_like_at2() const {
    std::ifstream in(file_);
    std::string line;
    for (std::size_t k = 0; k < lines_of_at2 && std::getline(in, line); ++k)
      if (heading_of_at2(line)) return true;
    return false;
  }

  void take() {
    const bool alone = p_.layout != RecordLayout::time_and_value;
    const auto row = row_of(line_, alone);
    if (alone) {
      if (!row.problem.empty())
        refuse(here() + " must hold values alone, finite numbers between blanks or commas, but " + row.problem + ": " +
                   shown(),
               "Write points in numbers; name lines that are no values with header lines");
      series_.value.insert(series_.value.end(), row.numbers.begin(), row.numbers.end());
      return;
    }
    const std::size_t width = p_.time_column > 0 ? std::max(p_.time_column, column_.number) : 2;
    if (!row.problem.empty())
      refuse(here() + " must hold " + counted(width, "finite number") +
                 (p_.time_column > 0 ? " or more" : ", the time [s] and its value") + ", but is " + shown() +
                 ", which " + row.problem,
             looks_like_at2() ? advice_of_at2 : "Write rows like \"0.01, -0.23\", and a # before lines that are none");
    if (p_.time_column == 0 && row.numbers.size() != 2) refuse_width(row.numbers.size());
    if (row.numbers.size() < width)
      refuse(here() + " must hold " + counted(width, "number") + " or more, as time column = " +
                 std::to_string(p_.time_column) + " and " + column_.key + " = " + std::to_string(column_.number) +
                 " ask for, but holds " + std::to_string(row.numbers.size()) + ": " + shown(),
             "Count the columns from 1");
    if (width_ == 0) width_ = row.numbers.size();
    if (row.numbers.size() != width_)
      refuse(here() + " must hold " + counted(width_, "number") + " like the rows above it, but holds " +
                 std::to_string(row.numbers.size()) + ": " + shown(),
             "Fill in what is missing, or its columns are not those of the others");
    const auto take = [&](int column, int otherwise) {
      return row.numbers[static_cast<std::size_t>((column > 0 ? column : otherwise) - 1)];
    };
    append(take(p_.time_column, 1), take(column_.number, 2));
  }

  [[noreturn]] void refuse_width(std::size_t count) const {
    const std::string values =
        "where a line holds values one after the other give layout = values with their record time step";
    const std::string columns =
        "Where rows have more columns name those that count, such as time column = 2 and " + column_.key + " = 3; ";
    refuse(here() + " must hold two numbers, the time [s] and its value, but holds " + std::to_string(count) + ": " +
               shown(),
           looks_like_at2() ? advice_of_at2
           : count > 2      ? columns + values
                            : "Write rows like \"0.01, -0.23\"; " + values);
  }

  void append(double time, double value) {
    auto& known = series_.time;
    if (!known.empty() && time <= known.back())
      refuse("must have rising times, but row " + std::to_string(known.size() + 1) + " is at " + number_text(time) +
                 " s after " + number_text(known.back()) + " s (" + here() + ")",
             comma_within_number(line_) && line_.find('.') == std::string::npos
                 ? "Sort the rows, and keep one for each time; or write points where commas begin decimals"
                 : "Sort the rows, and keep one for each time");
    known.push_back(time);
    series_.value.push_back(value);
  }

  /// Times of values that stand alone.
  void finish() {
    double step = p_.time_step;
    if (p_.layout == RecordLayout::peer_at2) {
      step = at2_->time_step;
      const double count = at2_->values;
      if (!(step > 0 && std::isfinite(step)) || !(count >= 1))
        refuse(
            "must tell in its heading how many values there are and the time between them, like \"NPTS= 4000, DT= "
            ".0050 SEC\"",
            "Mend the heading, or take it off and give layout = values with their record time step");
      if (count != static_cast<double>(series_.value.size()))
        refuse("must hold as many values as its heading says, NPTS = " + number_text(count) + ", but holds " +
                   std::to_string(series_.value.size()),
               "Fetch the file again, it may have been cut; or mend its heading");
    }
    if (p_.layout == RecordLayout::time_and_value) return;
    for (std::size_t k = 0; k < series_.value.size(); ++k) series_.time.push_back(static_cast<double>(k) * step);
    if (!std::isfinite(series_.time.back()))
      refuse("must last a time that can be told, but the step between its values is " + number_text(step) + " s",
             "Give the time between two values");
  }

  const std::string &file_, &where_;
  const RecordLayoutParameters& p_;
  const ValueColumn& column_;
  std::ifstream in_;
  long number_ = 0;  ///< of the line
  bool heading_ = true;
  std::string line_;
  std::size_t width_ = 0;  ///< numbers in a row
  std::optional<AtTwo> at2_;
  TimeSeries series_;
};

}  // namespace

TimeSeries read_time_series(const std::string& file, const RecordLayoutParameters& layout, const ValueColumn& column,
                            const std::string& where, const Teuchos::Comm<int>& comm) {
  TimeSeries series;
  on_first_rank(comm, [&] { series = Reading(file, layout, column, where).all(); });
  broadcast_values(comm, series.time);
  broadcast_values(comm, series.value);
  broadcast_strings(comm, series.heading);
  return series;
}

}  // namespace voussoir
