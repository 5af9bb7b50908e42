// The command line of a program, declared once: its options, what the help says of them, how wrong words are refused.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/range.hpp"

namespace voussoir {

/// An option is a word such as --out; its value stands behind it, as --out=DIR or --out DIR. Errors are InputErrors
/// that name the program, the option and its value, and depend on the words alone: all ranks throw or none.
class CommandLine {
 public:
  /// @param synopsis  what follows the name of the program on the first line of the help
  CommandLine(const std::string& program, const std::string& synopsis);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// @param option      such as "--out"
  /// @param stands_for  the word for the value in the help
  /// @param take        is given the value; of an option that is given twice, the last
  /// @param text        for the help; its lines are kept
  void add(const std::string& option, const std::string& stands_for,
           const std::function<void(const std::string&)>& take, const std::string& text);
  void add(const std::string& option, const std::string& stands_for, std::string&, const std::string& text);
  void add(const std::string& option, const std::string& stands_for, double&, const Range&, const std::string& text);
  void add(const std::string& option, const std::string& stands_for, int&, const Range&, const std::string& text);
  /// An option that may be repeated.
  void add_repeated(const std::string& option, const std::string& stands_for, std::vector<std::string>&,
                    const std::string& text);
  /// An option without a value.
  void add_flag(const std::string& option, bool&, const std::string& text);
  /// An option whose value may be left out: --option or --option=word, of which `how` becomes "plain" or the word.
  void add_flag(const std::string& option, const std::string& word, std::string& how, const std::string& text);

  /// What the options do, in the order in which they were added; --help, which every program has, is the last.
  /// @param closing  what follows them
  std::string help(const std::string& closing) const;

  /// Fills what was bound. With --help among the words it returns false, and nothing is refused but values.
  bool read(const std::vector<std::string>& words);

  /// Throws what a user is told of an option.
  /// @param why  how the value must be, with a full stop
  [[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& why) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace voussoir
