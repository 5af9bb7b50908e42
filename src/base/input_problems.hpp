// All that is wrong with one input, so that a user learns it in one go.
#pragma once

#include <string>
#include <vector>

namespace voussoir {

class InputProblems {
 public:
  explicit InputProblems(std::string file) : file_(std::move(file)) {}

  /// @param path    where, "scene > joints > dry > friction coefficient"
  /// @param message what follows the path: value, why, what to do
  void add(const std::string& path, const std::string& message);
  /// Whether something is wrong at the path or below it.
  bool concern(const std::string& path) const;
  /// Whether something is wrong at exactly this path.
  bool at(const std::string& path) const;
  bool empty() const { return texts_.empty(); }
  const std::string& file() const { return file_; }
  /// Throws InputError with the first twenty.
  void throw_if_any() const;

 private:
  std::string file_;
  std::vector<std::string> paths_, texts_;  ///< of the first problems
  std::size_t count_ = 0;                   ///< of all
};

}  // namespace voussoir
