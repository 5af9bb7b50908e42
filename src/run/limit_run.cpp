#include "run/limit_run.hpp"

#include <Teuchos_Time.hpp>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/fail_together.hpp"
#include "model/construction.hpp"
#include "model/model_of_blocks.hpp"
#include "output/output_folder.hpp"
#include "range/input_warnings.hpp"
#include "results/largest_mover.hpp"
#include "results/mechanism_words.hpp"
#include "results/recorder.hpp"
#include "run/rigid_limits.hpp"
#include "run/what_is_known.hpp"
#include "statics/limit_analysis_parameters.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir {
namespace {

/// The scene for a model that is not solved: one in time alone has no continuum.
Scene without_load_steps(Scene scene) {
  for (auto& stage : scene.stages) stage.duration = 1;
  return scene;
}

/// The stages before the first that takes time.
std::size_t static_stages(const Scene& scene) {
  std::size_t count = 0;
  while (count < scene.stages.size() && !scene.stages[count].dynamic()) ++count;
  return count;
}

std::map<std::string, double> factors_after(const Scene& scene, std::size_t stages) {
  std::map<std::string, double> factors;
  for (std::size_t k = 0; k < stages; ++k)
    for (const auto& [load, factor] : scene.stages[k].factors) factors[load] = factor;
  return factors;
}

/// What the share of joints that forces can leave free is, and what it is not.
std::string words_of_share(const RigidSummary& rigid, bool rows) {
  const std::string end = rigid.at_least ? ", where the search for more ends" : "";
  if (!rows)
    return end +
           ": a share of every joint, of those between rings, courses and backing too, and not the factor of one "
           "arch of that depth";
  return rigid.at_least ? end : ", a geometric factor of safety of " + six_digits(rigid.factor) + " or more";
}

/// Where a force along a component goes.
template <int dim>
const char* way_of(int component) {
  if (component == dim - 1) return " upwards";
  return dim == 2 ? " to the right" : component == 0 ? " along x" : " along y";
}

/// A reaction along a component, from its least to its most.
template <int dim>
std::string words_of_range(const RigidSummary::Range& range, int component) {
  const auto force = [](double f) { return std::isfinite(f) ? six_digits(f) + " N" : std::string("any force"); };
  const auto least = force(range.least), most = force(range.most);
  if (least != most) return "from " + least + " to " + most + way_of<dim>(component);
  if (std::isfinite(range.least)) return least + way_of<dim>(component);
  const char* back = component == dim - 1 ? " or downwards" : dim == 2 ? " or left" : " or against it";
  return least + way_of<dim>(component) + back;
}

/// What is asked of a scene's rigid stones, and where the answers go.
template <int dim>
class LimitRun {
 public:
  /// @param scene  as the user wrote it
  LimitRun(const Scene& scene, ModelOfBlocks<dim>& model, const std::string& folder, std::ostream& say)
      : model_(model), scene_(scene), say_(say), step_(model), recorder_(scene, model, step_, folder) {}

  /// What the input leaves open. Collective.
  void warn() {
    auto warnings = warnings_of_rigid_stones(scene_, model_);
    if (const auto stages = static_stages(scene_); stages < scene_.stages.size())
      warnings.push_back(
          {"not_judged", scene_.file + ": scene > steps > stages > " + scene_.stages[stages].name, "",
           static_cast<double>(scene_.stages.size() - stages),
           "this stage has a duration, and inertia bears loads in it and in those behind: limit analysis "
           "judges " +
               counted(stages, "stage") + " of load steps that " + (stages == 1 ? "comes" : "come") +
               " first; run the scene for the rest"});
    for (const auto& w : warnings)
      if (recorder_.warn(w)) say_ << "  " << in_words(w) << std::endl;
  }

  /// Each stage is judged with the loads at its end. Forces that balance two sets of loads balance all between, so that
  /// what stands there stands within stages too, where no stones come or go.
  RunSummary answer() {
    const auto stages = static_stages(scene_);
    auto& summary = recorder_.summary();
    summary.rigid.emplace();
    summary.rigid->components = dim;
    std::optional<Construction> construction;
    if (!scene_.construction.empty()) construction.emplace(scene_, model_);
    for (std::size_t k = 0; k < stages; ++k) {
      const bool is_last = k + 1 == stages;
      const auto& name = scene_.stages[k].name;
      std::vector<char> absent;
      if (construction) {
        auto state = step_.initial_state();
        construction->begin(name, model_, state);
        absent = construction->absent();
      }
      factors_ = factors_after(scene_, k + 1);
      if (!is_last && !construction && factors_ == factors_after(scene_, k + 2)) continue;
      if (!judge(name, is_last, absent)) return summary;
    }
    return summary;
  }

 private:
  static constexpr auto stage = "limit analysis";  ///< as fields call its steps

