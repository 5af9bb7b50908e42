// How files of stones are read: line by line or byte by byte, with words for what is wrong in them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "base/text.hpp"

namespace voussoir {

/// Throws InputError "mesh > stones > file = `file`\n  `why`\n  `advice`", without control characters: words of a file
/// that is none of text may hold any, and one of zero would end the message.
[[noreturn]] void refuse_stones(const std::string& file, const std::string& why, const std::string& advice);

/// The text, or what it is in UTF-8 where it is in Latin-1, without control characters.
std::string as_utf8(const std::string&);

/// [bytes] before the first letter: the mark that some programs set to say that a text is UTF-8. Refuses UTF-16.
std::size_t begin_of_text(const std::string& file, const std::string& contents);

/// What lines are made of. In OBJ "#" begins a comment, and a line that ends in "\" goes on in the next one.
enum class LineRules { plain, obj };

/// The lines of a text that hold words.
class StoneLines {
 public:
  StoneLines(std::string file, const std::string& contents, LineRules rules = LineRules::plain)
      : file_(std::move(file)), contents_(contents), rules_(rules), at_(begin_of_text(file_, contents)) {
    const auto [end, next] = end_of_line(contents_, at_);
    returns_alone_ = end + 1 == next && contents_[end] == '\r';
  }
  /// Goes to the next line with words; false at the end.
  bool next();
  const std::vector<std::string>& words() const { return words_; }
  int line() const { return line_; }          ///< of one that goes on, the first
  std::size_t behind() const { return at_; }  ///< [bytes] from the beginning to the next line
  /// "vault.obj, line 17"
  std::string place() const;
  /// The words behind the first `from`, with blanks between them.
  std::string text_from(std::size_t from) const;
  /// A finite number; refuses anything else.
  double number(std::size_t word) const;
  Vector<3> point(std::size_t first_word) const;
  int whole_number(std::size_t word) const;
  [[noreturn]] void refuse(const std::string& why, const std::string& advice) const;

 private:
  void add_words(std::size_t end);
  bool goes_on(std::size_t begin, std::size_t end);
  void drop_comment();

  std::string file_;
  const std::string& contents_;
  LineRules rules_;
  std::size_t at_;
  bool returns_alone_ = false;  ///< lines end in "\r": a "\n" behind the last one is a byte of what follows the text
  int line_ = 0, read_ = 0;
  std::vector<std::string> words_;
};

/// Numbers from bytes, of either order.
class StoneBytes {
 public:
  StoneBytes(std::string file, const std::string& contents, std::size_t at, bool big_endian)
      : file_(std::move(file)), contents_(contents), at_(at), swap_(big_endian) {}
  template <class T>
  T plain() {
    require(sizeof(T));
    char bytes[sizeof(T)];
    std::memcpy(bytes, contents_.data() + at_, sizeof(T));
    if (swap_) std::reverse(bytes, bytes + sizeof(T));
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }
  void skip(std::size_t bytes) {
    require(bytes);
    at_ += bytes;
  }
  std::size_t left() const { return contents_.size() - at_; }

 private:
  void require(std::size_t bytes) const;

  std::string file_;
  const std::string& contents_;
  std::size_t at_;
  bool swap_;
};

/// Without capitals of plain letters.
std::string lower(std::string);

/// The file name without folders and without ending.
std::string stem(const std::string& file);

}  // namespace voussoir
