// Words and numbers as people write and read them, the same for messages, scenes and the command line.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace voussoir {

/// With six digits, which is what a factor or a share can be worth.
std::string six_digits(double);
/// A coordinate [m]: far from the origin with digits enough to find the place.
std::string place_in_words(double coordinate);
/// "(1, 0.5) m"
template <std::size_t dim>
std::string place_in_words(const std::array<double, dim>& place) {
  std::string text;
  for (const double x : place) text += (text.empty() ? "(" : ", ") + place_in_words(x);
  return text + ") m";
}
/// A number as a printf format writes it: formatted("%.3f m", 0.5).
std::string formatted(const char* format, double);
/// With the digits a reader can use.
std::string three_digits(double);
/// The shortest text that reads back as exactly the same double: "0.1", "2e10", "inf".
std::string number_text(double);
/// A place or a force as people write it: "(1, 0.5)".
template <std::size_t n>
std::string vector_text(const std::array<double, n>& vector) {
  std::string text;
  for (const double x : vector) text += (text.empty() ? "(" : ", ") + number_text(x);
  return text + ")";
}

/// The whole text as a number; nothing when any part of it is not. Infinities and NaN are numbers here.
std::optional<double> number_in(const std::string&);
/// Numbers separated by commas or blanks; nothing when any of them is none.
std::optional<std::vector<double>> numbers_in(const std::string&);
std::optional<int> whole_number_in(const std::string&);
/// true, yes, 1 or false, no, 0 in any case of letters.
std::optional<bool> truth_in(const std::string&);

/// The candidate a mistyped word most likely stands for, or "" when none resembles it.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);
/// ` (did you mean "density"?)`, or "" when no candidate resembles the word.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

/// At most `longest` bytes of a text, whole letters, with dots where it is cut.
std::string shortened(const std::string&, std::size_t longest);
/// The text between quotation marks, shortened when it is very long.
std::string in_quotes(const std::string&);
/// `a, b, c`, cut after `most` words; "none" when there are none.
std::string list_of(const std::vector<std::string>& words, std::size_t most = 20);
/// A line of a message: new line, two blanks, a capital, a full stop; "" for an empty text.
std::string sentence(std::string);
std::string trimmed(const std::string&);
std::vector<std::string> split(const std::string&, const std::string& separator);
/// Where a line of a text ends that begins at a place, and where the next one begins: at "\n", "\r\n", or "\r" alone.
struct LineEnd {
  std::size_t end, next;
};
LineEnd end_of_line(const std::string&, std::size_t from);
/// All lines of a text.
std::vector<std::string> lines_of(const std::string&);

/// Valid UTF-8 without control characters, so that every program that reads our files can show it.
bool is_plain_text(const std::string&);
/// Text as the value of an XML attribute.
std::string xml_escaped(const std::string&);

}  // namespace voussoir
