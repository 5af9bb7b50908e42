// A run that asks rigid limit analysis alone: seconds for thousands of stones, and nothing elastic.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>
#include <string>

#include "mesh/mesh.hpp"
#include "output/result_json.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Whether the loads at the end of the static stages can be balanced, how far the pattern of a load factor search can
/// be raised beyond them, and in what range reactions are. Collective.
/// @param folder  where result.json goes
template <int dim>
RunSummary limit_run(const Scene&, const BlockSource<dim>&, const std::string& folder,
                     const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

}  // namespace voussoir
