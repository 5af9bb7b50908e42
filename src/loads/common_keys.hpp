// Keys that several types of load have, declared once.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

/// The set of facets `on` that a load acts on, and the set of `blocks` whose facets alone are meant.
void declare_facet_set(ParameterSection&, std::string& on, std::string& blocks);

/// The set of `blocks` that a load acts on; "all" unless the scene names one.
void declare_block_set(ParameterSection&, std::string& blocks);

/// @param gravity  [m/s2]
void declare_gravity(ParameterSection&, double& gravity);

/// Still water.
/// @param level    [m] height
/// @param density  [kg/m3]
/// @param gravity  [m/s2]
void declare_water(ParameterSection&, double& level, double& density, double& gravity);

}  // namespace voussoir
