// Load factor analysis: which loads are raised beyond the last stage, and how exactly their largest factor is wanted.
#pragma once

#include <map>
#include <string>

namespace voussoir {

class ParameterSection;

struct LoadFactorParameters {
  std::map<std::string, double> pattern;  ///< load -> its share; empty: no such analysis
  double first = 0.1;                     ///< [-] factor tried first; doubled while the structure stands
  double largest = 100;                   ///< [-] no larger one is tried
  double accuracy = 0.005;                ///< [-] of the bracket, relative to its upper end
  bool asked() const { return !pattern.empty(); }
  void declare(ParameterSection&);
};

}  // namespace voussoir
