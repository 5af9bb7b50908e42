// Options of a program: forms, values, help, refusals.
#include "base/command_line.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "base/error.hpp"
#include "base/text.hpp"

namespace {

using namespace voussoir;

struct Sample {
  Sample() {
    line.add("--out", "DIR", folder, "where results go");
    line.add("--size", "H", size, above(0), "size of a cell [m]\nof every block");
    line.add("--count", "N", count, at_least(1), "how many");
    line.add_repeated("--set", "PATH=VALUE", changes, "change a parameter");
    line.add_flag("--restart", restart, "go on");
    line.add(
        "--restart-from", "DIR", [this](const std::string& text) { from = text + "!"; }, "go on elsewhere");
  }
  /// What is told of the words, or "".
  std::string refusal(const std::vector<std::string>& words) {
    try {
      line.read(words);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  std::string folder = "out", from;
  double size = 0.5;
  int count = 2;
  std::vector<std::string> changes;
  bool restart = false;
  CommandLine line{"sample", "[options]"};
};

const std::string advice = "\n  See sample --help.";

TEUCHOS_UNIT_TEST(CommandLine, AValueStandsBehindAnEqualSignOrAsTheNextWord) {
  Sample sample;
  TEST_ASSERT(sample.line.read({"--out=a=b", "--size", "1e-2", "--restart", "--restart-from", "there"}));
  TEST_EQUALITY_CONST(sample.folder, "a=b");
  TEST_EQUALITY_CONST(sample.size, 0.01);
  TEST_EQUALITY_CONST(sample.count, 2);
  TEST_EQUALITY_CONST(sample.from, "there!");
  TEST_ASSERT(sample.restart);
}

TEUCHOS_UNIT_TEST(CommandLine, AFlagMayHaveOneWordBehindAnEqualSignAndTakesNotTheNext) {
  for (const auto& [word, how] : {std::pair("--print", "plain"), std::pair("--print=json", "json")}) {
    Sample sample;
    std::string printed;
    sample.line.add_flag("--print", "json", printed, "print all");
    TEST_ASSERT(sample.line.read({word, "--restart"}));
    TEST_EQUALITY(printed, how);
    TEST_ASSERT(sample.restart);
    TEST_EQUALITY(sample.refusal({"--print=xml"}), "sample: --print = \"xml\"\n  must be json, or left out." + advice);
    TEST_EQUALITY(sample.refusal({"--print", "json"}), "sample: 'json' is no option." + advice);
  }
}

TEUCHOS_UNIT_TEST(CommandLine, TheLastOfAnOptionCountsAndARepeatedOneKeepsAll) {
  Sample sample;
  // A text of its own may begin with a bracket or a minus, hold blanks and commas, and end with its equal sign.
  const std::vector<std::string> changes{"a/b=1", "x record=", "[1,2]", "-1", "a={}", "--b=2"};
  std::vector<std::string> words{"--out=first", "--out=second"};
  for (const auto& change : changes) {
    words.emplace_back("--set");
    words.push_back(change);
  }
  TEST_ASSERT(sample.line.read(words));
  TEST_EQUALITY_CONST(sample.folder, "second");
  TEST_COMPARE_ARRAYS(sample.changes, changes);
}

TEUCHOS_UNIT_TEST(CommandLine, ANumberIsOneToItsLastLetterAndInItsRange) {
  TEST_EQUALITY(Sample().refusal({"--size=1m"}), "sample: --size = \"1m\"\n  must be a number > 0." + advice);
  TEST_EQUALITY(Sample().refusal({"--size", "-1"}), "sample: --size = \"-1\"\n  must be a number > 0." + advice);
  TEST_EQUALITY(Sample().refusal({"--size=nan"}), "sample: --size = \"nan\"\n  must be a number > 0." + advice);
  TEST_EQUALITY(Sample().refusal({"--count=2.5"}),
                "sample: --count = \"2.5\"\n  must be a whole number >= 1." + advice);
}

TEUCHOS_UNIT_TEST(CommandLine, WhatIsNoOptionIsNamedWithTheOneThatWasMeant) {
  TEST_EQUALITY(Sample().refusal({"scene.xml"}), "sample: 'scene.xml' is no option." + advice);
  TEST_EQUALITY(Sample().refusal({"--restrat"}),
                "sample: '--restrat' is no option (did you mean \"--restart\"?)." + advice);
  TEST_EQUALITY(Sample().refusal({"--otu=a"}), "sample: '--otu=a' is no option (did you mean \"--out\"?)." + advice);
}

TEUCHOS_UNIT_TEST(CommandLine, ValuesStandWhereTheyBelongAndNowhereElse) {
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"--set"}, {"--set="}, {"--set", "--restart"}, {"--set=", "a=1"}})
    TEST_EQUALITY(Sample().refusal(words), "sample: --set needs a value." + advice);
  TEST_EQUALITY(Sample().refusal({"--restart-from"}), "sample: --restart-from needs a value." + advice);
  TEST_EQUALITY(Sample().refusal({"--restart=true"}), "sample: --restart takes no value." + advice);
}

TEUCHOS_UNIT_TEST(CommandLine, HelpIsMadeOfTheDeclarations) {
  Sample sample;
  TEST_ASSERT(!sample.line.read({"--help", "--unknown"}));
  TEST_EQUALITY(sample.line.help("The end.\n"), R"(sample [options]
  --out=DIR           where results go
  --size=H            size of a cell [m]
                      of every block
  --count=N           how many
  --set PATH=VALUE    change a parameter
  --restart           go on
  --restart-from=DIR  go on elsewhere
  --help              this text
The end.
)");
}

}  // namespace
