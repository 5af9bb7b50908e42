#include "output/study_table.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/text.hpp"
#include "linalg/agree.hpp"
#include "output/safe_file.hpp"

namespace voussoir {

void write_study_table(const std::string& folder, const std::string& name, const std::vector<std::string>& names,
                       const nlohmann::ordered_json& rows, const Teuchos::Comm<int>& comm) {
  std::ostringstream csv;
  for (const auto& column : names) csv << (&column == &names.front() ? "" : ",") << column;
  csv << '\n';
  for (const auto& row : rows) {
    for (const auto& column : names) {
      const auto& value = row.at(column);
      csv << (&column == &names.front() ? "" : ",");
      if (value.is_string())
        csv << '"' << value.get<std::string>() << '"';
      else if (value.is_number_float())
        csv << number_text(value.get<double>());
      else
        csv << value.dump();
    }
    csv << '\n';
  }
  on_first_rank(comm, [&] {
    replace_file(folder + "/" + name + ".csv", csv.str());
    replace_file(folder + "/" + name + ".json", rows.dump(1) + "\n");
  });
}

}  // namespace voussoir
