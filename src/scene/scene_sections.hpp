// The sections of a scene in the order of its XML: which modules declare what where.
#pragma once

#include "base/parameter_section.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Declares every parameter of a scene to a section, which reads or prints it.
void declare(Scene&, ParameterSection&);
/// Declares how steps are solved, which is read like the rest of a scene but no part of its reference.
void declare_internals(Internals&, ParameterSection&);

}  // namespace voussoir
