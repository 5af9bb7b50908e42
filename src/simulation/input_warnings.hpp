// What the input leaves open, known before anything is computed.
#pragma once

#include "base/warning.hpp"
#include "simulation/model.hpp"

namespace voussoir {

/// The same on every rank. Collective.
Warnings input_warnings(const Model<2>&);

}  // namespace voussoir
