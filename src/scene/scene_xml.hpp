// XML from strangers to a ParameterList: only lists and parameters, once each, values that mean what they say.
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "base/input_problems.hpp"

namespace voussoir {

/// The list an XML text holds; its path in messages is "scene". What cannot be read is left out and reported.
/// Teuchos alone would read 1e9x as 1e9, take the last of two equal keys and merge equal sublists.
Teuchos::ParameterList list_from_xml(const std::string& text, InputProblems&);

/// A list as XML, exactly: reading the text gives an equal list.
/// @param indent spaces before the parameters of the list
std::string xml_from_list(const Teuchos::ParameterList&, int indent);

/// <Parameter name= type= value=/>, escaped.
std::string xml_parameter(const std::string& name, const std::string& type, const std::string& value);

}  // namespace voussoir
