// Prints declared parameters as the XML they are read from, exactly, with or without their documentation.
#pragma once

#include <map>
#include <ostream>
#include <set>
#include <string>

#include "base/parameter_section.hpp"

namespace voussoir {

/// The value of a parameter in words; "" for a sublist.
std::string value_text(const Parameter&);

/// Defaults as messages show them, by key: the path with members of families called *.
using Defaults = std::map<std::string, std::string>;

class XmlPrinter final : public ParameterSection {
 public:
  /// Without documentation: what is chosen, every value written out.
  explicit XmlPrinter(std::ostream& os) : os_(os) {}
  /// With documentation: a comment for every key, and what other choices offer as comments.
  XmlPrinter(std::ostream& os, Defaults defaults) : os_(os), documented_(true), defaults_(std::move(defaults)) {}

 private:
  void visit(const Parameter&) override;
  void visit(const Subsection&, const std::function<void()>& declare) override;
  void visit(const Family&) override;
  void refuse(const std::string&, const std::string&, const std::string&, const std::string&) override {}

  void open(const std::string& name);
  void close();
  void line(const std::string& text);
  /// A comment of its own, or plain text where all is a comment already; wrapped.
  void remark(const std::string& text);
  void element(const Parameter&);
  std::string documentation(const Parameter&) const;
  std::string key(const std::string& name) const { return path_.empty() ? name : path_ + " > " + name; }
  void begin_comment(const std::string& text);
  void end_comment();

  std::ostream& os_;
  bool documented_ = false;
  Defaults defaults_;
  std::set<std::string> told_;  ///< keys documented once
  std::string path_;
  int depth_ = 1;
  int in_comment_ = 0;
};

/// Collects the defaults of all that is declared, whatever is chosen.
class DefaultsCollector final : public ParameterSection {
 public:
  Defaults defaults;

 private:
  void visit(const Parameter&) override;
  void visit(const Subsection&, const std::function<void()>& declare) override;
  void visit(const Family&) override;
  void refuse(const std::string&, const std::string&, const std::string&, const std::string&) override {}

  std::string path_;
};

}  // namespace voussoir
