// The search for the load factor at which a structure collapses.
//
// The factor is doubled while the structure stands; then the bracket between the largest factor that stands (an
// equilibrium was found) and the smallest that collapses (a mechanism was found) is halved. A factor at which neither
// was found proves nothing: nearer ones are tried first, then it is tried again from the equilibrium nearest to it,
// then larger ones are, in growing steps, until one collapses; where none does, the nearest ones are. What is undecided
// in the end leaves a wider bracket.
//
// With friction that does not dilate what a factor comes to depends on the way there, and far steps miss ways that near
// ones find. So a mechanism that was found from afar ends the search only when it is found again from near.
//
// Where a theorem tells a factor above which no equilibrium exists, none above it is tried, and it ends the bracket
// until a mechanism is found below. A guess is tried from just below and just above when doubling comes to it; what
// falls by hinges alone stands up to what the theorem tells, and that is tried from just below.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "dynamics/load_factor_parameters.hpp"

namespace voussoir {

enum class Verdict { equilibrium, collapse, undecided };

/// One load factor that was tried.
struct FactorAttempt {
  double factor = 0;  ///< [-]
  Verdict verdict = Verdict::undecided;
  int linear_solves = 0;
};

class FactorSearch {
 public:
  explicit FactorSearch(const LoadFactorParameters& parameters) : p_(parameters) {
    VOUSSOIR_EXPECT(p_.first > 0 && "first factor: positive");
    VOUSSOIR_EXPECT(p_.largest > 0 && "largest factor: positive");
    VOUSSOIR_EXPECT(p_.accuracy > 0 && "accuracy: positive");
  }

  /// The factor to try next; none when the search is over.
  std::optional<double> next() const {
    const double edge = std::min(upper(), undecided_);
    if (upper_ == none && undecided_ == none) {
      const double near = p_.accuracy / 2, end = std::min(p_.largest, certified_ * (1 - near));
      if (lower_ >= p_.largest || (certified_ < none && certified_ - lower_ <= p_.accuracy * certified_)) return {};
      double next = std::min(lower_ > 0 ? 2 * lower_ : p_.first, end);
      for (const double target : {guess_ * (1 - near), guess_ * (1 + near)})
        if (lower_ < target) next = std::min(next, target);
      return next;
    }
    // A structure that bears nothing of the pattern would be asked for ever smaller shares of it.
    if (edge - lower_ > p_.accuracy * edge && edge > p_.accuracy * p_.first) return (lower_ + edge) / 2;
    if (edge == upper_ && lower_ - collapse_from_ > afar * p_.accuracy * upper_) return upper_;
    if (edge == upper()) return {};
    const double probe = undecided_ + p_.accuracy * undecided_ * static_cast<double>(1 << probes_);
    const bool farther = probes_ < largest_probes && probe < std::min(upper(), p_.largest);
    const bool wide = upper() - lower_ > p_.accuracy * upper();
    if (!farther && wide && edge - lower_ > nearest * p_.accuracy * edge) return (lower_ + edge) / 2;
    if (tried_from_ < lower_) return undecided_;
    if (farther) return probe;
    return {};
  }

  /// What became of the factor that next() gave.
  void add(Verdict verdict, int linear_solves) {
    VOUSSOIR_EXPECT(linear_solves >= 0 && "linear solves: a count");
    const auto tried = next();
    if (!tried) return;
    const double factor = *tried;
    attempts_.push_back({factor, verdict, linear_solves});
    if (verdict == Verdict::equilibrium) {
      lower_ = factor;
      if (undecided_ <= lower_) forget_undecided();
      if (upper_ <= lower_) upper_ = none;
    } else if (verdict == Verdict::collapse) {
      upper_ = factor;
      collapse_from_ = lower_;
      if (undecided_ >= upper_) undecided_ = none;
    } else if (factor == upper_) {  // what was found from afar stays
      collapse_from_ = lower_;
    } else if (factor > undecided_) {
      ++probes_;
    } else {
      undecided_ = factor;
      tried_from_ = lower_;
    }
  }

  /// What could not be decided may be tried again, as after a change of tolerances.
  void forget_undecided() {
    undecided_ = none;
    probes_ = 0;
  }

  /// No equilibrium exists above this factor, which is no larger than the largest to be tried.
  void certify(double factor) {
    VOUSSOIR_EXPECT(factor >= 0 && "factor: not negative");
    certified_ = factor;
  }
  double certified() const { return certified_; }
  /// About where the search may end; infinite when nothing is known.
  void guess(double factor) {
    VOUSSOIR_EXPECT(!std::isnan(factor) && "factor: a number");
    guess_ = factor;
  }
  double guess() const { return guess_; }

  bool finished() const { return !next(); }
  /// The largest factor that stands; 0 is the end of the last stage.
  double lower() const { return lower_; }
  /// The smallest factor that collapses, or the one above which none can stand; infinite as long as none is known.
  double upper() const { return std::min(upper_, certified_); }
  bool found() const { return upper() < none; }
  /// A mechanism was found, at upper().
  bool has_mechanism() const { return upper_ < none && upper_ <= certified_; }
  /// No factor tried has remained undecided within the bracket.
  bool sharp() const { return undecided_ >= upper(); }
  const std::vector<FactorAttempt>& attempts() const { return attempts_; }

  /// Names what a checkpoint keeps (output/checkpoint.hpp).
  template <class Archive>
  void keep(Archive& archive) {
    archive.within("load_factor.lower", lower_, 0, none);
    archive.within("load_factor.upper", upper_, 0, none);
    archive.within("load_factor.certified", certified_, 0, none);
    archive.within("load_factor.guess", guess_, 0, none);
    archive.within("load_factor.collapse_from", collapse_from_, 0, none);
    archive.within("load_factor.undecided", undecided_, 0, none);
    archive.within("load_factor.tried_from", tried_from_, 0, none);
    archive.within("load_factor.probes", probes_, 0, largest_probes);
    auto count = static_cast<int>(attempts_.size());
    archive.within("load_factor.attempts", count, 0, most_attempts);
    attempts_.resize(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      auto& attempt = attempts_[static_cast<std::size_t>(k)];
      const std::string name = "load_factor.attempt " + std::to_string(k);
      auto verdict = static_cast<int>(attempt.verdict);
      archive.value(name + ".factor", attempt.factor);
      archive.within(name + ".verdict", verdict, 0, static_cast<int>(Verdict::undecided));
      archive.value(name + ".linear_solves", attempt.linear_solves);
      attempt.verdict = static_cast<Verdict>(verdict);
    }
  }

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();
  // Growing steps beyond an undecided factor: with 0.5 % the last lies a third above it.
  static constexpr int largest_probes = 6;
  // What is undecided is approached at last to this share of the accuracy, so that it widens the bracket by no more.
  static constexpr double nearest = 0.25;
  // A mechanism is found from afar when the structure stands so many accuracies nearer to it than where it was tried:
  // as clearly beyond the accuracy as what is undecided is approached within it.
  static constexpr double afar = 1 / nearest;
  static constexpr int most_attempts = 10000;  ///< a checkpoint can hold; some twenty are made

  LoadFactorParameters p_;
  double lower_ = 0, upper_ = none;
  double certified_ = none;  ///< no equilibrium exists above it
  double guess_ = none;
  double collapse_from_ = 0;  ///< equilibrium from which upper_ was tried
  double undecided_ = none;   ///< smallest undecided factor above the lower end
  double tried_from_ = 0;     ///< equilibrium from which that one was tried
  int probes_ = 0;            ///< undecided factors above that one
  std::vector<FactorAttempt> attempts_;
};

}  // namespace voussoir
