#include "stones/stone_names.hpp"

#include <map>
#include <set>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// Names and places can be shown by every program that reads what is written of a run.
void make_plain(std::vector<StonesOfFile>& files) {
  for (auto& file : files) {
    file.stem = as_utf8(file.stem);
    for (auto& stone : file.stones) {
      stone.name = trimmed(as_utf8(stone.name));
      stone.origin = as_utf8(stone.origin);
      if (stone.name.empty()) stone.name = file.stem;
    }
  }
}

void name_by_files(std::vector<StonesOfFile>& files) {
  std::map<std::string, std::set<const StonesOfFile*>> of_name;
  for (const auto& file : files)
    for (const auto& stone : file.stones) of_name[stone.name].insert(&file);
  for (auto& file : files)
    for (auto& stone : file.stones)
      if (of_name[stone.name].size() > 1)
        stone.name = file.stones.size() == 1 ? file.stem : file.stem + " " + stone.name;
}

void number_what_repeats(std::vector<StoneSurface>& stones, Warnings& warnings) {
  std::map<std::string, int> times, given;
  for (const auto& stone : stones) ++times[stone.name];
  std::set<std::string> names;
  for (const auto& [name, count] : times) names.insert(name);
  std::size_t numbered = 0;
  std::string first;
  for (auto& stone : stones) {
    const std::string name = stone.name;
    if (times[name] == 1) continue;
    do stone.name = name + " " + std::to_string(++given[name]);
    while (!names.insert(stone.name).second);
    if (numbered++ == 0)
      first = in_quotes(name) + ", of " + std::to_string(times[name]) + " stones (" + stone.origin + " is " +
              in_quotes(stone.name) + ")";
  }
  if (numbered == 0) return;
  add_warning(warnings, {"names_repeated", "mesh > stones > file", "", static_cast<double>(numbered),
                         counted(numbered, "stone has the name", "stones have the names") +
                             " of others and are numbered, first " + first +
                             ": give them names that differ where a scene is to say which it means"});
}

}  // namespace

std::vector<StoneSurface> with_names_that_differ(std::vector<StonesOfFile> files, Warnings& warnings) {
  make_plain(files);
  name_by_files(files);
  std::vector<StoneSurface> stones;
  for (auto& file : files)
    for (auto& stone : file.stones) stones.push_back(std::move(stone));
  number_what_repeats(stones, warnings);
  return stones;
}

}  // namespace voussoir