  /// Whether forces can balance the loads of a stage, and of the last one what else is known. Collective.
  /// @return  whether they can
  bool judge(const std::string& name, bool is_last, const std::vector<char>& absent) {
    recorder_.set_loads(factors_, 0);
    RigidTask task{&absent, nullptr, {}, {}};
    std::vector<double> prescribed;
    model_.loads(factors_, 0, task.fixed, prescribed);
    const auto& search = scene_.load_factor;
    if (is_last && search.asked()) task.raised = loads_of_pattern(model_, factors_, search.pattern, 0);
    const RigidLimits<dim> limits(model_, task);
    auto& summary = recorder_.summary();
    const auto at_rest = limits.bears(0);
    const std::string at_end = scene_.stages.size() == 1 ? "" : " at the end of stage '" + name + "'";
    if (stopped("whether forces can balance the loads" + at_end + " is not known")) return false;
    if (at_rest.verdict == LimitVerdict::refused) {
      summary.message = "no forces that joints admit balance the loads" + at_end +
                        ", so that no equilibrium exists, by the static theorem";
      falls(limits, at_rest, 0, at_rest);
    } else if (at_rest.verdict == LimitVerdict::unknown) {
      summary.message = "the linear programme could not be solved exactly enough to prove anything" +
                        (at_end.empty() ? "" : " of the loads" + at_end);
    } else if (is_last) {
      const auto stages = static_stages(scene_);
      stands(limits, at_rest,
             stages > 1       ? " at the end of every stage; at that of the last, '" + name + "',"
             : at_end.empty() ? ";"
                              : at_end + ";");
      if (summary.outcome != Outcome::interrupted && search.asked()) raise(limits, at_rest);
    }
    return at_rest.verdict != LimitVerdict::refused && at_rest.verdict != LimitVerdict::unknown;
  }

  /// Whether the run was asked to stop; then that is what the summary says, with what it knew by then. Collective.
  /// @param unknown  what was being looked for
  bool stopped(const std::string& unknown) {
    const auto stop = stop_wanted(*model_.structure().comm());
    if (stop == Stop::no) return false;
    auto& summary = recorder_.summary();
    const std::string known = summary.message.empty() ? "" : summary.message + "; ";
    summary.outcome = Outcome::interrupted;
    summary.message = why_stopped(stop) + ": " + known + unknown;
    return true;
  }

  /// Forces that balance loads: the most balanced ones, and between which ends those of supports can be.
  /// @param of_what  which loads, with the sign behind it
  void stands(const RigidLimits<dim>& limits, const LimitAnswer<dim>& at_rest, const std::string& of_what) {
    auto& summary = recorder_.summary();
    auto& rigid = *summary.rigid;
    summary.outcome = Outcome::equilibrium;
    summary.message = "forces that joints admit balance the loads" + of_what;
    double share = 0;
    const auto forces = limits.most_balanced(0, &share, at_rest);
    if (stopped("how much of every joint they can leave free is not known")) return;
    rigid.free_share = share;
    rigid.at_least = rigid.free_share >= LimitAnalysisParameters::largest_free_share;
    const bool rows = limits.is_rows();
    if (rows && !rigid.at_least) rigid.factor = 1 / (1 - rigid.free_share);
    summary.message += " they can leave " + std::string(rigid.at_least ? "at least " : "") +
                       six_digits(100 * rigid.free_share) + " % of every dry joint free" + words_of_share(rigid, rows);
    recorder_.record_forces(limits.on_points(forces), stage, scene_.load_factor.asked() ? 0 : 1);
    const int supports = static_cast<int>(scene_.supports.size());
    const auto ranges = limits.reactions(supports, 0, at_rest);
    if (stopped("between which ends reactions can be is not known")) return;
    for (int k = 0; k < supports; ++k) {
      const auto& name = scene_.supports[static_cast<std::size_t>(k)].name;
      auto& range = rigid.reactions[name];
      std::string words;
      for (int c = 0; c < dim; ++c) {
        const auto& found = ranges[static_cast<std::size_t>(k)][c];
        range[c] = {found.least.value_or(-INFINITY), found.most.value_or(INFINITY)};
        if (range[c].least == 0 && range[c].most == 0) continue;
        words += (words.empty() ? " can push " : ", ") + words_of_range<dim>(range[c], c);
      }
      say_ << "Support '" << name << "'" << (words.empty() ? " bears nothing" : words) << ".\n";
    }
  }

