// Load factor analysis: after the last stage a pattern of loads is raised until no equilibrium exists.
//
// Every attempt is one load step from the last equilibrium; dynamics/factor_search.hpp says which one is next. A
// load factor stands when an equilibrium was found, and collapses when the solver reports a mechanism. An attempt at
// which it finds neither is settled in time, and where that does not decide, it is no proof of anything and is told
// apart. Rigid limit analysis tells at the beginning above which factor none can stand, by the static theorem: no
// larger one is tried.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "dynamics/factor_search.hpp"
#include "dynamics/load_steps.hpp"
#include "model/construction.hpp"
#include "range/range_check.hpp"
#include "results/narrator.hpp"
#include "results/recorder.hpp"
#include "run/appraisal.hpp"
#include "run/settling_in_time.hpp"

namespace voussoir {

/// The parts of a run that an attempt works with.
struct Attempting {
  Model& model;
  const Appraisal& appraisal;
  AdaptiveStep& step;
  const Construction& construction;
  const LoadSteps& steps;     ///< all stages of which have been passed
  ContactState& state;        ///< the last equilibrium
  std::vector<double>& load;  ///< [N] its nodal loads
  Recorder& recorder;
  Narrator& narrator;
  RangeCheck& range;
};

class LoadFactorAnalysis {
 public:
  explicit LoadFactorAnalysis(const LoadFactorParameters& parameters) : p_(parameters), search_(parameters) {}

  bool begun() const { return !search_.attempts().empty(); }
  bool finished() const { return search_.finished(); }
  /// One attempt. The state moves on when it stands and is as before when it does not. Collective.
  void attempt(const Attempting&);
  /// Outcome, bracket and mechanism of the run, when the search is over. Collective.
  void conclude(const Attempting&);

  const FactorSearch& search() const { return search_; }
  /// The bracket so far, and the attempts that led to it.
  CollapseSummary bracket() const;
  /// The bracket so far in words; empty as long as nothing of it is known.
  std::string known() const;
  /// Names what a checkpoint keeps.
  /// @param weakens  joints have strength that can be lost
  /// Taken up again at its end, the search tries again what was undecided.
  template <class Archive, class Rows>
  void keep(Archive& archive, const Rows& nodes, const Rows& points, int dim, bool weakens) {
    const bool over = finished();
    search_.keep(archive);
    archive.value("load_factor.asked_theorem", asked_theorem_);
    archive.value("load_factor.most_solves", most_solves_);
    archive.value("load_factor.beyond_at", beyond_at_);
    archive.value("load_factor.beyond", beyond_);
    if (search_.has_mechanism()) {  // then the tables are there
      mechanism_.resize(nodes.ids.size() * dim);
      failed_.lambda.resize(points.ids.size() * dim);
      failed_.selected.resize(points.ids.size());
      if (weakens) failed_.opened.resize(points.ids.size());
      failed_.slipped.resize(failed_.opened.size());
    }
    if (search_.certified() < std::numeric_limits<double>::infinity()) {
      limit_mechanism_.resize(nodes.ids.size() * dim);
      limit_lambda_.resize(points.ids.size() * dim);
    }
    archive.value("load_factor.limit.dilates", limit_dilates_);
    archive.value("load_factor.mechanism.dilates", mechanism_dilates_);
    archive.rows("load_factor.limit.mechanism", nodes, dim, limit_mechanism_);
    archive.rows("load_factor.limit.lambda", points, dim, limit_lambda_);
    archive.rows("load_factor.mechanism", nodes, dim, mechanism_);
    archive.rows("load_factor.failed.lambda", points, dim, failed_.lambda);
    archive.rows("load_factor.failed.selected", points, 1, failed_.selected);
    archive.rows("load_factor.failed.opened", points, 1, failed_.opened);
    archive.rows("load_factor.failed.slipped", points, 1, failed_.slipped);
    if (!over && finished()) search_.forget_undecided();
  }

 private:
  /// What an attempt came to; its motion, where it collapses; linear solves beside those of the report.
  struct Found {
    StepReport report;
    std::vector<double> mechanism;
    bool dilates = false;  ///< that motion, as limit analysis has it
    int solves = 0;
    StepNumbers counts;  ///< beside those of the report
  };
  Found by_statics(const Attempting&, const ContactState& before, const LoadIncrement&, int most);
  Found decide(const Attempting&, const ContactState& before, const LoadIncrement&);
  void certify(const Attempting&);
  void judge(const Attempting&);

  static constexpr auto stage = "load factor";  ///< as history and fields call its steps

  LoadFactorParameters p_;
  FactorSearch search_;
  bool asked_theorem_ = false;
  std::vector<double> limit_mechanism_;  ///< in which it falls at the limit, on node copies
  bool mechanism_dilates_ = false;
  bool limit_dilates_ = false;                             ///< by slip that dilates
  PointField limit_lambda_;                                ///< [N] forces that balance loads there
  int most_solves_ = 0;                                    ///< linear solves of the dearest attempt that stands
  double beyond_at_ = std::numeric_limits<double>::max();  ///< smallest factor that stands beyond the model's range
  std::string beyond_;                                     ///< why that is; empty when there is none
  std::vector<double> mechanism_;  ///< of the smallest factor that collapses with a clear one, on node copies
  ContactState failed_;            ///< forces and selection there
};

}  // namespace voussoir
