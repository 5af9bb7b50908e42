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
#include "linalg/agree.hpp"
#include "output/safe_file.hpp"
#include "output/xdmf.hpp"

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
/// @param kind  LOCK_EX to write, LOCK_SH to read
int lock(const fs::path& folder, int kind = LOCK_EX) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0 || ::flock(file, kind | LOCK_NB) == 0) return file;
  const bool taken = errno == EWOULDBLOCK;
  ::close(file);
  if (taken)
    refuse(folder,
           "another run is writing here\n  and two would spoil each other's results.\n"
           "  Wait for its end, or give another folder with --out=DIR.");
  return -1;
}

/// @param held  the lock on the folder
/// @return where the earlier results went
std::string prepare(const std::string& name, Earlier earlier, int& held) {
  // Everything a run writes but scene.xml, which tells nothing that the user does not have.
  static const char* const results[] = {result_file,    interrupted_file, checkpoint_file, joints_file,
                                        history_file,   fields_file,      xdmf_of_steps,   xdmf_of_last_step,
                                        xdmf_of_joints, "report.html"};
  const fs::path folder = without_slash(name);
  try {
    held = lock(folder);
    const bool ended = fs::exists(folder / result_file), can_go_on = fs::exists(folder / checkpoint_file);
    if (earlier == Earlier::go_on) {
      if (!can_go_on)
        refuse(folder, ended ? "holds a run that has come to its end and kept no state\n  so there is nothing to go on "
                               "from.\n  Leave --restart out to compute it again, with output > checkpoint at end."
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
        refuse(folder,
               "holds a run that was interrupted\n  and nothing was changed.\n  Go on with it by --restart, "
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
  kept_ = *first_text(comm, kept_);
}

OutputFolder::~OutputFolder() {
  if (lock_ >= 0) ::close(lock_);
}

bool holds_result(const std::string& folder, const Teuchos::Comm<int>& comm) {
  int there = 0;
  on_first_rank(comm, [&] { there = fs::exists(fs::path(folder) / result_file); });
  Teuchos::broadcast(comm, 0, Teuchos::outArg(there));
  return there != 0;
}

BranchedFolder::BranchedFolder(const std::string& from, const std::string& to, const Teuchos::Comm<int>& comm)
    : from_(from), to_(to), comm_(comm) {
  on_first_rank(comm, [&] {
    if (!fs::exists(fs::path(from) / checkpoint_file))
      refuse(from,
             "holds no checkpoint\n  so there is no state to go on from.\n  Give the folder of a run that kept its "
             "state with --restart-from=DIR.");
    // Results of an earlier run are renamed or removed with all that is in their folder.
    const auto source = fs::weakly_canonical(from), target = fs::weakly_canonical(without_slash(to));
    const auto [end, ignored] = std::mismatch(target.begin(), target.end(), source.begin(), source.end());
    if (end == target.end())
      refuse(from,
             "lies in the folder of the results\n  which would be overwritten.\n  Give another folder with --out=DIR, "
             "or go on in place with --restart.");
    lock_ = lock(from, LOCK_SH);
  });
}

BranchedFolder::~BranchedFolder() {
  if (lock_ >= 0) ::close(lock_);
}

void BranchedFolder::copy_records(bool fields) const {
  on_first_rank(comm_, [&] {
    for (const char* file : {history_file, fields_file, xdmf_of_steps, xdmf_of_last_step, xdmf_of_joints}) {
      const auto source = fs::path(from_) / file, target = fs::path(to_) / file;
      std::error_code error;
      if ((file != history_file && !fields) || !fs::exists(source, error)) continue;
      if (!fs::copy_file(source, target, fs::copy_options::overwrite_existing, error))
        throw ResourceError(cannot_write(target.string(), error.message()));
    }
  });
}

}  // namespace voussoir
