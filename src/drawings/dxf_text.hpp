// A DXF as what it is written as: pairs of lines, what a value is and the value.
#pragma once

#include <string>
#include <vector>

namespace voussoir {

struct DxfPair {
  int code = 0;
  std::string value;
  int line = 0;  ///< of the value
};

class DxfText {
 public:
  /// Throws InputError for what is no text of pairs, or was cut.
  DxfText(const std::string& file, const std::string& contents);

  const std::vector<DxfPair>& pairs() const { return pairs_; }
  /// The value as a number. Throws InputError, naming the line.
  double number(const DxfPair&) const;
  int whole(const DxfPair&) const;
  [[noreturn]] void refuse(const DxfPair& at, const std::string& why, const std::string& advice) const;

 private:
  std::string file_;
  std::vector<DxfPair> pairs_;
};

}  // namespace voussoir
