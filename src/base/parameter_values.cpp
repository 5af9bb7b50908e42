// How ParameterReader takes single values: from an override, else from the list, with their type and range.
#include <algorithm>

#include "base/parameter_reader.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

std::string with_unit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " [" + unit + "]";
}

/// Sets an entry from text: with the type it has, else with the first type the text fits.
void set_from_text(ParameterList& list, const std::string& name, const std::string& text) {
  const ParameterEntry* old = list.getEntryPtr(name);
  const auto whole = whole_number_in(text);
  const auto number = number_in(text);
  const auto truth = truth_in(text);
  if (old && old->isType<std::string>())
    list.set(name, text);
  else if (old && old->isType<bool>() && truth)
    list.set(name, *truth);
  else if (whole && !(old && old->isType<double>()))
    list.set(name, *whole);
  else if (number)
    list.set(name, *number);
  else if (truth)
    list.set(name, *truth);
  else
    list.set(name, text);
}

}  // namespace

std::string type_and_value(const ParameterEntry& entry) {
  if (entry.isType<double>()) return number_text(Teuchos::getValue<double>(entry)) + " (double)";
  if (entry.isType<int>()) return std::to_string(Teuchos::getValue<int>(entry)) + " (int)";
  if (entry.isType<bool>()) return std::string(Teuchos::getValue<bool>(entry) ? "true" : "false") + " (bool)";
  if (entry.isType<std::string>()) return in_quotes(Teuchos::getValue<std::string>(entry)) + " (string)";
  return entry.isList() ? "a ParameterList" : "a value of another type";
}

void ParameterReader::wrong_type(const Parameter& p, const std::string& path, const std::string& value,
                                 const std::string& wanted) {
  problems_.add(path, " = " + value + "\n  must be of type " + wanted + "." +
                          sentence("Write type=" + in_quotes(wanted) + "; this is " + p.text));
}

void ParameterReader::wrong_value(const Parameter& p, const std::string& path, const std::string& value,
                                  const std::string& must) {
  problems_.add(path, " = " + with_unit(value, p.unit) + "\n  must be " + must +
                          (p.why.empty() ? "." : " (" + p.why + ").") + sentence(p.advice.empty() ? p.text : p.advice));
}

void ParameterReader::missing(const Parameter& p) {
  const Choice* choice = std::get_if<Choice>(&p.value);
  const std::string advice = choice ? "Give one of " + list_of(choice->words) : p.advice;
  problems_.add(path(p.name), " is missing.\n  A scene needs it: " + p.text + "." + sentence(advice));
}

/// A number from an override or an entry, in range; nothing when it is absent or has been refused.
std::optional<double> ParameterReader::number(const Parameter& p, const std::string& path, const ParameterEntry* entry,
                                              const std::optional<std::string>& given) {
  double value;
  std::string as_text;
  if (given) {
    const auto parsed = number_in(*given);
    as_text = *given + " (from --set)";
    if (!parsed) {
      wrong_value(p, path, as_text, "a number");
      return std::nullopt;
    }
    value = *parsed;
  } else if (entry && entry->isType<double>()) {
    value = Teuchos::getValue<double>(*entry);
    as_text = number_text(value);
  } else if (entry && entry->isType<int>()) {
    value = Teuchos::getValue<int>(*entry);
    as_text = number_text(value);
  } else {
    if (entry) wrong_type(p, path, type_and_value(*entry), "double");
    return std::nullopt;
  }
  if (p.range.contains(value)) return value;
  wrong_value(p, path, as_text, p.range.text());
  return std::nullopt;
}

void ParameterReader::read(const Parameter& p, double* target) {
  const auto value = number(p, path(p.name), entry(p.name), overridden(path(p.name)));
  if (value) *target = *value;
}

