// Declared parameters as JSON, for programs that read and write scenes.
//
// The root is {"members": [...]}. A member is one of
//   {"key": name, "type", "unit", "range", "usually", "words", "default", "required", "text", "why", "advice"}
//   {"section": name, "text", "members": [...]}
//   {"family": name, "text", "example", "members": [...]}   sublists whose names are free, each with these members
// and has "with": "type = wall" where it exists for that choice of its list alone. Types are those of a scene: double,
// int, bool, string; numbers, a sublist of doubles under free names; list, a sublist passed on as it is. What is empty
// is left out.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/parameter_section.hpp"

namespace voussoir {

class JsonPrinter final : public ParameterSection {
 public:
  const nlohmann::ordered_json& json() const { return lists_.front(); }

 private:
  void visit(const Parameter&) override;
  void visit(const Subsection&, const std::function<void()>& declare) override;
  void visit(const Family&) override;
  void refuse(const std::string&, const std::string&, const std::string&, const std::string&) override {}

  void add(nlohmann::ordered_json member) { lists_.back()["members"].push_back(std::move(member)); }
  /// A member with the members that `declare` adds.
  void add_list(nlohmann::ordered_json list, const std::function<void()>& declare);

  std::vector<nlohmann::ordered_json> lists_{{{"members", nlohmann::ordered_json::array()}}};  ///< open ones
  std::string choice_;  ///< what the keys that are declared belong to
};

}  // namespace voussoir
