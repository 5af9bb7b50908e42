#include "stones/stone_text.hpp"

#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"

namespace voussoir {

void refuse_stones(const std::string& file, const std::string& why, const std::string& advice) {
  throw InputError("mesh > stones > file = " + file + sentence(why) + sentence(advice));
}

bool StoneLines::next() {
  words_.clear();
  while (words_.empty() && at_ < contents_.size()) {
    const std::size_t end = std::min(contents_.find('\n', at_), contents_.size());
    ++line_;
    std::string word;
    for (std::size_t k = at_; k <= end; ++k) {
      const char c = k < end ? contents_[k] : ' ';
      if (c != ' ' && c != '\t' && c != '\r') {
        word += c;
      } else if (!word.empty()) {
        words_.push_back(std::move(word));
        word.clear();
      }
    }
    at_ = end + 1;
  }
  at_ = std::min(at_, contents_.size());
  return !words_.empty();
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

std::string stem(const std::string& file) { return std::filesystem::path(file).stem().string(); }

}  // namespace voussoir
