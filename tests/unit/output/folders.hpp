// Folders of tests that write files on any number of ranks.
#pragma once

#include <Teuchos_DefaultComm.hpp>
#include <filesystem>
#include <string>

namespace voussoir::test {

inline Teuchos::RCP<const Teuchos::Comm<int>> world() { return Teuchos::DefaultComm<int>::getComm(); }

/// Path of an empty folder of this name and this number of ranks. Collective.
inline std::string fresh_folder(const std::string& name) {
  const std::string folder = name + "-np" + std::to_string(world()->getSize());
  if (world()->getRank() == 0) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
  }
  world()->barrier();
  return folder;
}

}  // namespace voussoir::test
