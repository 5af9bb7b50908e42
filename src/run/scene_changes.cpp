#include "run/scene_changes.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

using Values = std::map<std::string, std::string>;

const std::string separator = " > ";

std::string value_of(const Values& values, const std::string& path) {
  const auto found = values.find(path);
  return found == values.end() ? "" : found->second;
}

/// Names of the path from the outermost section on.
std::vector<std::string> names_of(const std::string& path) { return split(path, separator); }

/// The member of a family that a key belongs to, "loads > weight"; "" for a key of no member.
std::string member_of(const std::string& path) {
  const auto names = names_of(path);
  const auto joined = [&](std::size_t count) {
    std::string text = names[0];
    for (std::size_t k = 1; k < count; ++k) text += separator + names[k];
    return text;
  };
  for (const char* family :
       {"materials", "joints", "supports", "loads", "construction", "initial velocities", "observations"})
    if (names[0] == family && names.size() > 2) return joined(2);
  return names[0] == "steps" && names.size() > 3 && names[1] == "stages" ? joined(3) : "";
}

bool has_member(const Values& values, const std::string& member) {
  const std::string start = member + separator;
  const auto found = values.lower_bound(start);
  return found != values.end() && found->first.compare(0, start.size(), start) == 0;
}

/// What lies behind a run, as far as it decides which keys may change.
struct Behind {
  std::set<std::string> stages, loads;  ///< names of stages that have begun, of loads that have acted
  bool in_time = false;                 ///< one of these stages has a duration
  bool searching = false;
};

Behind behind(const Scene& scene, const Passed& passed) {
  Behind b{{}, loads_at_work(scene, passed), false, passed.searching};
  for (std::size_t k = 0; k < std::min(passed.begun(), scene.stages.size()); ++k) {
    b.stages.insert(scene.stages[k].name);
    b.in_time |= scene.stages[k].dynamic();
  }
  return b;
}

/// Which blocks were there in the stages behind, one line for each member of construction that was not always there.
std::map<std::string, std::string> construction_behind(const Values& values, const std::set<std::string>& stages) {
  std::map<std::string, std::string> lines;
  for (const auto& [path, value] : values) {
    const auto names = names_of(path);
    if (names[0] != "construction" || names.size() != 3 || names[2] != "blocks") continue;
    const auto when = [&](const char* key) {
      const std::string stage = value_of(values, "construction > " + names[1] + separator + key);
      return stages.count(stage) > 0 ? stage : std::string(stage.empty() ? "" : "later");
    };
    const std::string from = when("appears"), to = when("disappears");
    // Blocks that go in a later stage have been there like all others.
    if (!from.empty() || (!to.empty() && to != "later")) lines[names[1]] = value + " from " + from + " to " + to;
  }
  return lines;
}

/// What of the blocks that were there in the stages behind is told otherwise now.
std::vector<std::string> changes_of_construction(const Values& before, const Values& now,
                                                 const std::set<std::string>& stages) {
  const auto then = construction_behind(before, stages), here = construction_behind(now, stages);
  std::vector<std::string> changes;
  for (const auto& [name, line] : then)
    if (here.count(name) == 0 || here.at(name) != line)
      changes.push_back("scene > construction > " + name + " was: blocks " + line);
  for (const auto& [name, line] : here)
    if (then.count(name) == 0) changes.push_back("scene > construction > " + name + " is new: blocks " + line);
  return changes;
}

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// Why a key must not change; "" where it may.
std::string reason_to_refuse(const std::string& key, const Behind& behind, bool in_both) {
  for (const auto& load : behind.loads)
    if (begins_with(key, "loads > " + load + separator)) return "load " + in_quotes(load) + " has acted";
  if (behind.in_time)
    for (const char* of_time : {"initial velocities", "steps > time > mass", "steps > time > stiffness damping"})
      if (begins_with(key, of_time)) return "time has begun";
  for (const auto& stage : behind.stages)
    for (const char* part : {"loads", "duration", "at once"})
      if (begins_with(key, "steps > stages > " + stage + separator + part))
        return "stage " + in_quotes(stage) + " has begun";
  if (in_both && begins_with(key, "observations > ") && names_of(key).back() != "tolerance")
    return "rows of history.csv tell of the place as it was";
  return "";
}

