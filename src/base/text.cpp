#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "base/words.hpp"

namespace voussoir {
namespace {

/// As words are compared: small letters, blanks for what joins words.
std::string plain(const std::string& word) {
  std::string text = in_small_letters(word);
  for (char& c : text)
    if (c == '_' || c == '-') c = ' ';
  return text;
}

/// Edits that turn a into b: letters inserted, left out, replaced, or two neighbours exchanged.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

template <class Number>
std::optional<Number> parsed(std::string text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.erase(0, 1);
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return number;
}

}  // namespace

std::string six_digits(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string place_in_words(double coordinate) {
  std::ostringstream text;
  if (std::abs(coordinate) >= 1e4) text.precision(10);
  text << coordinate;
  return text.str();
}

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string three_digits(double value) { return formatted("%.3g", value); }

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char buffer[40];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  const auto e = text.find('e');
  if (e == std::string::npos) return text;
  std::string exponent = text.substr(e + 1);
  const bool negative = exponent[0] == '-';
  exponent.erase(0, exponent.find_first_not_of("+-0"));
  return text.substr(0, e) + (negative ? "e-" : "e") + exponent;
}

std::optional<double> number_in(const std::string& text) { return parsed<double>(text); }
std::optional<int> whole_number_in(const std::string& text) { return parsed<int>(text); }

std::optional<std::vector<double>> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  std::size_t from = 0;
  while ((from = text.find_first_not_of(", \t\r\n", from)) != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(", \t\r\n", from), text.size());
    const auto number = number_in(text.substr(from, end - from));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    from = end;
  }
  return numbers;
}

std::optional<bool> truth_in(const std::string& text) {
  const std::string word = in_small_letters(trimmed(text));
  if (word == "true" || word == "yes" || word == "1") return true;
  if (word == "false" || word == "no" || word == "0") return false;
  return std::nullopt;
}

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 200;  // letters; a longer word is no mistyped key, and comparing costs its square
  if (word.empty() || word.size() > longest) return "";
  const std::string wanted = plain(word);
  std::string best;
  std::size_t least = std::max<std::size_t>(2, wanted.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest) continue;
    const std::string known = plain(candidate);
    std::size_t distance = edit_distance(wanted, known);
    if (wanted.size() >= 3 && known.find(wanted) != std::string::npos) distance = std::min<std::size_t>(distance, 2);
    if (known.size() >= 3 && wanted.find(known) != std::string::npos) distance = std::min<std::size_t>(distance, 2);
    if (distance >= least || distance >= std::max(wanted.size(), known.size())) continue;
    least = distance;
    best = candidate;
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string best = nearest(word, candidates);
  return best.empty() ? "" : " (did you mean " + in_quotes(best) + "?)";
}

std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;  // whole letters of UTF-8
  return text.substr(0, end) + "...";
}

std::string in_quotes(const std::string& text) {
  constexpr std::size_t longest = 400;  // bytes; a longer value would hide its message
  return '"' + shortened(text, longest) + '"';
}

std::string list_of(const std::vector<std::string>& words, std::size_t most) {
  if (words.empty()) return "none";
  std::string text = words.front();
  for (std::size_t i = 1; i < std::min(most, words.size()); ++i) text += ", " + words[i];
  if (words.size() > most) text += " and " + std::to_string(words.size() - most) + " more";
  return text;
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return "\n  " + text + (text.back() == '.' ? "" : ".");
}

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> pieces;
  std::size_t from = 0;
  for (std::size_t to; (to = text.find(separator, from)) != std::string::npos; from = to + separator.size())
    pieces.push_back(text.substr(from, to - from));
  pieces.push_back(text.substr(from));
  return pieces;
}

LineEnd end_of_line(const std::string& text, std::size_t from) {
  const std::size_t end = std::min(text.find_first_of("\r\n", from), text.size());
  return {end, std::min(end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1), text.size())};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const auto [end, next] = end_of_line(text, from);
    lines.push_back(text.substr(from, end - from));
    from = next;
  }
  return lines;
}

namespace {

/// Bytes of UTF-8 that follow a first one beyond ASCII; 0 where nothing begins so.
std::size_t bytes_that_follow(unsigned char lead) {
  if (lead >= 0xc2 && lead < 0xe0) return 1;
  if (lead >= 0xe0 && lead < 0xf0) return 2;
  return lead >= 0xf0 && lead < 0xf5 ? 3 : 0;
}

/// Whether a character of so many further bytes is one of Unicode, in as few bytes as it needs.
bool is_character(unsigned code, std::size_t follow) {
  constexpr unsigned least[] = {0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code >= least[follow] && code <= 0x10ffff && !surrogate;
}

}  // namespace

bool is_plain_text(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead < 0x20 || lead == 0x7f) return false;
    if (lead < 0x80) continue;
    const std::size_t follow = bytes_that_follow(lead);
    if (follow == 0 || i + follow >= text.size()) return false;
    unsigned code = lead & (0x3fu >> follow);
    for (std::size_t k = 1; k <= follow; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      if ((next & 0xc0u) != 0x80u) return false;
      code = code << 6 | (next & 0x3fu);
    }
    if (!is_character(code, follow)) return false;
    i += follow;
  }
  return true;
}

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

}  // namespace voussoir
