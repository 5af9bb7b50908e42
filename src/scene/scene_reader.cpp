#include "scene/scene_reader.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "base/parameter_reader.hpp"
#include "scene/scene_sections.hpp"
#include "scene/scene_xml.hpp"

namespace voussoir {

namespace fs = std::filesystem;

std::string scene_text(const std::string& file) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(file + ": scene\n  " + why + "\n  Give the path of a scene, such as xml/arch.xml.");
  };
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) refuse("cannot be found.");
  if (fs::is_directory(status)) refuse("is a folder, not a file.");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse("cannot be read; its permissions may forbid it.");
  constexpr std::size_t largest = (16u << 20) + 1;  // one byte more than list_from_xml() accepts
  std::string text(largest, '\0');
  in.read(text.data(), static_cast<std::streamsize>(largest));
  if (in.bad()) refuse("cannot be read to its end.");
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

Scene read_scene_from_text(const std::string& text, const std::string& file,
                           const std::vector<std::string>& overrides) {
  InputProblems problems(file);
  Scene scene;
  scene.file = file;
  scene.name = fs::path(file).stem().string();
  const Overrides given = read_overrides(overrides, problems);
  const Teuchos::ParameterList list = list_from_xml(text, problems);
  if (problems.at("scene") && list.numParams() == 0) problems.throw_if_any();

  ParameterReader reader(list, given, problems);
  declare(scene, reader);
  declare_internals(scene.internals, reader);
  reader.finish();
  check_scene(scene, problems);
  problems.throw_if_any();
  return scene;
}

Scene read_scene(const std::string& file, const std::vector<std::string>& overrides) {
  return read_scene_from_text(scene_text(file), file, overrides);
}

}  // namespace voussoir
