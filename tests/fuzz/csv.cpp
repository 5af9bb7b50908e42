// Records of motion and load: what is read in any layout is as many finite values as rising finite times.
#include <Teuchos_DefaultSerialComm.hpp>
#include <cmath>

#include "fuzz.hpp"
#include "loads/acceleration_unit.hpp"
#include "loads/time_series.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace voussoir;
  static const std::string file = fuzz::scratch_file(".csv");
  fuzz::write_file(file, bytes, count);
  for (const auto layout : {RecordLayout::time_and_value, RecordLayout::values, RecordLayout::peer_at2})
    for (const int columns : {0, 2}) {
      RecordLayoutParameters p;
      p.layout = layout;
      p.time_step = 0.01;
      p.header_lines = p.time_column = columns / 2;
      fuzz::refuse_or_read([&] {
        const auto series = read_time_series(file, p, {"x column", columns}, "xml/fuzz.xml: scene > loads > x record",
                                             Teuchos::SerialComm<int>());
        if (series.time.size() != series.value.size() || series.time.empty()) std::abort();
        for (std::size_t k = 0; k < series.time.size(); ++k) {
          if (!std::isfinite(series.time[k]) || !std::isfinite(series.value[k])) std::abort();
          if (k > 0 && series.time[k] <= series.time[k - 1]) std::abort();
        }
        unit_named_in(series.heading);
      });
    }
  std::remove(file.c_str());
  return 0;
}