  /// How far the pattern of a load factor search can be raised. In space forces within cones are looked for first, from
  /// those that balance the loads before; the programme of pyramids around the cones begins where they end.
  void raise(const RigidLimits<dim>& limits, const LimitAnswer<dim>& at_rest) {
    const auto& search = scene_.load_factor;
    auto& summary = recorder_.summary();
    LimitAnswer<dim> borne;
    if (dim == 3) borne = limits.largest_borne(search.largest, at_rest);
    if (dim == 3 && stopped("how far the pattern can be raised is not known")) return;
    const bool to_the_end = borne.verdict == LimitVerdict::unlimited;
    const auto limit = to_the_end ? borne : limits.largest_factor(search.largest, borne);
    if (stopped(dim == 2 ? std::string("how far the pattern can be raised is not known")
                         : "forces balance " + six_digits(borne.factor) +
                               " times the pattern, above which factor no equilibrium exists is not known"))
      return;
    summary.collapse = CollapseSummary{search.pattern, NAN, INFINITY, true, {}, INFINITY, INFINITY};
    auto& found = *summary.collapse;
    if (limit.verdict == LimitVerdict::limited) {
      found.certified = found.upper = limit.factor;
      if (const auto estimate = limits.without_dilatancy(search.largest, limit)) found.estimate = *estimate;
      summary.rigid->borne = dim == 2 ? limit.factor : borne.factor;
      summary.message =
          "above " + six_digits(limit.factor) +
          " times the pattern no equilibrium exists, by the static theorem; rigid stones whose slip dilates stand up "
          "to " +
          (dim == 2 ? "there" : six_digits(summary.rigid->borne) + " times it at least") +
          (std::isfinite(found.estimate) ? ", an estimate where it does not is " + six_digits(found.estimate) : "");
      falls(limits, limit, limit.factor, dim == 2 ? least_at(limits, limit) : known(borne, limit));
    } else if (limit.verdict == LimitVerdict::unlimited) {
      found.lower = search.largest;
      summary.message +=
          "; so they do at " + (limits.borne_at_any_factor()
                                    ? std::string("any factor of the pattern, since joints balance it alone")
                                    : six_digits(search.largest) + " times the pattern, the largest asked for");
    } else {
      summary.outcome = Outcome::not_converged;
      summary.message += "; how far the pattern can be raised could not be solved exactly enough";
    }
  }

  /// Of the forces that balance loads just below a limit those that press least: at the limit any may stand for all.
  LimitAnswer<dim> least_at(const RigidLimits<dim>& limits, const LimitAnswer<dim>& limit) const {
    auto least = limits.least_pressed(limit.factor * (1 - LimitAnalysisParameters::no_motion));
    return least.verdict == LimitVerdict::unlimited ? std::move(least) : limit;
  }

  static const LimitAnswer<dim>& known(const LimitAnswer<dim>& borne, const LimitAnswer<dim>& otherwise) {
    return borne.verdict == LimitVerdict::limited ? borne : otherwise;
  }

  /// The motion in which it falls, with forces that balance as much of the loads as can be.
  void falls(const RigidLimits<dim>& limits, const LimitAnswer<dim>& answer, double factor,
             const LimitAnswer<dim>& forces) {
    auto raised = factors_;
    for (const auto& [load, share] : scene_.load_factor.pattern) raised[load] += factor * share;
    recorder_.set_loads(raised, 0);
    const auto mechanism = limits.on_nodes(answer);
    auto state = step_.initial_state();
    state.lambda = limits.on_points(forces);
    recorder_.record_forces(state.lambda, std::string(stage) + ": limit", factor);
    recorder_.record_mechanism(mechanism, state, stage, factor);
    auto& summary = recorder_.summary();
    summary.outcome = Outcome::collapse;
    summary.mechanism = largest_mover(model_, mechanism);
    summary.mechanism->dilates = answer.dilates;
    summary.message += "; " + mechanism_in_words(model_, mechanism) + of_slip_that_dilates(answer.dilates);
  }

  ModelOfBlocks<dim>& model_;
  const Scene& scene_;
  std::ostream& say_;
  AdaptiveStep step_;
  Recorder recorder_;
  std::map<std::string, double> factors_;  ///< of loads, at the end of the stages
};

}  // namespace

template <int dim>
RunSummary limit_run(const Scene& scene, const BlockSource<dim>& source, const std::string& folder,
                     const Teuchos::RCP<const Teuchos::Comm<int>>& comm, std::ostream& say) {
  Teuchos::Time clock("limit analysis", true);
  if (static_stages(scene) == 0)
    throw InputError(
        scene.file + ": scene > steps > stages > " + scene.stages.front().name +
        " > duration\n  makes this a stage in time, in which inertia bears loads too: --limit-analysis judges "
        "the stages of load steps that come first, and there is none.\n  Run the scene, or leave the "
        "duration out.");
  const auto unsolved = without_load_steps(scene);
  ModelOfBlocks<dim> model(unsolved, source, comm);
  LimitRun<dim> limits(scene, model, folder, say);
  auto summary = fail_together(*comm, [&] {
    limits.warn();
    return limits.answer();
  });
  summary.scene = scene.file;
  summary.seconds["total"] = clock.totalElapsedTime(true);
  summary.peak_memory = peak_memory_per_rank(*comm);
  const bool stopped = summary.outcome == Outcome::interrupted;
  write_result_json(folder + "/" + (stopped ? interrupted_file : result_file), summary, *comm);
  return summary;
}

template RunSummary limit_run(const Scene&, const BlockSource<2>&, const std::string&,
                              const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream&);
template RunSummary limit_run(const Scene&, const BlockSource<3>&, const std::string&,
                              const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream&);

}  // namespace voussoir
