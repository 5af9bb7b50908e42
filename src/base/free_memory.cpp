#include "base/free_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace voussoir {
namespace {

constexpr double unknown = std::numeric_limits<double>::max();

/// The number behind a key of a file of the kernel, which counts in kB [bytes].
double in_kilobytes(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string word; in >> word;) {
    double number = 0;
    if (word == key + ":" && in >> number) return 1024 * number;
  }
  return unknown;
}

/// The only number of a file; unknown where it is a word, such as "max" for no limit.
double number_in_file(const char* file) {
  std::ifstream in(file);
  double number = 0;
  return in >> number ? number : unknown;
}

/// The number behind a word [bytes]; 0 where there is none.
double number_behind(const char* file, const std::string& word) {
  std::ifstream in(file);
  std::string found;
  for (double number = 0; in >> found >> number;)
    if (found == word) return number;
  return 0;
}

struct Group {
  const char *most, *used, *details, *cache;
};
// Groups of processes (batch jobs, containers), of both versions; where there are none the files are not there. Copies
// of files are counted as used and given back when they are in the way.
constexpr Group groups[] = {
    {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current", "/sys/fs/cgroup/memory.stat", "file"},
    {"/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes",
     "/sys/fs/cgroup/memory/memory.stat", "total_cache"},
};

}  // namespace

double whole_memory() {
  double all = in_kilobytes("/proc/meminfo", "MemTotal");
  for (const auto& group : groups) all = std::min(all, number_in_file(group.most));
  return all;
}

double free_memory() {
  double left = in_kilobytes("/proc/meminfo", "MemAvailable");
  for (const auto& group : groups)
    if (const double most = number_in_file(group.most), used = number_in_file(group.used);
        most < unknown && used < unknown)
      left = std::min(left, std::max(most - used + number_behind(group.details, group.cache), 0.0));
  return left;
}

double data_of_this_process() {
  const double data = in_kilobytes("/proc/self/status", "VmData");
  return data < unknown ? data : 0;
}

}  // namespace voussoir