/// The list of the members of a family: what is new or gone there is told by its name.
bool is_family(const std::string& key) {
  return key == "loads" || key == "construction" || key == "observations" || key == "steps > stages";
}

/// What a mesh is shows by its nodes and cells, which are compared; but for how its cells bend.
bool is_of_structure(const std::string& key) {
  const auto names = names_of(key);
  const auto& section = names.front();
  return section == "model" || section == "materials" || section == "joints" || section == "supports" ||
         (section == "mesh" && (names.back() == "element" || names.back() == "cells"));
}

std::string was(const std::string& before, const std::string& now) {
  return (now.empty() ? " is left out" : " = " + now) + ", " + (before.empty() ? "was left out" : "was " + before);
}

[[noreturn]] void refuse_structure(const std::string& path, const std::string& key, const std::string& before,
                                   const std::string& now) {
  throw InputError(path + ": is of another structure\n  because its " + names_of(key)[0] +
                   " differ from the scene's: " + key + was(before, now) +
                   ".\n  Give the scene it was computed from, or another --out=DIR.");
}

[[noreturn]] void refuse_past(const std::string& path, const std::vector<std::string>& refused) {
  constexpr std::size_t most = 20;  // a screen full
  std::string all;
  for (std::size_t k = 0; k < std::min(most, refused.size()); ++k) all += "\n  " + refused[k];
  if (refused.size() > most) all += "\n  ... and " + std::to_string(refused.size() - most) + " more";
  throw InputError(path + ": has a past that the scene tells otherwise" + all +
                   ".\n  Leave these as they were: stages that follow may be changed and added, with loads of their "
                   "own. Or compute the scene anew with another --out=DIR.");
}

}  // namespace

std::set<std::string> loads_at_work(const Scene& scene, const Passed& passed) {
  std::set<std::string> loads;
  for (std::size_t k = 0; k < std::min(passed.begun(), scene.stages.size()); ++k)
    for (const auto& [load, factor] : scene.stages[k].factors)
      if (factor != 0) loads.insert(load);
  if (passed.searching)
    for (const auto& [load, share] : scene.load_factor.pattern) loads.insert(load);
  return loads;
}

SetsAtWork sets_at_work(const Scene& scene, const Passed& passed) {
  SetsAtWork sets;
  for (const auto& m : scene.materials) sets.of_blocks.insert(m.parameters.blocks);
  for (const auto& j : scene.joints) sets.of_blocks.insert({j.parameters.between, j.parameters.and_});
  for (const auto& s : scene.supports) {
    sets.of_facets.insert(s.parameters.on);
    sets.of_blocks.insert(s.parameters.blocks);
  }
  const auto loads = loads_at_work(scene, passed);
  for (const auto& load : scene.loads)
    if (loads.count(load.name))
      for (const auto& set : load.sets()) (set.of_blocks ? sets.of_blocks : sets.of_facets).insert(set.name);
  return sets;
}

std::vector<std::string> scene_changes(const SceneValues& before, const SceneValues& now, const Scene& scene,
                                       const Passed& passed, const std::string& path) {
  const Values old_values(before.begin(), before.end()), new_values(now.begin(), now.end());
  const Behind b = behind(scene, passed);
  std::vector<std::string> refused, allowed;
  std::set<std::string> told;  // members that are new or gone
  const auto compare = [&](const std::string& key) {
    const std::string then = value_of(old_values, key), here = value_of(new_values, key);
    if (then == here || is_family(key)) return;
    if (is_of_structure(key)) refuse_structure(path, key, then, here);
    const std::string member = member_of(key);
    const bool in_both = has_member(old_values, member) && has_member(new_values, member);
    const std::string why = reason_to_refuse(key, b, in_both);
    if (!why.empty())
      refused.push_back("scene > " + key + was(then, here) + " (" + why + ")");
    else if (member.empty() || in_both)
      allowed.push_back(key + was(then, here));
    else if (told.insert(member).second)
      allowed.push_back(member + (has_member(old_values, member) ? " is there no more" : " is new"));
  };
  for (const auto& [key, value] : now) compare(key);
  for (const auto& [key, value] : before)
    if (new_values.count(key) == 0) compare(key);
  const auto built = changes_of_construction(old_values, new_values, b.stages);
  refused.insert(refused.end(), built.begin(), built.end());
  if (!refused.empty()) refuse_past(path, refused);
  return allowed;
}

}  // namespace voussoir
