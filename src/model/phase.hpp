// Seconds per phase of a run, through Teuchos timers.
#pragma once

#include <Teuchos_TimeMonitor.hpp>
#include <map>
#include <string>

namespace voussoir {

/// Times its own life under a name.
class Phase {
 public:
  explicit Phase(const std::string& name) : monitor_(*Teuchos::TimeMonitor::getNewCounter(name)) {}

 private:
  Teuchos::TimeMonitor monitor_;
};

/// Seconds of this rank by phase so far.
inline std::map<std::string, double> seconds_of_phases(const std::initializer_list<const char*>& names) {
  std::map<std::string, double> seconds;
  for (const char* name : names)
    if (const auto timer = Teuchos::TimeMonitor::lookupCounter(name); !timer.is_null())
      seconds[name] = timer->totalElapsedTime();
  return seconds;
}

}  // namespace voussoir
