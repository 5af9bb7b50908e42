#include "base/input_problems.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace voussoir {

void InputProblems::add(const std::string& path, const std::string& message) {
  constexpr std::size_t most = 1000;  // so that a large and thoroughly wrong input is refused at once
  if (++count_ > most) return;
  paths_.push_back(path);
  texts_.push_back(file_ + ": " + path + message);
}

bool InputProblems::concern(const std::string& path) const {
  const std::string below = path + " > ";
  return std::any_of(paths_.begin(), paths_.end(), [&](const std::string& other) {
    return other == path || other.compare(0, below.size(), below) == 0;
  });
}

bool InputProblems::at(const std::string& path) const {
  return std::find(paths_.begin(), paths_.end(), path) != paths_.end();
}

void InputProblems::throw_if_any() const {
  if (texts_.empty()) return;
  constexpr std::size_t most = 20;  // a screen full; the rest often follows from the first
  std::string all = texts_.front();
  for (std::size_t i = 1; i < std::min(most, texts_.size()); ++i) all += '\n' + texts_[i];
  if (count_ > most) all += "\n... and " + std::to_string(count_ - most) + " more of this input.";
  throw InputError(all);
}

}  // namespace voussoir
