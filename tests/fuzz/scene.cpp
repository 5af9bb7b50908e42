// Scenes in XML: a text is refused, or it is a scene that says the same when it is written and read again.
#include <sstream>

#include "fuzz.hpp"
#include "scene/scene_printer.hpp"
#include "scene/scene_reader.hpp"

namespace {

std::string written(const voussoir::Scene& scene) {
  std::ostringstream text;
  write_scene(text, scene);
  return text.str();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace voussoir;
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  std::string once;
  fuzz::refuse_or_read([&] { once = written(read_scene_from_text(text, "xml/fuzz.xml")); });
  if (!once.empty() && written(read_scene_from_text(once, "xml/fuzz.xml")) != once) std::abort();
  return 0;
}
