// Brittle joints with too few cells along them, as they come near to their strength.
#pragma once

#include <string>

#include "base/warning.hpp"
#include "model/contact_problem.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {

/// One warning for each family of joints with cohesion or tension strength, of the joint whose strength may be
/// overrated most. Nothing of joints with six cells or more, or far from breaking. The same on every rank. Collective.
/// @param when  stage and load factor, or time
Warnings coarse_joints(const PlaneModel&, const ContactState&, const std::string& when);

}  // namespace voussoir
