// Numbers a scene sets in a .geo file.
#pragma once

#include <map>
#include <string>

#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// The numbers to set, by name: geometry, `element_size` [units of the file] if > 0 and the file offers it, `recombine`
/// for quadrilaterals. A file offers what it and those it includes define by DefineConstant; where one of those cannot
/// be found, it may offer anything.
/// Throws InputError for any other number the file does not offer.
///
/// @param path  of the .geo file
std::map<std::string, double> numbers_to_set(const GmshParameters&, const std::string& path);

/// A .geo text that sets the numbers and includes a file; DefineConstant in that file leaves set numbers alone.
/// (The option -setnumber of gmsh would do as well, but lasts until the process ends.)
std::string geo_with_numbers(const std::map<std::string, double>&, const std::string& absolute_path);

}  // namespace voussoir
