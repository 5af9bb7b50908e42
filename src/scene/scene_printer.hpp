// A scene for people and for files.
#pragma once

#include <ostream>

#include "scene/scene.hpp"

namespace voussoir {

/// The table at the head of a run, with units and warnings.
/// @param internals  with every number and switch that decides how steps are solved; else those that are not as usual
void print_scene(std::ostream&, const Scene&, bool internals = false);

/// The scene as XML with every value written out, defaults included: reading it gives an equal scene, to the last bit.
/// How steps are solved is left out where it is as usual.
void write_scene(std::ostream&, const Scene&);

/// Every number and switch that decides how steps are solved, with unit, range, default, meaning and reason.
void print_internals_reference(std::ostream&);

/// xml/reference.xml: a scene that shows and explains every parameter there is.
void print_reference(std::ostream&);

/// The same for programs: every parameter with type, default, range and meaning (json_printer.hpp).
void print_reference_as_json(std::ostream&);

}  // namespace voussoir
