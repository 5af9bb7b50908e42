#include "scene/xml_printer.hpp"

#include <sstream>

#include "base/text.hpp"
#include "scene/scene_xml.hpp"

namespace voussoir {
namespace {

constexpr std::size_t width = 116;  // columns a comment may fill before it is wrapped

/// Comments must not hold two hyphens in a row.
std::string fit_for_comment(std::string text) {
  for (std::size_t at; (at = text.find("--")) != std::string::npos;) text.insert(at + 1, " ");
  return text;
}

std::string after(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + " > " + name;
}

/// Type and value of a parameter that is a single value.
struct Text {
  std::string type, value;
};

struct TextOf {
  Text operator()(const double* v) const { return {"double", number_text(*v)}; }
  Text operator()(const int* v) const { return {"int", std::to_string(*v)}; }
  Text operator()(const bool* v) const { return {"bool", *v ? "true" : "false"}; }
  Text operator()(const std::string* v) const { return {"string", *v}; }
  Text operator()(const Choice& c) const { return {"string", c.words[c.get()]}; }
  Text operator()(const std::map<std::string, double>*) const { return {}; }
  Text operator()(const Teuchos::ParameterList*) const { return {}; }
};

}  // namespace

std::string value_text(const Parameter& p) { return std::visit(TextOf{}, p.value).value; }

void XmlPrinter::line(const std::string& text) {
  os_ << std::string(static_cast<std::size_t>(2 * depth_), ' ') << (in_comment_ ? fit_for_comment(text) : text) << '\n';
}

void XmlPrinter::open(const std::string& name) {
  line("<ParameterList name=\"" + xml_escaped(name) + "\">");
  ++depth_;
}

void XmlPrinter::close() {
  --depth_;
  line("</ParameterList>");
}

void XmlPrinter::remark(const std::string& text) {
  std::istringstream words(fit_for_comment(text));
  const std::string margin(static_cast<std::size_t>(2 * depth_), ' ');
  std::string now = in_comment_ ? "    " : "<!-- ", word;
  const std::size_t start = now.size();
  const std::string next(in_comment_ ? 4 : 5, ' ');
  bool first = true;
  while (words >> word) {
    if (!first && margin.size() + now.size() + word.size() > width) {
      os_ << margin << now << '\n';
      now = next;
      first = true;
    }
    now += (first || now.size() == start ? "" : " ") + word;
    first = false;
  }
  os_ << margin << now << (in_comment_ ? "" : " -->") << '\n';
}

void XmlPrinter::begin_comment(const std::string& text) {
  if (in_comment_++ > 0) {
    --in_comment_;
    remark(text);
    ++in_comment_;
    return;
  }
  --in_comment_;
  os_ << std::string(static_cast<std::size_t>(2 * depth_), ' ') << "<!--\n";
  ++in_comment_;
  ++depth_;
  remark(text);
}

void XmlPrinter::end_comment() {
  if (--in_comment_ > 0) return;
  --depth_;
  line("-->");
}

std::string XmlPrinter::documentation(const Parameter& p) const {
  const bool number = std::holds_alternative<double*>(p.value) || std::holds_alternative<int*>(p.value) ||
                      std::holds_alternative<std::map<std::string, double>*>(p.value);
  std::string text;
  if (number) {
    text = (p.unit.empty() ? "" : "[" + p.unit + "] ") + p.range.text();
    if (const auto usual = p.range.usual_text(); !usual.empty()) text += ", usually " + usual;
  } else if (const Choice* choice = std::get_if<Choice>(&p.value)) {
    for (const std::string& word : choice->words) text += (text.empty() ? "" : " | ") + word;
  }
  const auto found = defaults_.find(key(p.name));
  const std::string known = p.presence == Presence::required                    ? "required"
                            : found == defaults_.end() || found->second.empty() ? ""
                                                                                : "default " + found->second;
  if (!known.empty()) text += (text.empty() ? "" : ", ") + known;
  return text + (text.empty() ? "" : ": ") + p.text;
}

void XmlPrinter::element(const Parameter& p) {
  if (const auto* numbers = std::get_if<std::map<std::string, double>*>(&p.value)) {
    open(p.name);
    for (const auto& [name, value] : **numbers) line(xml_parameter(name, "double", number_text(value)));
    close();
  } else if (const auto* list = std::get_if<Teuchos::ParameterList*>(&p.value)) {
    open(p.name);
    os_ << xml_from_list(**list, 2 * depth_);
    close();
  } else {
    const Text text = std::visit(TextOf{}, p.value);
    line(xml_parameter(p.name, text.type, text.value));
  }
}

void XmlPrinter::visit(const Parameter& p) {
  const bool tell = documented_ && told_.insert(key(p.name)).second;
  if (tell && !in_comment_) remark(documentation(p));
  element(p);
  if (tell && in_comment_) remark(documentation(p));
}

void XmlPrinter::visit(const Subsection& section, const std::function<void()>& declare) {
  if (!section.chosen && (section.name.empty() || !documented_)) return;
  const std::string outer = path_;
  if (!section.chosen)
    begin_comment("With " + section.choice + " instead. " + section.text + ".");
  else if (documented_ && !section.choice.empty() && told_.insert(key("with " + section.choice)).second)
    remark("With " + section.choice + ". " + section.text + ".");
  else if (documented_ && !section.name.empty())
    remark(section.text);
  if (section.name.empty()) {
    declare();
  } else {
    path_ = key(section.name);
    open(section.name);
    declare();
    close();
    path_ = outer;
  }
  if (!section.chosen) end_comment();
}

void XmlPrinter::visit(const Family& family) {
  const std::string outer = path_;
  const bool only_example = family.names.empty() && documented_;
  if (family.names.empty() && !documented_) return;
  if (only_example)
    begin_comment(family.text + "; names are free:");
  else if (documented_)
    remark(family.text + "; names are free");
  open(family.name);
  path_ = key(family.name) + " > *";
  for (const std::string& name : only_example ? std::vector<std::string>{family.example} : family.names) {
    open(name);
    family.declare(name);
    close();
  }
  path_ = outer;
  close();
  if (only_example) end_comment();
}

void DefaultsCollector::visit(const Parameter& p) { defaults[after(path_, p.name)] = value_text(p); }

void DefaultsCollector::visit(const Subsection& section, const std::function<void()>& declare) {
  const std::string outer = path_;
  if (!section.name.empty()) path_ = after(path_, section.name);
  declare();
  path_ = outer;
}

void DefaultsCollector::visit(const Family& family) {
  const std::string outer = path_;
  path_ = after(path_, family.name) + " > *";
  family.declare(family.example);
  path_ = outer;
}

}  // namespace voussoir
