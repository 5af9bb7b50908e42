#include "scene/json_printer.hpp"

#include <cmath>
#include <utility>

#include "scene/scene_printer.hpp"
#include "scene/scene_sections.hpp"
#include "scene/xml_printer.hpp"

namespace voussoir {
namespace {

using Json = nlohmann::ordered_json;

struct TypeOf {
  const char* operator()(const double*) const { return "double"; }
  const char* operator()(const int*) const { return "int"; }
  const char* operator()(const bool*) const { return "bool"; }
  const char* operator()(const std::string*) const { return "string"; }
  const char* operator()(const Choice&) const { return "string"; }
  const char* operator()(const std::map<std::string, double>*) const { return "numbers"; }
  const char* operator()(const Teuchos::ParameterList*) const { return "list"; }
};

void set(Json& member, const char* key, const std::string& text) {
  if (!text.empty()) member[key] = text;
}

/// As the type has it; infinity is no number of JSON and stays a word.
Json default_of(const Parameter& p) {
  if (const auto* v = std::get_if<int*>(&p.value)) return **v;
  if (const auto* v = std::get_if<bool*>(&p.value)) return **v;
  if (const auto* v = std::get_if<double*>(&p.value))
    if (std::isfinite(**v)) return **v;
  return value_text(p);
}

}  // namespace

void JsonPrinter::visit(const Parameter& p) {
  Json member{{"key", p.name}, {"type", std::visit(TypeOf{}, p.value)}};
  const std::string type = member["type"];
  set(member, "with", choice_);
  if (type == "double" || type == "int" || type == "numbers") {
    set(member, "unit", p.unit);
    member["range"] = p.range.text();
    set(member, "usually", p.range.usual_text());
  }
  if (const auto* choice = std::get_if<Choice>(&p.value)) member["words"] = choice->words;
  if (p.presence == Presence::required)
    member["required"] = true;
  else if (type != "numbers" && type != "list" && !value_text(p).empty())
    member["default"] = default_of(p);
  set(member, "text", p.text);
  set(member, "why", p.why);
  set(member, "advice", p.advice);
  add(std::move(member));
}

void JsonPrinter::add_list(Json list, const std::function<void()>& declare) {
  set(list, "with", choice_);
  list["members"] = Json::array();
  lists_.push_back(std::move(list));
  const auto outer = std::exchange(choice_, "");
  declare();
  choice_ = outer;
  Json closed = std::move(lists_.back());
  lists_.pop_back();
  add(std::move(closed));
}

void JsonPrinter::visit(const Subsection& section, const std::function<void()>& declare) {
  const auto outer = choice_;
  if (!section.choice.empty()) choice_ = section.choice;
  if (section.name.empty())
    declare();
  else
    add_list({{"section", section.name}, {"text", section.text}}, declare);
  choice_ = outer;
}

void JsonPrinter::visit(const Family& family) {
  add_list({{"family", family.name}, {"text", family.text}, {"example", family.example}},
           [&] { family.declare(family.example); });
}

void print_reference_as_json(std::ostream& os) {
  JsonPrinter printer;
  Scene empty;
  declare(empty, printer);
  os << printer.json().dump(1) << '\n';
}

}  // namespace voussoir
