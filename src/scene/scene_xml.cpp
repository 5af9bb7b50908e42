#include "scene/scene_xml.hpp"

#include <Teuchos_XMLObject.hpp>
#include <Teuchos_XMLParameterListReader.hpp>
#include <Teuchos_XMLParameterListWriter.hpp>
#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "base/text.hpp"

namespace voussoir {
namespace {

using Teuchos::ParameterList;
using Teuchos::XMLObject;

constexpr std::size_t largest_text = 16u << 20;  // bytes; a scene written by hand has some thousands
constexpr int deepest_nesting = 32;              // lists within lists; a scene needs 5, MueLu's factories some more
constexpr std::size_t longest_name = 200;        // bytes; a path of such names still fits into a message

/// Text fit for a message: short, and in UTF-8.
std::string shown(const std::string& text) { return is_plain_text(text) ? shortened(text, 60) : "(not UTF-8)"; }

std::string line_of(const std::string& text, std::ptrdiff_t offset) {
  return "line " + std::to_string(1 + std::count(text.begin(), text.begin() + offset, '\n'));
}

std::string declared(const std::string& what, const std::string& line) {
  return " holds " + what + " in " + line +
         ".\n  Declarations, entities and CDATA are refused (they can make a small file huge).\n"
         "  Remove them; a scene needs only ParameterList and Parameter.";
}

/// Whether every & of a text as it stands in the file begins a letter: &lt; or &#233;, but not zero, which ends a text.
bool escapes_are_letters(const std::string& raw) {
  for (std::size_t at = raw.find('&'); at != std::string::npos; at = raw.find('&', at + 1)) {
    const std::string name = raw.substr(at + 1, raw.find(';', at) - at - 1);
    const bool hex = name.compare(0, 2, "#x") == 0;
    const std::size_t start = hex ? 2 : 1;
    const bool digits =
        name.size() > start && name.size() < 10 && name[0] == '#' &&
        name.find_first_not_of(hex ? "0123456789abcdefABCDEF" : "0123456789", start) == std::string::npos;
    const unsigned long code = digits ? std::stoul(name.substr(start), nullptr, hex ? 16 : 10) : 0;
    const bool named = name == "lt" || name == "gt" || name == "amp" || name == "quot" || name == "apos";
    if (!named && (code == 0 || code > 0x10ffff)) return false;
  }
  return true;
}

/// Why an element is refused with all that is in it, or "". It is read with its escapes as they stand in the file.
std::string refusal(const pugi::xml_node& node, const std::string& text, int depth) {
  const auto line = [&](const pugi::xml_node& of) { return line_of(text, of.offset_debug()); };
  if (node.type() == pugi::node_doctype) return declared("a DOCTYPE", line(node));
  if (node.type() == pugi::node_cdata) return declared("CDATA", line(node));
  if (depth > deepest_nesting)
    return " nests lists deeper than " + std::to_string(deepest_nesting) + " in " + line(node) +
           ".\n  Close the lists with </ParameterList>, or write them flatter.";
  std::set<std::string> names;
  for (const auto& attribute : node.attributes()) {
    if (!names.insert(attribute.name()).second)
      return " holds an element in " + line(node) + " that gives " + in_quotes(shown(attribute.name())) +
             " twice\n  but an attribute may appear once (which one should count?).\n  Remove one.";
    if (!escapes_are_letters(attribute.value()))
      return " holds " + in_quotes(shown(attribute.value())) + " in " + line(node) +
             "\n  where an & does not begin a letter.\n  Write &amp; for &, and letters as they are in UTF-8.";
  }
  for (const auto& child : node.children())
    if (const auto refused = refusal(child, text, depth + (child.type() == pugi::node_element)); !refused.empty())
      return refused;
  return "";
}

/// Why what was read is not one element, or "".
std::string why_not_one_root(const pugi::xml_document& document, const std::string& text) {
  int roots = 0;
  for (const auto& node : document.children()) {
    if (node.type() == pugi::node_pcdata && !trimmed(node.value()).empty())
      return "text stands outside of its list: " + in_quotes(shown(trimmed(node.value()))) + ".";
    if (node.type() == pugi::node_element && ++roots > 1)
      return "it has more than one root element, the second in " + line_of(text, node.offset_debug()) + ".";
  }
  return roots == 1 ? "" : "it holds no element.";
}

/// Why a text that the parser has read as far as it can is no XML, or "".
std::string error_of(const pugi::xml_document& document, const pugi::xml_parse_result& result,
                     const std::string& text) {
  const auto before = [&](const char* tag) {
    return result.offset >= 2 && text.compare(result.offset - 2, 2, tag) == 0;
  };
  const std::string start = " cannot be read as XML\n  because ", line = line_of(text, result.offset);
  if (result.status == pugi::status_bad_doctype) return declared("a DOCTYPE", line);
  if (result.status == pugi::status_bad_cdata) return declared("CDATA", line);
  if (result.status == pugi::status_unrecognized_tag && before("<!"))
    return declared(text.compare(result.offset, 6, "ENTITY") == 0 ? "an ENTITY" : "a declaration <!...>", line);
  if (result.status == pugi::status_end_element_mismatch) {
    const auto open = document.find_node([&](const pugi::xml_node& node) {
      const auto begin = static_cast<std::size_t>(node.offset_debug());
      const bool ended = node.first_child() ? false : text.find("/>", begin) < static_cast<std::size_t>(result.offset);
      return node.name() == std::string("Parameter") && !ended;
    });
    if (open) return start + "the Parameter of " + line_of(text, open.offset_debug()) + " is not ended by />.";
    if (!before("</")) return start + "the file ends before all its lists are closed.";
    const std::string tag = text.substr(result.offset, text.find('>', result.offset) - result.offset);
    return start + "</" + shown(trimmed(tag)) + "> in " + line + " does not end the element that is open there.";
  }
  if (!result) return start + "of an error in " + line + ": " + result.description() + ".";
  const auto why = why_not_one_root(document, text);
  return why.empty() ? "" : start + why;
}

/// What must not be read as a scene: @return why and what to do, or "".
std::string guarded(const std::string& text, const std::string& example) {
  if (text.size() > largest_text)
    return "\n  is larger than 16 MB, which no scene is.\n  Geometry belongs into a file of gmsh.";
  if (trimmed(text).empty()) return "\n  is missing: the file is empty." + example;
  if (text.find('\0') != std::string::npos) return " holds a zero byte.\n  Save it as XML text in UTF-8.";
  pugi::xml_document document;
  const auto all = (pugi::parse_full | pugi::parse_fragment) & ~pugi::parse_escapes;
  const auto result = document.load_buffer(text.data(), text.size(), all, pugi::encoding_utf8);
  if (const auto refused = refusal(document, text, -1); !refused.empty()) return refused;
  const auto error = error_of(document, result, text);
  return error.find("as XML") == std::string::npos ? error : error + example;
}

class TreeReader {
 public:
  TreeReader(const std::string& text, InputProblems& problems) : text_(text), problems_(problems) {}

