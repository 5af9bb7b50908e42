#include "run/scene_file.hpp"

#include <filesystem>
#include <sstream>

#include "linalg/agree.hpp"
#include "output/output_folder.hpp"
#include "output/safe_file.hpp"
#include "scene/scene_printer.hpp"

namespace voussoir {

void write_scene_file(const Scene& scene, const std::string& folder, const Teuchos::Comm<int>& comm) {
  on_first_rank(comm, [&] {
    std::filesystem::remove(folder + "/" + result_file);
    if (std::filesystem::remove(folder + "/" + interrupted_file)) std::filesystem::remove(folder + "/" + joints_file);
    std::ostringstream text;
    write_scene(text, scene);
    replace_file(folder + "/scene.xml", text.str());
  });
}

void write_drawing(const std::string& picture, const std::string& folder, const Teuchos::Comm<int>& comm) {
  on_first_rank(comm, [&] {
    if (picture.empty())
      std::filesystem::remove(folder + "/" + drawing_file);  // of another scene that was computed here
    else
      replace_file(folder + "/" + drawing_file, picture);
  });
}

}  // namespace voussoir
