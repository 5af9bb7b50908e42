// Names of sets of blocks by number. Every stone of a file is a set of its own, so no rank knows the names of all: of a
// generated mesh each rank does, of a file those of the blocks that it can be asked of.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"

namespace voussoir {

class SetNames {
 public:
  SetNames() = default;
  SetNames(const std::vector<std::string>& all) {
    for (const auto& name : all) push_back(name);
  }
  SetNames(std::initializer_list<std::string> all) : SetNames(std::vector<std::string>(all)) {}

  /// Of one who knows all: another one, behind the last.
  void push_back(std::string name) {
    VOUSSOIR_EXPECT(are_all_);
    names_.emplace(static_cast<int>(names_.size()), std::move(name));
  }
  /// Of one who knows some.
  void learn(int number, std::string name) {
    are_all_ = false;
    names_.emplace(number, std::move(name));
  }
  /// Whether these are the names of all sets that there are.
  bool are_all() const { return are_all_; }
  /// How many are known.
  std::size_t size() const { return names_.size(); }
  /// Of a set that is known.
  const std::string& operator[](int number) const {
    const auto found = names_.find(number);
    VOUSSOIR_CHECK(found != names_.end() && "a set of no block that was brought to this rank");
    return found->second;
  }
  /// -1 where no set of that name is known.
  int number_of(const std::string& name) const {
    for (const auto& [number, known] : names_)
      if (known == name) return number;
    return -1;
  }
  std::map<int, std::string>::const_iterator begin() const { return names_.begin(); }
  std::map<int, std::string>::const_iterator end() const { return names_.end(); }
  friend bool operator==(const SetNames& a, const SetNames& b) { return a.names_ == b.names_; }

 private:
  std::map<int, std::string> names_;
  bool are_all_ = true;
};

}  // namespace voussoir
