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

// What a run removes as it begins.
constexpr const char* results[] = {result_file, interrupted_file, checkpoint_file,   joints_file,    history_file,
                                   fields_file, xdmf_of_steps,    xdmf_of_last_step, xdmf_of_joints, "report.html"};
// What it writes beside them, and what reports add.
constexpr const char *of_scene[] = {"scene.xml", drawing_file}, *of_reports = "pictures";

bool is_written_by_runs(const std::string& name) {
  const auto is_name = [&](const char* file) { return name == file; };
  return std::any_of(std::begin(results), std::end(results), is_name) ||
         std::any_of(std::begin(of_scene), std::end(of_scene), is_name);
}

/// Names of what lies in a folder; none where there is no such folder.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  return names;
}

/// What the run reads is not to be replaced by what it writes.
/// @param goes_on  with the scene of the folder, which it may have been given by name
void refuse_to_replace(const fs::path& folder, const std::vector<std::string>& inputs, bool goes_on) {
  for (const auto& input : inputs) {
    const fs::path file(input);
    const auto name = file.filename().string();
    std::error_code none;
    if (!is_written_by_runs(name) || (goes_on && name == "scene.xml")) continue;
    if (!fs::equivalent(file.has_parent_path() ? file.parent_path() : fs::path("."), folder, none)) continue;
    refuse(folder, "would have " + input +
                       " replaced by a file of the results of the same name\n  and the run reads it: "
                       "nothing was changed.\n  Give another folder with --out=DIR.");
  }
}

/// Renames a folder of results. What it holds beside, which the program has not made, stays in a folder of the old
/// name.
/// @return the new name
fs::path set_aside(const fs::path& folder) {
  const bool is_dot = folder.filename() == "." || folder.filename() == "..";
  const auto named = is_dot ? without_slash(fs::canonical(folder).string()) : folder;
  const fs::path older = next_free(named);
  const auto names = names_in(folder);
  const auto is_ours = [](const std::string& name) { return is_written_by_runs(name) || name == of_reports; };
  if (!is_dot && std::all_of(names.begin(), names.end(), is_ours)) {
    fs::rename(folder, older);
    return older;
  }
  fs::create_directory(older);
  for (const auto& name : names)
    if (is_written_by_runs(name)) fs::rename(folder / name, older / name);
  return older;
}

/// @param held  the lock on the folder
/// @return where the earlier results went
std::string prepare(const std::string& name, Earlier earlier, const std::vector<std::string>& inputs, int& held) {
  const fs::path folder = without_slash(name);
  try {
    held = lock(folder);
    refuse_to_replace(folder, inputs, earlier == Earlier::go_on);
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
    const auto names = names_in(folder);  // a scene.xml or a drawing without results may be anyone's: it is kept too
    const bool any = std::any_of(names.begin(), names.end(), is_written_by_runs);
    if (any && earlier == Earlier::keep) {
      if (can_go_on && !ended)
        refuse(folder,
               "holds a run that was interrupted\n  and nothing was changed.\n  Go on with it by --restart, "
               "remove it by --overwrite, or give another folder with --out=DIR.");
      kept = set_aside(folder).string();
      if (!fs::exists(folder)) ::close(std::exchange(held, -1));  // it is that of the renamed folder
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

OutputFolder::OutputFolder(const std::string& folder, Earlier earlier, const Teuchos::Comm<int>& comm,
                           const std::vector<std::string>& inputs) {
  try {
    on_first_rank(comm, [&] { kept_ = prepare(folder, earlier, inputs, lock_); });
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
