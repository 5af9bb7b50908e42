#include "stones/stone_text.hpp"

#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"

namespace voussoir {

void refuse_stones(const std::string& file, const std::string& why, const std::string& advice) {
  std::string shown;
  for (const auto& line : split(why, "\n")) shown += (shown.empty() ? "" : "\n") + as_utf8(line);
  throw InputError("mesh > stones > file = " + file + sentence(shown) + sentence(advice));
}

std::string as_utf8(const std::string& text) {
  std::string plain, letters;
  for (const char byte : text)
    if (static_cast<unsigned char>(byte) >= 0x20 && byte != 0x7f) plain += byte;
  if (is_plain_text(plain)) return plain;
  for (const char byte : plain) {
    const auto letter = static_cast<unsigned char>(byte);
    if (letter < 0x7f)
      letters += byte;
    else if (letter >= 0xa0)  // below are control characters of Latin-1
      letters += {static_cast<char>(0xc0 | (letter >> 6)), static_cast<char>(0x80 | (letter & 0x3f))};
  }
  return letters;
}

std::size_t begin_of_text(const std::string& file, const std::string& contents) {
  const auto is_zero = [&](std::size_t at) { return contents[at] == '\0'; };
  const bool marked = contents.compare(0, 2, "\xff\xfe") == 0 || contents.compare(0, 2, "\xfe\xff") == 0;
  // Without a mark, plain letters have a zero before or behind each.
  const bool in_pairs =
      contents.size() >= 4 && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3) && is_zero(0) != is_zero(1);
  if (marked || in_pairs)
    refuse_stones(file, "is text in UTF-16, which has two bytes for a letter", "Save it as UTF-8, or as plain text");
  return contents.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
}

bool StoneLines::next() {
  words_.clear();
  bool more = false;
  while ((words_.empty() || more) && at_ < contents_.size()) {
    const std::size_t begin = at_;
    const auto [end, next] = end_of_line(contents_, begin);
    ++read_;
    if (words_.empty()) line_ = read_;
    add_words(end);
    at_ = returns_alone_ ? end + 1 : next;
    more = goes_on(begin, end);
    if (!more) drop_comment();
  }
  at_ = std::min(at_, contents_.size());
  return !words_.empty();
}

/// Of the text up to an end of line.
void StoneLines::add_words(std::size_t end) {
  std::string word;
  for (std::size_t k = at_; k <= end; ++k) {
    const char c = k < end ? contents_[k] : ' ';
    if (c != ' ' && c != '\t') {
      word += c;
    } else if (!word.empty()) {
      words_.push_back(std::move(word));
      word.clear();
    }
  }
}

/// Whether the line ends in the sign that it goes on, which is taken off. In a comment it is no sign: many name a
/// folder of Windows.
bool StoneLines::goes_on(std::size_t begin, std::size_t end) {
  if (rules_ != LineRules::obj || words_.empty() || words_.back().back() != '\\') return false;
  if (std::find(contents_.begin() + static_cast<std::ptrdiff_t>(begin),
                contents_.begin() + static_cast<std::ptrdiff_t>(end),
                '#') != contents_.begin() + static_cast<std::ptrdiff_t>(end))
    return false;
  words_.back().pop_back();
  if (words_.back().empty()) words_.pop_back();
  return true;
}

/// In names the sign of a comment stands alone, since a name may hold it ("Block #3"), and stones whose names were cut
/// there would be one.
void StoneLines::drop_comment() {
  if (rules_ != LineRules::obj || words_.empty()) return;
  const bool in_name = words_[0] == "o" || words_[0] == "g";
  for (std::size_t k = 0; k < words_.size(); ++k) {
    const std::size_t at = in_name ? (words_[k] == "#" ? 0 : std::string::npos) : words_[k].find('#');
    if (at == std::string::npos) continue;
    words_[k].resize(at);
    words_.resize(at > 0 ? k + 1 : k);
    return;
  }
}

std::string StoneLines::place() const {
  return std::filesystem::path(file_).filename().string() + ", line " + std::to_string(line_);
}

std::string StoneLines::text_from(std::size_t from) const {
  std::string text;
  for (std::size_t k = from; k < words_.size(); ++k) text += (text.empty() ? "" : " ") + words_[k];
  return text;
}

double StoneLines::number(std::size_t word) const {
  if (word >= words_.size())
    refuse("ends after " + counted(words_.size(), "word") + ", where a number is wanted",
           "Give x, y and z of each point");
  const auto value = number_in(words_[word]);
  if (!value || !std::isfinite(*value))
    refuse("has " + in_quotes(words_[word]) + " where a number is wanted", "Write it as 0.25 or 2.5e-1");
  return *value;
}

Vector<3> StoneLines::point(std::size_t first_word) const {
  return {number(first_word), number(first_word + 1), number(first_word + 2)};
}

int StoneLines::whole_number(std::size_t word) const {
  const auto value = word < words_.size() ? whole_number_in(words_[word]) : std::nullopt;
  if (!value)
    refuse((word < words_.size() ? "has " + in_quotes(words_[word]) : std::string("ends")) +
               " where a whole number is wanted",
           "Export the file anew");
  return *value;
}

void StoneLines::refuse(const std::string& why, const std::string& advice) const {
  refuse_stones(file_, "line " + std::to_string(line_) + " " + why, advice);
}

void StoneBytes::require(std::size_t bytes) const {
  if (left() < bytes)
    refuse_stones(file_,
                  "ends at byte " + std::to_string(contents_.size()) + ", where " + std::to_string(bytes - left()) +
                      " more are wanted",
                  "It was cut when it was copied, or is damaged: export it anew");
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string stem(const std::string& file) { return std::filesystem::path(file).stem().string(); }

}  // namespace voussoir
