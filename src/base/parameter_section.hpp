// How a module declares its parameters, once: name, default, unit, range, text and binding in one statement.
//
//   void JointLawParameters::declare(ParameterSection& section) {
//     section.add("friction coefficient", friction_coefficient, "-", at_least(0.0), "Coulomb's coefficient",
//                 "a negative coefficient would create energy in sliding", "Give mu = tan(friction angle).");
//   }
//
// What is allowed and probably not meant is part of the range: at_least(0.0).usually(0.02, 2).
//
// The default is the value the struct has. A ParameterSection visits the declarations: ParameterReader fills the
// struct from a list and validates, XmlPrinter writes it, with or without its documentation. A value is bound when
// its statement ends, so later statements may depend on it.
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/range.hpp"

namespace voussoir {

/// One of several words, whatever the type is that the words stand for.
struct Choice {
  std::vector<std::string> words;
  std::function<std::size_t()> get;  ///< index of the present word
  std::function<void(std::size_t)> set;
};

/// What the text of a number says whose value nobody has argued.
inline const char* const no_reason = "No reason is recorded; see the ablation study";

enum class Presence { optional, required };

/// A declared parameter and the place of its value.
struct Parameter {
  using Value =
      std::variant<double*, int*, bool*, std::string*, Choice, std::map<std::string, double>*, Teuchos::ParameterList*>;
  std::string name;
  Value value;
  std::string unit;  ///< "Pa"; "-" for a pure number, "" for what is no number
  Range range;
  std::string text;    ///< what it is
  std::string why;     ///< why the range is what it is
  std::string advice;  ///< what to do when the value is refused, a sentence
  Presence presence = Presence::optional;
};

/// A sublist with declarations of its own.
struct Subsection {
  std::string name;  ///< "" when its keys stand in the section that declares it
  std::string text;
  bool chosen = true;  ///< false: belongs to another choice than the present one
  std::string choice;  ///< the choice it belongs to, "type = wall"
};

/// A sublist of sublists whose names the user chooses, such as the materials of a scene.
struct Family {
  std::string name;
  std::string text;
  std::string example;                              ///< a name for the documentation
  std::vector<std::string> names;                   ///< present members
  std::function<void(const std::string&)> declare;  ///< declares the member of this name, made when missing
};

class ParameterSection {
 public:
  virtual ~ParameterSection() = default;

  void add(const std::string& name, double&, const std::string& unit, const Range&, const std::string& text,
           const std::string& why = "", const std::string& advice = "");
  void add(const std::string& name, int&, const std::string& unit, const Range&, const std::string& text,
           const std::string& why = "", const std::string& advice = "");
  void add(const std::string& name, bool&, const std::string& text);
  /// A text that may be empty only when it is optional.
  void add(const std::string& name, std::string&, const std::string& text, Presence = Presence::optional,
           const std::string& advice = "");
  /// One of several words; T is an enum or whatever can be compared.
  template <class T>
  void add_choice(const std::string& name, T& value, const std::vector<std::pair<std::string, T>>& words,
                  const std::string& text, Presence = Presence::optional);
  /// A sublist of numbers under names the user chooses.
  void add_numbers(const std::string& name, std::map<std::string, double>&, const std::string& unit, const Range&,
                   const std::string& text);
  /// A sublist passed on as it is.
  void add_list(const std::string& name, Teuchos::ParameterList&, const std::string& text);
  template <class Parameters>
  void add_section(const std::string& name, Parameters& parameters, const std::string& text) {
    visit(Subsection{name, text, true, ""}, [&] { parameters.declare(*this); });
  }
  /// A sublist (or, without a name, keys of this section) that exists for one choice only.
  template <class Parameters>
  void add_alternative(const std::string& name, Parameters& parameters, bool chosen, const std::string& choice,
                       const std::string& text) {
    visit(Subsection{name, text, chosen, choice}, [&] { parameters.declare(*this); });
  }
  void add_family(const Family& family) { visit(family); }

  /// Refuses a value for what other values are. Only a reader cares, and only when the section is right so far.
  /// @param value as the message shows it, with its unit; "" when there is none to show
  /// @param why   "must be > x from = 2 m (an opening needs an area)", without the full stop
  void check(bool holds, const std::string& name, const std::string& value, const std::string& why,
             const std::string& advice) {
    if (!holds) refuse(name, value, why, advice);
  }
  /// Doubts a value for what other values are: it is allowed and probably not meant. A value alone is doubted where it
  /// is outside Range::usually().
  /// @param why   "is 20 m at a tension strength of 0.05 Pa (...)", without the full stop
  void expect(bool holds, const std::string& name, const std::string& value, const std::string& why,
              const std::string& advice) {
    if (!holds) wonder(name, value, why, advice);
  }

 protected:
  virtual void visit(const Parameter&) = 0;
  virtual void visit(const Subsection&, const std::function<void()>& declare) = 0;
  virtual void visit(const Family&) = 0;
  virtual void refuse(const std::string& name, const std::string& value, const std::string& why,
                      const std::string& advice) = 0;
  virtual void wonder(const std::string&, const std::string&, const std::string&, const std::string&) {}
};

template <class T>
void ParameterSection::add_choice(const std::string& name, T& value,
                                  const std::vector<std::pair<std::string, T>>& words, const std::string& text,
                                  Presence presence) {
  Choice choice;
  std::vector<T> values;
  for (const auto& [word, meaning] : words) {
    choice.words.push_back(word);
    values.push_back(meaning);
  }
  choice.get = [&value, values] {
    std::size_t i = 0;
    while (i + 1 < values.size() && !(values[i] == value)) ++i;
    return i;
  };
  choice.set = [&value, values](std::size_t i) { value = values[i]; };
  visit(Parameter{name, choice, "", any_number(), text, "", "", presence});
}

}  // namespace voussoir
