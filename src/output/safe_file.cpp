#include "output/safe_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>

#include <Teuchos_CommHelpers.hpp>

#include "base/error.hpp"

namespace voussoir {
namespace {

/// Waits until a file or folder is on disk; folders of some file systems cannot be waited for, which is no fault.
bool on_disk(const std::string& path, int how) {
  const int file = ::open(path.c_str(), how);
  if (file < 0) return false;
  const bool synced = ::fsync(file) == 0 || errno == EINVAL;
  const int reason = errno;
  ::close(file);
  errno = reason;
  return synced;
}

}  // namespace

std::string cannot_write(const std::string& path, const std::string& reason) {
  return path + ": cannot be written\n  because of: " + reason +
         ".\n  Free the place, or give another folder with --out=DIR.";
}

void on_first_rank(const Teuchos::Comm<int>& comm, const std::function<void()>& action) {
  std::string message;
  int length = -1;
  if (comm.getRank() == 0) {
    try {
      action();
    } catch (const std::exception& error) {
      message = error.what();
      length = static_cast<int>(message.size());
    }
  }
  Teuchos::broadcast(comm, 0, &length);
  if (length < 0) return;
  message.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(comm, 0, length, message.data());
  throw ResourceError(message);
}

void publish_file(const std::string& beside, const std::string& path) {
  const auto parent = std::filesystem::path(path).parent_path();
  if (on_disk(beside, O_RDONLY) && std::rename(beside.c_str(), path.c_str()) == 0 &&
      on_disk(parent.empty() ? "." : parent.string(), O_RDONLY | O_DIRECTORY))
    return;
  const std::string reason = std::strerror(errno);
  std::remove(beside.c_str());
  throw ResourceError(cannot_write(path, reason));
}

void replace_file(const std::string& path, const std::string& content) {
  const std::string beside = path + ".part";
  std::FILE* file = std::fopen(beside.c_str(), "wb");
  bool written = file != nullptr;
  if (file) {
    written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
    written = std::fflush(file) == 0 && written;
  }
  int reason = errno;
  if (file && std::fclose(file) != 0 && written) {
    reason = errno;
    written = false;
  }
  if (written && std::rename(beside.c_str(), path.c_str()) != 0) {
    reason = errno;
    written = false;
  }
  if (written) return;
  if (file) std::remove(beside.c_str());
  throw ResourceError(cannot_write(path, std::strerror(reason)));
}

}  // namespace voussoir
