// The sections of a scene in the order of its XML: which modules declare what where.
#pragma once

#include "base/parameter_section.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Declares every parameter of a scene to a section, which reads or prints it.
void declare(Scene&, ParameterSection&);

}  // namespace voussoir
