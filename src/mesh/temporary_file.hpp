// A file for the eyes of a library alone, gone with the object.
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"

namespace voussoir {

class TemporaryFile {
 public:
  /// @param ending  such as ".geo"
  TemporaryFile(const std::string& text, const std::string& ending) {
    path_ = (std::filesystem::temp_directory_path() / "voussoir-XXXXXX").string() + ending;
    const int descriptor = mkstemps(path_.data(), static_cast<int>(ending.size()));
    if (descriptor < 0)
      throw ResourceError("no file can be written in " + path_ + " (set TMPDIR to a folder with room).");
    close(descriptor);
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace voussoir
