// A scene for people and for files.
#pragma once

#include <map>
#include <ostream>
#include <string>

#include "scene/scene.hpp"

namespace voussoir {

/// The table at the head of a run, with units and warnings.
void print_scene(std::ostream&, const Scene&);

/// The scene as XML with every value written out, defaults included: reading it gives an equal scene, to the last bit.
void write_scene(std::ostream&, const Scene&);

/// The sections of write_scene() by name, to tell what two scenes differ in.
std::map<std::string, std::string> section_texts(const Scene&);

/// xml/reference.xml: a scene that shows and explains every parameter there is.
void print_reference(std::ostream&);

}  // namespace voussoir
