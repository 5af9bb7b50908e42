// What the fuzzed readers share.
//
// Each file beside this one holds the function libFuzzer calls with bytes it made up. A reader may refuse what it is
// given with an error of ours; anything else it throws, and every crash, leak or hang, is found.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/error.hpp"

/// Called once before all others, where there is one.
extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

namespace voussoir::fuzz {

/// Runs a reader; errors that tell a user what is wrong are its right.
template <class Reader>
void refuse_or_read(Reader reader) {
  try {
    reader();
  } catch (const InputError& error) {
    if (*error.what() == '\0') std::abort();
  } catch (const ResourceError& error) {
    if (*error.what() == '\0') std::abort();
  }
}

/// A file of this process in memory, where the system has that.
inline std::string scratch_file(const std::string& ending) {
  const std::string folder = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
  return folder + "/voussoir-fuzz-" + std::to_string(getpid()) + ending;
}

inline void write_file(const std::string& path, const void* bytes, std::size_t count) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file || std::fwrite(bytes, 1, count, file) != count) std::abort();
  std::fclose(file);
}

}  // namespace voussoir::fuzz
