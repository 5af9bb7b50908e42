#include "scene/scene_xml.hpp"

#include <Teuchos_StringInputSource.hpp>
#include <Teuchos_XMLObject.hpp>
#include <Teuchos_XMLParameterListReader.hpp>
#include <Teuchos_XMLParameterListWriter.hpp>
#include <algorithm>
#include <set>

#include "base/text.hpp"

namespace voussoir {
namespace {

using Teuchos::ParameterList;
using Teuchos::XMLObject;

constexpr std::size_t largest_text = 16u << 20;  // bytes; a scene written by hand has some thousands
constexpr int deepest_nesting = 32;              // lists within lists; a scene needs 5, MueLu's factories some more
constexpr std::size_t longest_name = 200;        // bytes; a path of such names still fits into a message

/// What must not reach the parser: it recurses when a deep tree is destroyed.
/// @return why the text is refused and what to do, or ""
std::string refusal(const std::string& text) {
  if (text.find('\0') != std::string::npos) return "holds a zero byte.\n  Save it as XML text in UTF-8.";
  int depth = 0;
  for (std::size_t i = text.find('<'); i < text.size(); i = text.find('<', i)) {
    if (text.compare(i, 4, "<!--") == 0) {
      i = text.find("-->", i + 4);
    } else if (text.compare(i, 2, "<!") == 0) {
      const std::string what = text.compare(i, 9, "<!DOCTYPE") == 0   ? "a DOCTYPE"
                               : text.compare(i, 8, "<!ENTITY") == 0  ? "an ENTITY"
                               : text.compare(i, 9, "<![CDATA[") == 0 ? "CDATA"
                                                                      : "a declaration <!...>";
      return "holds " + what +
             ".\n  Declarations, entities and CDATA are refused (they can make a small file huge).\n"
             "  Remove them; a scene needs only ParameterList and Parameter.";
    } else {
      const std::size_t start = i;
      for (char quote = 0; i < text.size() && (quote || text[i] != '>'); ++i)
        if (quote ? text[i] == quote : text[i] == '"' || text[i] == '\'') quote = quote ? '\0' : text[i];
      if (text[start + 1] == '/')
        --depth;
      else if (text[start + 1] != '?' && i < text.size() && text[i - 1] != '/')
        ++depth;
      if (depth > deepest_nesting)
        return "nests lists deeper than " + std::to_string(deepest_nesting) +
               ".\n  Close the lists with </ParameterList>, or write them flatter.";
    }
  }
  return "";
}

/// "XML parse error at line 3: ..." out of what Teuchos throws.
std::string parser_words(const std::string& thrown) {
  const std::string start = "XML parse error at ";
  const auto from = thrown.find(start);
  return from == std::string::npos ? "it is not XML" : trimmed(thrown.substr(from + start.size()));
}

class TreeReader {
 public:
  explicit TreeReader(InputProblems& problems) : problems_(problems) {}

  void read(const XMLObject& xml, ParameterList& list, const std::string& path) {
    for (int i = 0; i < xml.numContentLines(); ++i)
      if (!trimmed(xml.getContentLine(i)).empty()) {
        problems_.add(path, " holds the text " + in_quotes(shown(trimmed(xml.getContentLine(i)))) +
                                "\n  but text between elements has no meaning.\n  Put notes into <!-- comments -->.");
        break;
      }
    std::set<std::string> names;
    for (int i = 0; i < xml.numChildren(); ++i) {
      const XMLObject& child = xml.getChild(i);
      const bool is_list = child.getTag() == "ParameterList";
      if (!is_list && child.getTag() != "Parameter") {
        problems_.add(path, " holds an element <" + shown(child.getTag()) +
                                ">\n  but only ParameterList and Parameter are known" +
                                did_you_mean(child.getTag(), {"ParameterList", "Parameter"}) +
                                ".\n  Correct or remove it.");
        continue;
      }
      const std::string name = child.hasAttribute("name") ? child.getAttribute("name") : "";
      if (name.empty() || name.size() > longest_name || !is_plain_text(name)) {
        problems_.add(path,
                      " holds a " + child.getTag() +
                          (name.empty() ? " without a name"
                                        : " whose name is not UTF-8 text of one line or longer than 200 letters") +
                          ".\n  Give it a name: <" + child.getTag() + " name=\"...\">");
        continue;
      }
      const std::string here = path + " > " + name;
      if (!names.insert(name).second) {
        problems_.add(here,
                      " is there twice\n  but a name may appear once in a list (which one should count?).\n  Remove or "
                      "rename one.");
        continue;
      }
      if (is_list)
        read(child, list.sublist(name), here);
      else
        read_parameter(child, list, name, here);
    }
  }

