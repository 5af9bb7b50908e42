#include "output/output_folder.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <Teuchos_CommHelpers.hpp>

#include "base/error.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

namespace fs = std::filesystem;

/// "out/wall/" and "out/./wall" are "out/wall", so that ".1" goes behind the name.
fs::path without_slash(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

fs::path next_free(const fs::path& folder) {
  for (int n = 1;; ++n) {
    fs::path candidate = folder;
    candidate += "." + std::to_string(n);
    if (!fs::exists(fs::symlink_status(candidate))) return candidate;
  }
}

void prove_writable(const fs::path& folder) {
  const std::string probe = (folder / ".voussoir-probe").string();
  std::FILE* file = std::fopen(probe.c_str(), "wb");
  if (!file) throw ResourceError(cannot_write(folder.string(), std::strerror(errno)));
  std::fclose(file);
  std::remove(probe.c_str());
}

/// @return where the earlier results went
std::string prepare(const std::string& name, bool overwrite) {
  const fs::path folder = without_slash(name);
  try {
    std::string kept;
    if (!overwrite && fs::exists(folder / "result.json")) {
      const fs::path older = next_free(folder);
      fs::rename(folder, older);
      kept = older.string();
    }
    fs::create_directories(folder);
    for (const char* file : {"result.json", "history.csv", "fields.h5", "fields.xdmf", "report.html"})
      fs::remove(folder / file);
    prove_writable(folder);
    return kept;
  } catch (const fs::filesystem_error& error) {
    throw ResourceError(cannot_write(folder.string(), error.code().message()));
  }
}

}  // namespace

std::string prepare_output_folder(const std::string& folder, bool overwrite, const Teuchos::Comm<int>& comm) {
  std::string kept;
  on_first_rank(comm, [&] { kept = prepare(folder, overwrite); });
  int length = static_cast<int>(kept.size());
  Teuchos::broadcast(comm, 0, &length);
  kept.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(comm, 0, length, kept.data());
  return kept;
}

}  // namespace voussoir
