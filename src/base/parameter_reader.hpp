// Fills declared parameters from a list and from overrides, and collects all that is wrong with them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/input_problems.hpp"
#include "base/parameter_section.hpp"

namespace voussoir {

/// Values that go before those of the list, as text: "scene > joints > dry > cohesion" -> "1e5".
using Overrides = std::map<std::string, std::string>;

/// Reads texts such as "joints/dry/cohesion=1e5" or "scene > joints > dry > cohesion = 1e5"; the last one wins.
Overrides read_overrides(const std::vector<std::string>& texts, InputProblems&);

/// An entry as messages show it: "0.5 (double)".
std::string type_and_value(const Teuchos::ParameterEntry&);

class ParameterReader final : public ParameterSection {
 public:
  /// @param root a list whose path in messages is "scene"
  /// All three must outlive the reader. Where `problems` concern a path already, its entry is not missed.
  ParameterReader(const Teuchos::ParameterList& root, const Overrides&, InputProblems& problems);
  /// To be called when all is declared: reports keys and overrides nobody asked for.
  void finish();

 private:
  struct Frame {
    const Teuchos::ParameterList* list;
    std::string path;
    std::vector<std::string> known;                ///< declared names
    std::map<std::string, std::string> elsewhere;  ///< names of other choices -> the choice they belong to
  };

  void visit(const Parameter&) override;
  void visit(const Subsection&, const std::function<void()>& declare) override;
  void visit(const Family&) override;
  void refuse(const std::string& name, const std::string& value, const std::string& why,
              const std::string& advice) override;

  void read(const Parameter&, double*);
  void read(const Parameter&, int*);
  void read(const Parameter&, bool*);
  void read(const Parameter&, std::string*);
  void read(const Parameter&, const Choice&);
  void read(const Parameter&, std::map<std::string, double>*);
  void read(const Parameter&, Teuchos::ParameterList*);

  std::string path(const std::string& name) const { return frames_.back().path + " > " + name; }
  const Teuchos::ParameterEntry* entry(const std::string& name) const;
  std::optional<std::string> overridden(const std::string& path);
  /// Overrides below a path, without the path: name -> text.
  std::map<std::string, std::string> overridden_below(const std::string& path);
  const Teuchos::ParameterList* sublist(const std::string& name);
  void record(const std::string& name);
  void enter(const std::string& name, const Teuchos::ParameterList*);
  void leave();

  std::optional<double> number(const Parameter&, const std::string& path, const Teuchos::ParameterEntry*,
                               const std::optional<std::string>& given);
  std::optional<std::string> word(const Parameter&);
  void wrong_type(const Parameter&, const std::string& path, const std::string& value, const std::string& wanted);
  void wrong_value(const Parameter&, const std::string& path, const std::string& value, const std::string& must);
  void missing(const Parameter&);

  const Overrides& overrides_;
  InputProblems& problems_;
  std::vector<Frame> frames_;
  std::set<std::string> used_;      ///< overrides somebody asked for
  std::vector<std::string> paths_;  ///< of all parameters, for suggestions
  bool undecided_ = false;          ///< the choice was refused: names are known, values are not read
  std::string hidden_;              ///< the choice whose keys are being recorded, "" when values are read
};

}  // namespace voussoir
