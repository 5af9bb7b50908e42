// The loads of a step as fields.h5 has them: what each is in all, and where those act that do not act on all of stones.
#pragma once

#include <map>
#include <string>

#include "model/model.hpp"
#include "output/fields_file.hpp"

namespace voussoir {

/// Collective.
/// @param factors  of the loads at that time, by name
LoadRows acting_loads(const Model&, const std::map<std::string, double>& factors, double time);

}  // namespace voussoir
