// Numbers a scene sets in a .geo file.
#pragma once

#include <map>
#include <string>

#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// The numbers to set, by name: geometry, `element_size` if > 0, `recombine` for quadrilaterals.
/// Throws InputError for a number the file does not offer to be set, that is: does not define by DefineConstant,
/// unless the file includes others, where it may be defined.
///
/// @param text  contents of the .geo file
std::map<std::string, double> numbers_to_set(const GmshParameters&, const std::string& text);

/// A .geo text that sets the numbers and includes a file; DefineConstant in that file leaves set numbers alone.
/// (The option -setnumber of gmsh would do as well, but lasts until the process ends.)
std::string geo_with_numbers(const std::map<std::string, double>&, const std::string& absolute_path);

}  // namespace voussoir
