// The table of a study, for programs: the same rows as DIR/NAME.csv and DIR/NAME.json.
#pragma once

#include <Teuchos_Comm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace voussoir {

/// @param names  the columns in order, also of a table without rows
/// @param rows   an array of objects with these names. Collective; rank 0 writes.
void write_study_table(const std::string& folder, const std::string& name, const std::vector<std::string>& names,
                       const nlohmann::ordered_json& rows, const Teuchos::Comm<int>&);

}  // namespace voussoir
