// Stresses of cells from displacements.
#pragma once

#include <vector>

#include "blocks/inner_loads.hpp"

namespace voussoir {

/// Mean stress of every cell of the owned blocks, cell by cell [Pa]: (xx, yy, xy), in space (xx, xy, xz, yy, yz, zz).
/// @param displacement  [m, dim x local node copies]
template <int dim>
std::vector<double> cell_stresses(const Structure<dim>&, const std::vector<double>& displacement, const InnerLoads&);

extern template std::vector<double> cell_stresses<2>(const Structure<2>&, const std::vector<double>&,
                                                     const InnerLoads&);
extern template std::vector<double> cell_stresses<3>(const Structure<3>&, const std::vector<double>&,
                                                     const InnerLoads&);

}  // namespace voussoir
