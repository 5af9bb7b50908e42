#include "output/safe_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/digest.hpp"
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

/// A seal at the end of a file: a mark, and the digest of all before the seal. HDF5 ignores what follows its data.
struct Seal {
  char mark[8] = {'V', 'o', 'u', 's', 's', 'o', 'i', 'r'};
  std::uint64_t digest = no_bytes_digest;
};

/// Digest of the first `count` bytes.
std::uint64_t digest_of(std::istream& file, std::streamoff count) {
  std::vector<char> part(1 << 16);
  std::uint64_t sum = no_bytes_digest;
  while (count > 0 && file.read(part.data(), std::min<std::streamoff>(count, part.size()))) {
    sum = digest(part.data(), static_cast<std::size_t>(file.gcount()), sum);
    count -= file.gcount();
  }
  return sum;
}

}  // namespace

std::string cannot_write(const std::string& path, const std::string& reason, const std::string& elsewhere) {
  return path + ": cannot be written\n  because of: " + reason + ".\n  Free the place, or " + elsewhere + ".";
}

std::string cannot_read(const std::string& path, const std::string& reason) {
  return path + ": cannot be read\n  because of: " + reason + ".\n  Give a file written by Voussoir, unchanged.";
}

void seal_file(const std::string& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  file.seekg(0);
  Seal seal;
  seal.digest = digest_of(file, size);
  file.seekp(0, std::ios::end);
  file.write(reinterpret_cast<const char*>(&seal), sizeof seal);
  file.close();
  if (file) return;
  throw ResourceError(cannot_write(path, std::strerror(errno)));
}

void check_seal(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw ResourceError(cannot_read(path, std::strerror(errno)));
  const std::streamoff data = file.tellg() - static_cast<std::streamoff>(sizeof(Seal));
  Seal found, good;
  bool whole = data >= 0 && file.seekg(data) && file.read(reinterpret_cast<char*>(&found), sizeof found) &&
               std::equal(std::begin(good.mark), std::end(good.mark), found.mark);
  whole = whole && file.seekg(0) && digest_of(file, data) == found.digest;
  if (!whole) throw ResourceError(cannot_read(path, "damage: the file is not as it was when it was saved"));
}

void publish_file(const std::string& beside, const std::string& path, const std::string& elsewhere) {
  const auto parent = std::filesystem::path(path).parent_path();
  if (on_disk(beside, O_RDONLY) && std::rename(beside.c_str(), path.c_str()) == 0 &&
      on_disk(parent.empty() ? "." : parent.string(), O_RDONLY | O_DIRECTORY))
    return;
  const std::string reason = std::strerror(errno);
  std::remove(beside.c_str());
  throw ResourceError(cannot_write(path, reason, elsewhere));
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
