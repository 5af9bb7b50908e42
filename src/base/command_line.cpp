#include "base/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

/// Options alone, each with what it does in a second column.
class HelpText : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    std::string text = app->get_name() + " " + app->get_description() + "\n";
    const CLI::Option* help = app->get_option("--help");
    for (const CLI::Option* option : app->get_options())
      if (option != help) text += make_option(option, false);
    return text + make_option(help, false);
  }
  std::string make_option_name(const CLI::Option* option, bool) const override { return option->get_name(); }
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string word = option->get_type_name();
    return (word.empty() || word[0] == '[' ? "" : word.find('=') == std::string::npos ? "=" : " ") + word;
  }
};

}  // namespace

struct CommandLine::Parser {
  CLI::App app;
  bool help = false;
  std::size_t widest = 0;

  CLI::Option* declared(CLI::Option* option, const std::string& stands_for) {
    option->type_name(stands_for);
    widest = std::max(widest, option->get_name().size() + stands_for.size());
    return option;
  }

  std::vector<std::string> known() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
    return names;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(app.get_name() + ": " + what + "\n  See " + app.get_name() + " --help.");
  }

  /// A value that is itself an option was forgotten.
  void check_value(const std::string& option, const std::string& value) const {
    if (app.get_option_no_throw(value)) refuse(option + " needs a value.");
  }

  /// The library lets a flag have a value, and seeks what lacks behind an equal sign in the next word.
  void check_equal_sign(const std::string& word) const {
    const auto sign = word.find('=');
    const auto* option = sign == std::string::npos ? nullptr : app.get_option_no_throw(word.substr(0, sign));
    const bool flag = option && option->get_items_expected_max() == 0;
    if (flag && option->get_type_name().empty()) refuse(option->get_name() + " takes no value.");
    if (option && sign + 1 == word.size()) refuse(option->get_name() + " needs a value.");
  }
};

CommandLine::CommandLine(const std::string& program, const std::string& synopsis)
    : parser_(std::make_unique<Parser>()) {
  CLI::App& app = parser_->app;
  app.name(program);
  app.description(synopsis);
  app.set_help_flag();  // that of the library throws
  app.allow_extras();   // read() refuses them in our words
  add_flag("--help", parser_->help, "this text");
}

CommandLine::~CommandLine() = default;

void CommandLine::add(const std::string& option, const std::string& stands_for,
                      const std::function<void(const std::string&)>& take, const std::string& text) {
  const CLI::callback_t take_last = [this, option, take](const CLI::results_t& values) {
    parser_->check_value(option, values.back());
    take(values.back());
    return true;
  };
  parser_->declared(parser_->app.add_option(option, take_last, text)->take_last(), stands_for);
}

void CommandLine::add(const std::string& option, const std::string& stands_for, std::string& value,
                      const std::string& text) {
  add(
      option, stands_for, [&value](const std::string& given) { value = given; }, text);
}

void CommandLine::add(const std::string& option, const std::string& stands_for, double& value, const Range& range,
                      const std::string& text) {
  const auto take = [this, option, &value, range](const std::string& given) {
    const auto number = number_in(given);
    if (!number || !range.contains(*number)) refuse(option, given, "must be a number " + range.text() + ".");
    value = *number;
  };
  add(option, stands_for, take, text);
}

void CommandLine::add(const std::string& option, const std::string& stands_for, int& value, const Range& range,
                      const std::string& text) {
  const auto take = [this, option, &value, range](const std::string& given) {
    const auto number = whole_number_in(given);
    if (!number || !range.contains(*number)) refuse(option, given, "must be a whole number " + range.text() + ".");
    value = *number;
  };
  add(option, stands_for, take, text);
}

void CommandLine::add_repeated(const std::string& option, const std::string& stands_for,
                               std::vector<std::string>& values, const std::string& text) {
  const CLI::callback_t take_all = [this, option, &values](const CLI::results_t& given) {
    for (const auto& value : given) parser_->check_value(option, value);
    values = given;
    return true;
  };
  parser_->declared(parser_->app.add_option(option, take_all, text)->take_all(), stands_for);
}

void CommandLine::add_flag(const std::string& option, bool& given, const std::string& text) {
  parser_->declared(parser_->app.add_flag(option, given, text)->take_last(), "");
}

void CommandLine::add_flag(const std::string& option, const std::string& word, std::string& how,
                           const std::string& text) {
  const CLI::callback_t take = [this, option, word, &how](const CLI::results_t& values) {
    const auto& given = values.back();
    if (given != "true" && given != word) refuse(option, given, "must be " + word + ", or left out.");
    how = given == word ? word : "plain";
    return true;
  };
  auto* flag = parser_->app.add_option(option, take, text)->take_last()->expected(0);
  parser_->declared(flag, "[=" + word + "]");
}

std::string CommandLine::help(const std::string& closing) const {
  const auto format = std::make_shared<HelpText>();
  format->column_width(parser_->widest + 5);  // margin, = and two blanks
  parser_->app.formatter(format);
  return parser_->app.help() + closing;
}

bool CommandLine::read(const std::vector<std::string>& words) {
  for (const auto& word : words) parser_->check_equal_sign(word);
  try {
    parser_->app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ArgumentMismatch&) {  // only the last word can be without the next one
    parser_->refuse(words.back() + " needs a value.");
  }
  if (parser_->help) return false;
  for (const auto& word : parser_->app.remaining())
    parser_->refuse("'" + shortened(word, 100) + "' is no option" +
                    did_you_mean(word.substr(0, word.find('=')), parser_->known()) + ".");
  return true;
}

void CommandLine::refuse(const std::string& option, const std::string& value, const std::string& why) const {
  parser_->refuse(option + " = " + in_quotes(value) + "\n  " + why);
}

}  // namespace voussoir