  void read(const pugi::xml_node& xml, ParameterList& list, const std::string& path) {
    std::map<std::string, pugi::xml_node> members;
    bool tells = false;  // of text: once
    for (const auto& child : xml.children()) {
      if (child.type() == pugi::node_pcdata && !tells) {
        tells = true;
        problems_.add(path, " holds the text " + in_quotes(shown(trimmed(child.value()))) +
                                "\n  but text between elements has no meaning.\n  Put notes into <!-- comments -->.");
      }
      if (child.type() != pugi::node_element || !is_member(child, path)) continue;
      const std::string name = child.attribute("name").value(), here = path + " > " + name;
      const auto [first, is_new] = members.emplace(name, child);
      if (!is_new)
        problems_.add(here, " is there twice, in " + line_of(text_, first->second.offset_debug()) + " and " +
                                line_of(text_, child.offset_debug()) +
                                "\n  but a name may appear once in a list (which one should count?).\n  Remove or "
                                "rename one.");
      else if (child.name() == std::string("ParameterList"))
        read(child, list.sublist(name), here);
      else
        read_parameter(child, list, name, here);
    }
  }

 private:
  /// Whether an element is a list or a parameter with a name.
  bool is_member(const pugi::xml_node& child, const std::string& path) {
    const std::string tag = child.name(), name = child.attribute("name").value();
    if (tag != "ParameterList" && tag != "Parameter") {
      problems_.add(path, " holds an element <" + shown(tag) + ">\n  but only ParameterList and Parameter are known" +
                              did_you_mean(tag, {"ParameterList", "Parameter"}) + ".\n  Correct or remove it.");
      return false;
    }
    if (!name.empty() && name.size() <= longest_name && is_plain_text(name)) return true;
    problems_.add(path, " holds a " + tag +
                            (name.empty() ? " without a name"
                                          : " whose name is not UTF-8 text of one line or longer than 200 letters") +
                            ".\n  Give it a name: <" + tag + " name=\"...\">");
    return false;
  }

