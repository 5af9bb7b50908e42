#include "base/parameter_section.hpp"

namespace voussoir {

void ParameterSection::add(const std::string& name, double& value, const std::string& unit, const Range& range,
                           const std::string& text, const std::string& why, const std::string& advice) {
  visit(Parameter{name, &value, unit, range, text, why, advice});
}

void ParameterSection::add(const std::string& name, int& value, const std::string& unit, const Range& range,
                           const std::string& text, const std::string& why, const std::string& advice) {
  visit(Parameter{name, &value, unit, range, text, why, advice});
}

void ParameterSection::add(const std::string& name, bool& value, const std::string& text) {
  visit(Parameter{name, &value, "", any_number(), text, "", ""});
}

void ParameterSection::add(const std::string& name, std::string& value, const std::string& text, Presence presence,
                           const std::string& advice) {
  visit(Parameter{name, &value, "", any_number(), text, "", advice, presence});
}

void ParameterSection::add_numbers(const std::string& name, std::map<std::string, double>& value,
                                   const std::string& unit, const Range& range, const std::string& text) {
  visit(Parameter{name, &value, unit, range, text, "", ""});
}

void ParameterSection::add_list(const std::string& name, Teuchos::ParameterList& value, const std::string& text) {
  visit(Parameter{name, &value, "", any_number(), text, "", ""});
}

}  // namespace voussoir
