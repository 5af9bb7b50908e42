#include "base/parameter_reader.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace voussoir {
namespace {

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

const ParameterList& no_list() {
  static const ParameterList list;
  return list;
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return "\n  " + text + (text.back() == '.' ? "" : ".");
}

/// The value and type of an entry as messages show them.
std::string shown(const ParameterEntry& entry) {
  if (entry.isType<double>()) return number_text(Teuchos::getValue<double>(entry)) + " (double)";
  if (entry.isType<int>()) return std::to_string(Teuchos::getValue<int>(entry)) + " (int)";
  if (entry.isType<bool>()) return std::string(Teuchos::getValue<bool>(entry) ? "true" : "false") + " (bool)";
  if (entry.isType<std::string>()) return in_quotes(Teuchos::getValue<std::string>(entry)) + " (string)";
  return entry.isList() ? "a ParameterList" : "a value of another type";
}

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

ParameterReader::ParameterReader(const ParameterList& root, const Overrides& overrides, InputProblems& problems)
    : overrides_(overrides), problems_(problems) {
  frames_.push_back({&root, "scene", {}, {}});
}

const ParameterEntry* ParameterReader::entry(const std::string& name) const {
  return frames_.back().list->getEntryPtr(name);
}

std::optional<std::string> ParameterReader::overridden(const std::string& path) {
  const auto found = overrides_.find(path);
  if (found == overrides_.end()) return std::nullopt;
  used_.insert(path);
  return found->second;
}

std::map<std::string, std::string> ParameterReader::overridden_below(const std::string& path) {
  std::map<std::string, std::string> below;
  const std::string start = path + " > ";
  for (const auto& [where, text] : overrides_)
    if (where.compare(0, start.size(), start) == 0) {
      used_.insert(where);
      below[where.substr(start.size())] = text;
    }
  return below;
}

const ParameterList* ParameterReader::sublist(const std::string& name) {
  const ParameterEntry* found = entry(name);
  if (!found) return nullptr;
  if (found->isList()) return &frames_.back().list->sublist(name);
  problems_.add(path(name), " = " + shown(*found) +
                                "\n  must be a ParameterList, not a Parameter.\n  Write <ParameterList name=" +
                                in_quotes(name) + "> with its keys inside.");
  return nullptr;
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
  problems_.add(path(p.name), " is missing.\n  A scene needs it: " + p.text + "." + sentence(p.advice));
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
    if (entry) wrong_type(p, path, shown(*entry), "double");
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
    return wrong_type(p, path(p.name), shown(*e), "int");
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
    wrong_type(p, path(p.name), shown(*e), "bool");
  }
}

std::optional<std::string> ParameterReader::word(const Parameter& p) {
  const auto given = overridden(path(p.name));
  if (given) return given;
  const ParameterEntry* e = entry(p.name);
  if (e && e->isType<std::string>()) return Teuchos::getValue<std::string>(*e);
  if (e)
    wrong_type(p, path(p.name), shown(*e), "string");
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

void ParameterReader::visit(const Parameter& p) {
  Frame& frame = frames_.back();
  if (!hidden_.empty()) {
    frame.elsewhere[p.name] = hidden_;
    return;
  }
  frame.known.push_back(p.name);
  paths_.push_back(path(p.name));
  const bool scalar = !std::holds_alternative<std::map<std::string, double>*>(p.value) &&
                      !std::holds_alternative<ParameterList*>(p.value);
  if (scalar && problems_.concern(path(p.name)) && !overrides_.count(path(p.name))) return;
  std::visit([&](const auto& target) { read(p, target); }, p.value);
}

void ParameterReader::enter(const std::string& name, const ParameterList* list) {
  frames_.push_back({list ? list : &no_list(), path(name), {}, {}});
}

void ParameterReader::leave() {
  const Frame& frame = frames_.back();
  for (auto it = frame.list->begin(); it != frame.list->end(); ++it) {
    const std::string& name = frame.list->name(it);
    if (std::find(frame.known.begin(), frame.known.end(), name) != frame.known.end()) continue;
    const auto other = frame.elsewhere.find(name);
    if (other != frame.elsewhere.end())
      problems_.add(path(name), " is present\n  but belongs to " + other->second +
                                    ", which this section has not chosen.\n  Remove it, or choose " + other->second +
                                    ".");
    else
      problems_.add(path(name), " is not known here" + did_you_mean(name, frame.known) + ".\n  " +
                                    in_quotes(frame.path) + " knows: " + list_of(frame.known) + ".");
  }
  frames_.pop_back();
}

void ParameterReader::visit(const Subsection& section, const std::function<void()>& declare) {
  Frame& frame = frames_.back();
  if (!hidden_.empty() || (!section.chosen && !section.name.empty())) {
    if (!section.name.empty()) frame.elsewhere[section.name] = section.chosen ? hidden_ : section.choice;
    if (section.name.empty()) declare();
  } else if (!section.chosen) {
    hidden_ = section.choice;
    declare();
    hidden_.clear();
  } else if (section.name.empty()) {
    declare();
  } else {
    frame.known.push_back(section.name);
    enter(section.name, sublist(section.name));
    declare();
    leave();
  }
}

void ParameterReader::visit(const Family& family) {
  Frame& frame = frames_.back();
  if (!hidden_.empty()) {
    frame.elsewhere[family.name] = hidden_;
    return;
  }
  frame.known.push_back(family.name);
  const ParameterList* members = sublist(family.name);
  enter(family.name, members);
  if (members)
    for (auto it = members->begin(); it != members->end(); ++it) {
      const std::string name = members->name(it);
      frames_.back().known.push_back(name);
      const ParameterList* member = sublist(name);
      if (!member) continue;
      enter(name, member);
      family.declare(name);
      leave();
    }
  leave();
}

void ParameterReader::refuse(const std::string& name, const std::string& value, const std::string& why,
                             const std::string& advice) {
  if (!hidden_.empty() || problems_.concern(frames_.back().path)) return;
  problems_.add(path(name), (value.empty() ? "" : " = " + value) + "\n  " + why + "." + sentence(advice));
}

}  // namespace voussoir