void ParameterReader::read(const Parameter& p, int* target) {
  const auto given = overridden(path(p.name));
  const ParameterEntry* e = entry(p.name);
  int value;
  if (given) {
    const auto parsed = whole_number_in(*given);
    if (!parsed) return wrong_value(p, path(p.name), *given + " (from --set)", "a whole number of at most ten digits");
    value = *parsed;
  } else if (!e) {
    return;
  } else if (e->isType<int>()) {
    value = Teuchos::getValue<int>(*e);
  } else {
    return wrong_type(p, path(p.name), type_and_value(*e), "int");
  }
  if (!p.range.contains(value)) return wrong_value(p, path(p.name), std::to_string(value), p.range.text());
  *target = value;
}

void ParameterReader::read(const Parameter& p, bool* target) {
  const auto given = overridden(path(p.name));
  const ParameterEntry* e = entry(p.name);
  if (given) {
    const auto parsed = truth_in(*given);
    if (!parsed) return wrong_value(p, path(p.name), *given + " (from --set)", "true or false");
    *target = *parsed;
  } else if (e && e->isType<bool>()) {
    *target = Teuchos::getValue<bool>(*e);
  } else if (e) {
    wrong_type(p, path(p.name), type_and_value(*e), "bool");
  }
}

std::optional<std::string> ParameterReader::word(const Parameter& p) {
  const auto given = overridden(path(p.name));
  if (given) return given;
  const ParameterEntry* e = entry(p.name);
  if (e && e->isType<std::string>()) return Teuchos::getValue<std::string>(*e);
  if (e)
    wrong_type(p, path(p.name), type_and_value(*e), "string");
  else if (p.presence == Presence::required)
    missing(p);
  return std::nullopt;
}

void ParameterReader::read(const Parameter& p, std::string* target) {
  const auto value = word(p);
  if (!value) return;
  if (!is_plain_text(*value)) return wrong_value(p, path(p.name), "(not shown)", "UTF-8 text of one line");
  if (value->empty() && p.presence == Presence::required)
    return wrong_value(p, path(p.name), in_quotes(*value), "a word, not empty");
  *target = *value;
}

void ParameterReader::read(const Parameter& p, const Choice& choice) {
  const auto value = word(p);
  if (!value) return;
  const auto found = std::find(choice.words.begin(), choice.words.end(), *value);
  if (found != choice.words.end()) return choice.set(static_cast<std::size_t>(found - choice.words.begin()));
  wrong_value(p, path(p.name), in_quotes(*value),
              (choice.words.size() > 1 ? "one of " : "") + list_of(choice.words) + did_you_mean(*value, choice.words));
}

void ParameterReader::read(const Parameter& p, std::map<std::string, double>* target) {
  if (const ParameterList* list = sublist(p.name))
    for (auto it = list->begin(); it != list->end(); ++it) {
      const std::string where = path(p.name) + " > " + list->name(it);
      if (overrides_.count(where) || problems_.concern(where)) continue;
      const auto value = number(p, where, &list->entry(it), std::nullopt);
      if (value) (*target)[list->name(it)] = *value;
    }
  for (const auto& [name, text] : overridden_below(path(p.name))) {
    const auto value = number(p, path(p.name) + " > " + name, nullptr, text);
    if (value) (*target)[name] = *value;
  }
}

void ParameterReader::read(const Parameter& p, ParameterList* target) {
  if (const ParameterList* list = sublist(p.name)) *target = *list;
  for (const auto& [below, text] : overridden_below(path(p.name))) {
    const auto names = split(below, " > ");
    ParameterList* list = target;
    for (std::size_t i = 0; i + 1 < names.size() && list; ++i) {
      const ParameterEntry* e = list->getEntryPtr(names[i]);
      list = e && !e->isList() ? nullptr : &list->sublist(names[i]);
    }
    const ParameterEntry* old = list ? list->getEntryPtr(names.back()) : nullptr;
    if (!list || (old && old->isList()))
      problems_.add(path(p.name) + " > " + below,
                    " = " + text +
                        " (from --set)\n  meets a Parameter where the list has a ParameterList, or the reverse.\n  "
                        "Give the path of a single parameter.");
    else
      set_from_text(*list, names.back(), text);
  }
  target->setName(p.name);
}

}  // namespace voussoir
