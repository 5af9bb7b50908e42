// Records of motion and load: every column of a table that is read holds as many finite numbers as the others.
#include <Teuchos_DefaultSerialComm.hpp>
#include <cmath>

#include "fuzz.hpp"
#include "loads/csv_table.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace voussoir;
  static const std::string file = fuzz::scratch_file(".csv");
  fuzz::write_file(file, bytes, count);
  fuzz::refuse_or_read([&] {
    const auto table = read_csv(file, 2, "xml/fuzz.xml: scene > loads > quake > x record", Teuchos::SerialComm<int>());
    if (table.columns.size() != 2) std::abort();
    for (const auto& column : table.columns) {
      if (column.size() != table.columns[0].size()) std::abort();
      for (const double number : column)
        if (!std::isfinite(number)) std::abort();
    }
  });
  std::remove(file.c_str());
  return 0;
}
