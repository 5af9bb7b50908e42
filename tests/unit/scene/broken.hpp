// Scenes of xml/ with one thing changed, and what is said of them.
#pragma once

#include <Teuchos_UnitTestHarness.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"

namespace voussoir::test {

inline std::string path_of(const std::string& scene) { return repository("/xml/") + scene + ".xml"; }

/// A scene of xml/ where the first `from` is replaced; "" when there is no `from`, which no scene survives.
inline std::string changed(const std::string& scene, const std::string& from, const std::string& to) {
  std::string text = scene_text(path_of(scene));
  const auto at = text.find(from);
  return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

/// What reading says of a text; "" when it is accepted.
inline std::string said(const std::string& text, const std::string& scene,
                        const std::vector<std::string>& overrides = {}) {
  try {
    read_scene_from_text(text, path_of(scene), overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline int problems_in(const std::string& message, const std::string& scene) {
  int count = 0;
  const std::string start = path_of(scene) + ": ";
  for (auto at = message.find(start); at != std::string::npos; at = message.find(start, at + 1)) ++count;
  return count;
}

/// One change, and the pieces its message must hold: key, value, why, advice.
struct Broken {
  std::string scene, from, to;
  std::vector<std::string> pieces;
};

/// Each change is refused with all pieces, and with nothing else: one cause, one problem.
inline void refuse_each(const std::vector<Broken>& table, Teuchos::FancyOStream& out, bool& success) {
  for (const Broken& b : table) {
    const std::string message = said(changed(b.scene, b.from, b.to), b.scene);
    for (const std::string& piece : b.pieces)
      if (message.find(piece) == std::string::npos) {
        out << "Change to: " << b.to << "\nmisses:    " << piece << "\nin:        " << message << "\n";
        success = false;
      }
    if (problems_in(message, b.scene) != 1) {
      out << "Change to: " << b.to << "\nmakes not one problem:\n" << message << "\n";
      success = false;
    }
  }
}

}  // namespace voussoir::test
