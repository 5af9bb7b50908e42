#include "base/parameter_reader.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "base/words.hpp"

namespace voussoir {
namespace {

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

const ParameterList& no_list() {
  static const ParameterList list;
  return list;
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
  problems_.add(path(name), " = " + type_and_value(*found) +
                                "\n  must be a ParameterList, not a Parameter.\n  Write <ParameterList name=" +
                                in_quotes(name) + "> with its keys inside.");
  return nullptr;
}

void ParameterReader::visit(const Parameter& p) {
  Frame& frame = frames_.back();
  if (undecided_ || !hidden_.empty()) return record(p.name);
  frame.known.push_back(p.name);
  paths_.push_back(path(p.name));
  const bool scalar = !std::holds_alternative<std::map<std::string, double>*>(p.value) &&
                      !std::holds_alternative<ParameterList*>(p.value);
  if (scalar && problems_.concern(path(p.name)) && !overrides_.count(path(p.name))) return;
  std::visit([&](const auto& target) { read(p, target); }, p.value);
}

/// Remembers a declared name whose value is not to be read.
void ParameterReader::record(const std::string& name) {
  if (undecided_)
    frames_.back().known.push_back(name);
  else
    frames_.back().elsewhere[name] += (frames_.back().elsewhere[name].empty() ? "" : " or ") + hidden_;
}

void ParameterReader::enter(const std::string& name, const ParameterList* list) {
  frames_.push_back({list ? list : &no_list(), path(name), {}, {}});
}

void ParameterReader::leave() {
  const Frame& frame = frames_.back();
  const std::set<std::string> known(frame.known.begin(), frame.known.end());
  for (auto it = frame.list->begin(); it != frame.list->end(); ++it) {
    const std::string& name = frame.list->name(it);
    if (known.count(name)) continue;
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
  if (undecided_ || !hidden_.empty()) {
    if (section.name.empty()) return declare();
    return record(section.name);
  }
  const bool undecided = !section.choice.empty() && problems_.at(path(split(section.choice, " = ").front()));
  if (undecided && section.name.empty()) {
    undecided_ = true;
    declare();
    undecided_ = false;
  } else if (undecided) {
    frames_.back().known.push_back(section.name);
  } else if (!section.chosen && !section.name.empty()) {
    frames_.back().elsewhere[section.name] = section.choice;
  } else if (!section.chosen) {
    hidden_ = section.choice;
    declare();
    hidden_.clear();
  } else if (section.name.empty()) {
    declare();
  } else {
    frames_.back().known.push_back(section.name);
    enter(section.name, sublist(section.name));
    declare();
    leave();
  }
}

void ParameterReader::visit(const Family& family) {
  Frame& frame = frames_.back();
  if (undecided_ || !hidden_.empty()) return record(family.name);
  frame.known.push_back(family.name);
  const ParameterList* members = sublist(family.name);
  enter(family.name, members);
  constexpr int most_members = 10000;  // more are no scene, and would take minutes to compare
  if (members && members->numParams() > most_members) {
    problems_.add(frames_.back().path, " has " + counted(members->numParams(), "member") + "\n  must have at most " +
                                           std::to_string(most_members) +
                                           ".\n  Give sets of blocks or facets one member each.");
    for (auto it = members->begin(); it != members->end(); ++it) frames_.back().known.push_back(members->name(it));
  } else if (members)
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
  if (undecided_ || !hidden_.empty() || problems_.concern(frames_.back().path)) return;
  problems_.add(path(name), (value.empty() ? "" : " = " + value) + "\n  " + why + "." + sentence(advice));
}

}  // namespace voussoir
