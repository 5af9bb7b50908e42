#include "output/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <utility>

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

/// A byte that reaches the file system: an empty file can be made on a full disk.
void prove_writable(const fs::path& folder) {
  const std::string probe = (folder / ".voussoir-probe").string();
  std::FILE* file = std::fopen(probe.c_str(), "wb");
  bool written = file && std::fputc('v', file) != EOF && std::fflush(file) == 0;
  const int reason = errno;
  if (file) written = std::fclose(file) == 0 && written;
  std::remove(probe.c_str());
  if (!written) throw ResourceError(cannot_write(folder.string(), std::strerror(reason)));
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw ResourceError(folder.string() + ": " + why);
}

/// A lock on an existing folder; -1 where the file system knows no locks. Throws when another run holds it.
int lock(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  const bool taken = errno == EWOULDBLOCK;
  ::close(file);
  if (taken)
    refuse(folder, "another run is writing here\n  and two would spoil each other's results.\n"
                   "  Wait for its end, or give another folder with --out=DIR.");
  return -1;
}

/// @param held  the lock on the folder
/// @return where the earlier results went
std::string prepare(const std::string& name, Earlier earlier, int& held) {
  // Everything a run writes but scene.xml, which tells nothing that the user does not have.
  static const char* const results[] = {result_file,   checkpoint_file, joints_file, "history.csv",
                                        "fields.h5",   "fields.xdmf",   "report.html"};
  const fs::path folder = without_slash(name);
  try {
    held = lock(folder);
    const bool ended = fs::exists(folder / result_file), can_go_on = fs::exists(folder / checkpoint_file);
    if (earlier == Earlier::go_on) {
      if (!can_go_on)
        refuse(folder, ended ? "holds a run that has come to its end\n  so there is nothing to go on with.\n"
                               "  Leave --restart out to compute it again."
                             : "holds no checkpoint\n  so there is no state to go on from.\n"
                               "  Give the folder of the run with --out=DIR, or leave --restart out.");
      prove_writable(folder);
      return "";
    }
    std::string kept;
    const bool any = std::any_of(std::begin(results), std::end(results),
                                 [&](const char* file) { return fs::exists(folder / file); });
    if (any && earlier == Earlier::keep) {
      if (can_go_on && !ended)
        refuse(folder, "holds a run that was interrupted\n  and nothing was changed.\n  Go on with it by --restart, "
                       "remove it by --overwrite, or give another folder with --out=DIR.");
      const fs::path older = next_free(folder);
      fs::rename(folder, older);
      kept = older.string();
      ::close(std::exchange(held, -1));  // it is that of the renamed folder
    }
    fs::create_directories(folder);
    if (held < 0) held = lock(folder);
    prove_writable(folder);
    for (const char* file : results) fs::remove(folder / file);
    return kept;
  } catch (const fs::filesystem_error& error) {
    throw ResourceError(cannot_write(folder.string(), error.code().message()));
  }
}

}  // namespace

OutputFolder::OutputFolder(const std::string& folder, Earlier earlier, const Teuchos::Comm<int>& comm) {
  try {
    on_first_rank(comm, [&] { kept_ = prepare(folder, earlier, lock_); });
  } catch (...) {
    if (lock_ >= 0) ::close(lock_);
    throw;
  }
  int length = static_cast<int>(kept_.size());
  Teuchos::broadcast(comm, 0, &length);
  kept_.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(comm, 0, length, kept_.data());
}

OutputFolder::~OutputFolder() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace voussoir
