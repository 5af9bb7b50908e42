// Drawings of stones: after a first byte that says of which kind, the bytes of the file. What is read is put together.
#include "drawings/drawing_files.hpp"
#include "drawings/plane_stones.hpp"
#include "fuzz.hpp"

using namespace voussoir;

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  if (count == 0) return 0;
  constexpr DrawnFile (*readers[])(const std::string&, const std::string&) = {read_csv_stones, read_dxf_stones,
                                                                              read_svg_stones, read_geojson_stones};
  const std::string text(reinterpret_cast<const char*>(bytes) + 1, count - 1);
  fuzz::refuse_or_read([&] {
    StonesParameters p;
    p.file = "drawing.csv";
    auto drawn = readers[bytes[0] % 4](p.file, text);
    if (drawn.stones.empty()) return;
    for (std::size_t k = 0; k < drawn.stones.size(); ++k)
      if (drawn.stones[k].name.empty()) drawn.stones[k].name = "stone " + std::to_string(k + 1);
    const auto stones = plane_stones_of(std::move(drawn), p);
    if (stones.snapped.loops.size() != stones.stones.size() || picture_of(stones).empty()) std::abort();
  });
  return 0;
}
