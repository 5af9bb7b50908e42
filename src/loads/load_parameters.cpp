#include "loads/load_parameters.hpp"

#include <utility>

#include "base/parameter_section.hpp"

namespace voussoir {
namespace {

constexpr std::size_t kinds = std::variant_size_v<LoadKind>;
using AllKinds = std::make_index_sequence<kinds>;

template <std::size_t... k>
std::vector<std::string> words(std::index_sequence<k...>) {
  return {std::variant_alternative_t<k, LoadKind>::word...};
}

/// A load of the k-th type with its defaults.
template <std::size_t... k>
LoadKind made(std::size_t wanted, std::index_sequence<k...>) {
  LoadKind kind;
  ((k == wanted ? void(kind.emplace<k>()) : void()), ...);
  return kind;
}

template <std::size_t k>
void declare_kind(LoadKind& kind, ParameterSection& section) {
  using Kind = std::variant_alternative_t<k, LoadKind>;
  Kind other;
  const bool chosen = kind.index() == k;
  section.add_alternative("", chosen ? *std::get_if<k>(&kind) : other, chosen, std::string("type = ") + Kind::word,
                          Kind::text);
}

template <std::size_t... k>
void declare_kinds(LoadKind& kind, ParameterSection& section, std::index_sequence<k...>) {
  (declare_kind<k>(kind, section), ...);
}

}  // namespace

std::vector<std::string> load_words() { return words(AllKinds{}); }

void LoadParameters::declare(ParameterSection& section) {
  std::vector<std::pair<std::string, std::size_t>> choices;
  for (const std::string& w : load_words()) choices.emplace_back(w, choices.size());
  std::size_t type = kind.index();
  section.add_choice<std::size_t>("type", type, choices, "kind of load; the other keys depend on it",
                                  Presence::required);
  if (type != kind.index()) kind = made(type, AllKinds{});
  declare_kinds(kind, section, AllKinds{});
  section.add_section("time function", time_function, "how the load varies with time, times its factor of the stage");
}

std::string LoadParameters::word() const {
  return std::visit([](const auto& k) { return std::string(k.word); }, kind);
}

std::string LoadParameters::summary() const {
  const std::string text = std::visit([](const auto& k) { return k.summary(); }, kind);
  return time_function.type == TimeFunctionType::constant ? text : text + ", varying with time";
}

bool LoadParameters::is_zero() const {
  return std::visit([](const auto& k) { return k.is_zero(); }, kind);
}

std::vector<KeyOfSpace> LoadParameters::keys_of_space() const {
  return std::visit([](const auto& k) { return k.keys_of_space(); }, kind);
}

std::vector<SetOfLoad> LoadParameters::sets() const {
  return std::visit([](const auto& k) { return k.sets(); }, kind);
}

std::optional<FacetsOfLoad> LoadParameters::facets() const {
  return std::visit([](const auto& k) { return k.facets(); }, kind);
}

std::vector<FileOfLoad> LoadParameters::files() {
  auto files = std::visit([](auto& k) { return k.files(); }, kind);
  if (time_function.type == TimeFunctionType::record) files.push_back({"time function > file", &time_function.file});
  return files;
}

}  // namespace voussoir