 private:
  /// Text fit for a message: short, and in UTF-8.
  static std::string shown(const std::string& text) {
    return is_plain_text(text) ? shortened(text, 60) : "(not UTF-8)";
  }

  void read_parameter(const XMLObject& xml, ParameterList& list, const std::string& name, const std::string& path) {
    for (const char* needed : {"type", "value"})
      if (!xml.hasAttribute(needed)) {
        const std::string other = std::string(needed) == "type" ? "double, int, bool or string" : "its value";
        return problems_.add(path, std::string(" has no attribute ") + needed +
                                       ".\n  A Parameter needs name, type and value.\n  Add " + needed + "=\"...\", " +
                                       other + ".");
      }
    if (xml.numChildren() > 0)
      return problems_.add(
          path, " is a Parameter with elements inside.\n  Only a ParameterList holds others.\n  End it by /> .");
    const std::string type = xml.getAttribute("type");
    std::string value = xml.getAttribute("value");
    for (char& c : value)
      if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    if (!is_plain_text(value))
      return problems_.add(path,
                           "\n  is not UTF-8 text without control characters.\n  Save the scene in UTF-8, and write "
                           "letters as they are, not as &#233;.");
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
      read_by_teuchos(xml, list, path, type, value);
    }
  }

  void unreadable(const std::string& path, const std::string& value, const std::string& must) {
    problems_.add(path,
                  " = " + in_quotes(shown(value)) + "\n  must be " + must + ".\n  Correct the value or the type.");
  }

  /// Types only lists for Belos and MueLu need, such as Array(double).
  void read_by_teuchos(const XMLObject& xml, ParameterList& list, const std::string& path, const std::string& type,
                       const std::string& value) {
    XMLObject lone("ParameterList");
    lone.addChild(xml.deepCopy());
    try {
      list.setParametersNotAlreadySet(Teuchos::XMLParameterListReader().toParameterList(lone));
    } catch (const std::exception&) {
      const std::vector<std::string> types{"double", "int", "bool", "string"};
      problems_.add(path, " = " + in_quotes(shown(value)) + " of type " + in_quotes(shown(type)) +
                              "\n  cannot be read: the type is one of " + list_of(types) + did_you_mean(type, types) +
                              ".\n  For Belos and MueLu it may be one more that Teuchos knows, such as Array(double).");
    }
  }

  InputProblems& problems_;
};

}  // namespace

ParameterList list_from_xml(const std::string& given, InputProblems& problems) {
  ParameterList list("scene");
  const std::string byte_order_mark = "\xef\xbb\xbf";
  const std::string text = given.compare(0, 3, byte_order_mark) == 0 ? given.substr(3) : given;
  const std::string example = "\n  Start from one of the scenes in xml/, or from xml/reference.xml.";
  if (text.size() > largest_text) {
    problems.add("scene", "\n  is larger than 16 MB, which no scene is.\n  Geometry belongs into a file of gmsh.");
    return list;
  }
  if (trimmed(text).empty()) {
    problems.add("scene", "\n  is missing: the file is empty." + example);
    return list;
  }
  const std::string refused = refusal(text);
  if (!refused.empty()) {
    problems.add("scene", " " + refused);
    return list;
  }
  XMLObject xml;
  try {
    xml = Teuchos::StringInputSource(text).getObject();
  } catch (const std::exception& error) {
    problems.add("scene", " cannot be read as XML\n  because of " + parser_words(error.what()) + "." + example);
    return list;
  }
  if (xml.isEmpty() || xml.getTag() != "ParameterList")
    problems.add("scene", " is an element <" + (xml.isEmpty() ? std::string("?") : xml.getTag()) +
                              ">\n  but must be a <ParameterList>." + example);
  else
    TreeReader(problems).read(xml, list, "scene");
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