  void read_parameter(const pugi::xml_node& xml, ParameterList& list, const std::string& name,
                      const std::string& path) {
    for (const char* needed : {"type", "value"})
      if (!xml.attribute(needed)) {
        const std::string other = std::string(needed) == "type" ? "double, int, bool or string" : "its value";
        return problems_.add(path, std::string(" has no attribute ") + needed +
                                       ".\n  A Parameter needs name, type and value.\n  Add " + needed + "=\"...\", " +
                                       other + ".");
      }
    if (xml.first_child())
      return problems_.add(
          path, " is a Parameter with elements inside.\n  Only a ParameterList holds others.\n  End it by /> .");
    const std::string type = xml.attribute("type").value(), value = xml.attribute("value").value();
    if (!is_plain_text(value))
      return problems_.add(path,
                           "\n  is not UTF-8 text without control characters.\n  Save the scene in UTF-8, and write "
                           "letters as they are.");
    if (type == "string") {
      list.set(name, value);
    } else if (type == "double") {
      if (const auto number = number_in(value))
        list.set(name, *number);
      else
        unreadable(path, value, "a number, such as 0.25 or 2e9 or inf (no unit, no comma)");
    } else if (type == "int") {
      if (const auto number = whole_number_in(value))
        list.set(name, *number);
      else
        unreadable(path, value, "a whole number of at most ten digits (type=\"int\")");
    } else if (type == "bool") {
      if (const auto truth = truth_in(value))
        list.set(name, *truth);
      else
        unreadable(path, value, "true or false (type=\"bool\")");
    } else {
      read_by_teuchos(list, name, path, type, value);
    }
  }

  void unreadable(const std::string& path, const std::string& value, const std::string& must) {
    problems_.add(path,
                  " = " + in_quotes(shown(value)) + "\n  must be " + must + ".\n  Correct the value or the type.");
  }

  /// Types only lists for Belos and MueLu need, such as Array(double).
  void read_by_teuchos(ParameterList& list, const std::string& name, const std::string& path, const std::string& type,
                       const std::string& value) {
    XMLObject parameter("Parameter"), lone("ParameterList");
    parameter.addAttribute("name", name);
    parameter.addAttribute("type", type);
    parameter.addAttribute("value", value);
    lone.addChild(parameter);
    try {
      list.setParametersNotAlreadySet(Teuchos::XMLParameterListReader().toParameterList(lone));
    } catch (const std::exception&) {
      const std::vector<std::string> types{"double", "int", "bool", "string"};
      problems_.add(path, " = " + in_quotes(shown(value)) + " of type " + in_quotes(shown(type)) +
                              "\n  cannot be read: the type is one of " + list_of(types) + did_you_mean(type, types) +
                              ".\n  For Belos and MueLu it may be one more that Teuchos knows, such as Array(double).");
    }
  }

  const std::string& text_;
  InputProblems& problems_;
};

}  // namespace

ParameterList list_from_xml(const std::string& given, InputProblems& problems) {
  ParameterList list("scene");
  const std::string byte_order_mark = "\xef\xbb\xbf";
  const std::string text = given.compare(0, 3, byte_order_mark) == 0 ? given.substr(3) : given;
  const std::string example = "\n  Start from one of the scenes in xml/, or from xml/reference.xml.";
  if (const auto refused = guarded(text, example); !refused.empty()) {
    problems.add("scene", refused);
    return list;
  }
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  const auto root = document.document_element();
  if (root.name() != std::string("ParameterList"))
    problems.add("scene", " is an element <" + shown(root.name()) + ">\n  but must be a <ParameterList>." + example);
  else
    TreeReader(text, problems).read(root, list, "scene");
  return list;
}

std::string xml_parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + xml_escaped(name) + "\" type=\"" + xml_escaped(type) + "\" value=\"" +
         xml_escaped(value) + "\"/>";
}

std::string xml_from_list(const ParameterList& list, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string text;
  for (auto it = list.begin(); it != list.end(); ++it) {
    const std::string& name = list.name(it);
    const Teuchos::ParameterEntry& entry = list.entry(it);
    text += margin;
    if (entry.isList()) {
      text += "<ParameterList name=\"" + xml_escaped(name) + "\">\n" + xml_from_list(list.sublist(name), indent + 2) +
              margin + "</ParameterList>";
    } else if (entry.isType<double>()) {
      text += xml_parameter(name, "double", number_text(Teuchos::getValue<double>(entry)));
    } else {
      ParameterList lone;
      lone.setEntry(name, entry);
      const XMLObject xml = Teuchos::XMLParameterListWriter().toXML(lone);
      const XMLObject& parameter = xml.getChild(0);
      text += xml_parameter(name, parameter.getAttribute("type"), parameter.getAttribute("value"));
    }
    text += '\n';
  }
  return text;
}

}  // namespace voussoir
