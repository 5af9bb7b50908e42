#include "results/narrator.hpp"

#include <cmath>
#include <cstdio>

namespace voussoir {
namespace {

/// As printf, of any length.
template <class... Values>
void print(std::ostream& out, const char* format, Values... values) {
  std::string line(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)), ' ');
  std::snprintf(line.data(), line.size() + 1, format, values...);
  out << line << std::flush;
}

/// Who waits wants to know for what; a line in so much time is no flood.
constexpr std::chrono::seconds patience(5);

}  // namespace

Narrator::Narrator(std::ostream& say, bool verbose, double seconds)
    : say_(say),
      verbose_(verbose),
      began_(Clock::now() - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {
  print(say_, "\n%5s %8s %7s %9s %7s %7s %7s %9s %9s %8s\n", "step", "factor", "solves", "selected", "open", "slip",
        "krylov", "estimate", "|u| [m]", "[s]");
}

void Narrator::begin(int step, const std::string& stage, double target, double progress) {
  if (stage != stage_) say_ << "stage '" << stage << "'\n";
  stage_ = stage;
  step_ = step;
  target_ = target;
  progress_ = progress;
  if (first_progress_ < 0) first_progress_ = progress;
  solves_ = 0;
}

void Narrator::solve(const NewtonProgress& p) {
  if (p.local_solves == 0) ++solves_;
  if (!verbose_) {
    if (Clock::now() < told_at_ + patience) return;
    told_at_ = Clock::now();
    print(say_,
          "      %.0f s: step %d, stage '%s' at %.6g: %d linear solves so far, |R| %.1e N, contact law %.1e N%s%s\n",
          std::chrono::duration<double>(told_at_ - began_).count(), step_, stage_.c_str(), target_, solves_, p.residual,
          p.complementarity, known_.empty() ? "" : "; ", known_.c_str());
    return;
  }
  if (p.local_solves > 0) {
    print(say_, "        it %3d  |R| %9.2e N  with stuck blocks brought to rest in %d linear solves of patches\n",
          p.iteration, p.residual, p.local_solves);
    return;
  }
  print(say_, "        it %3d  |R| %9.2e N  closed %8lld  slipping %7lld  krylov %4d  damping %5.3f  augmentation %g\n",
        p.iteration, p.residual, p.closed, p.slipping, p.krylov, p.damping, p.augmentation);
}

void Narrator::round(int round, long long selected, double error_estimate) {
  if (!verbose_) return;
  if (std::isnan(error_estimate))
    print(say_, "        round %d: %lld points selected, too few: error not estimated\n", round, selected);
  else
    print(say_, "        round %d: %lld points selected, error estimate %.2e of what is bonded\n", round, selected,
          error_estimate);
}

void Narrator::end(const StepReport& report, double seconds, const RunSummary& summary, bool tell) {
  spent_ += seconds;
  // Of thousands of time steps, one in a hundred is worth a line, and one in a while.
  if (!tell && progress_ < told_ + 0.01 && Clock::now() < told_at_ + patience) return;
  told_ = progress_;
  told_at_ = Clock::now();
  print(say_, "%5d %8.4g %7d %9lld %7lld %7lld %7lld %9.2e %9.2e %8.2f", step_, target_,
        report.newton.newton_iterations, summary.selected_points, summary.open_points, summary.slip_points,
        report.newton.krylov_iterations, report.error_estimate, summary.residual_displacement, seconds);
  // A remaining time is worth saying when a run takes more than ten seconds.
  if (progress_ > first_progress_ && spent_ > 10 && progress_ < 1)
    print(say_, "   about %.0f s to go", spent_ / (progress_ - first_progress_) * (1 - progress_));
  say_ << std::endl;
}

void Narrator::say(const std::string& line) { say_ << line << std::endl; }

void Narrator::warn(const Warning& w) { say_ << "  " << in_words(w) << std::endl; }

void Narrator::failed(const StepReport& report, const std::string& stage, double target) {
  print(say_, "step %d, stage '%s' at %.4g: %s\n", step_, stage.c_str(), target,
        report.newton.outcome == NewtonOutcome::collapse ? "collapse" : "stopped");
  print(say_, "  after %d linear solves, |R| = %.1e and contact law %.1e of the largest force: ",
        report.newton.newton_iterations, report.newton.residual, report.newton.complementarity);
  say_ << report.newton.reason << "." << std::endl;
}

}  // namespace voussoir
