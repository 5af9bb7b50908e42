#include "linalg/amg_preconditioner.hpp"

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"

namespace voussoir {
namespace {

using Coordinates = Tpetra::MultiVector<double, LocalOrdinal, GlobalOrdinal, TpetraMap::node_type>;

using LevelMatrix = Teuchos::RCP<Xpetra::Matrix<double, LocalOrdinal, GlobalOrdinal, TpetraMap::node_type>>;

using CoarseSolver = Teuchos::RCP<MueLu::SmootherBase<double, LocalOrdinal, GlobalOrdinal, TpetraMap::node_type>>;

/// Null on ranks without a row of it: there MueLu keeps nothing, or an operator that is no matrix.
LevelMatrix matrix_of(MueLu::Level& level) {
  if (!level.IsAvailable("A")) return {};
  try {
    return level.Get<LevelMatrix>("A");
  } catch (const Teuchos::bad_any_cast&) {
    return {};
  }
}

constexpr int first_small_level = 2;  // of some 60th part of the unknowns
constexpr int last_level = 9;         // MueLu makes ten
/// In space a level has some 20th of the unknowns of the one above, so that the first of them is small too. On many
/// ranks a fifth of what a rank has of it lies at its border.
constexpr int first_swept_level(int dim, int ranks) {
  return dim == 2 && ranks == 1 ? first_small_level : first_small_level - 1;
}
/// Nodes of an aggregate in the plane on many ranks, at least: more than half of the nine of a lattice. MueLu makes
/// aggregates of two, which are many along borders of ranks.
constexpr int least_of_aggregate = 5;
/// Steps of conjugate gradients to prolongators of least energy, in space (README.md, "Decisions").
constexpr int steps_to_least_energy = 4;

bool names_smoothers(const Teuchos::ParameterList& list) {
  for (auto entry = list.begin(); entry != list.end(); ++entry)
    if (list.name(entry).rfind("smoother:", 0) == 0) return true;
  return false;
}

/// Along slanting borders, as those of ranks, aggregates come out uneven, and those of aggregates more so: small levels
/// grow theirs from one to the next, and sweep three times, which costs little there (README.md, "Decisions").
void treat_small_levels(Teuchos::ParameterList& list, int dim, int ranks, const Teuchos::ParameterList& overrides) {
  for (int l = first_swept_level(dim, ranks); l <= last_level; ++l) {
    const auto name = "level " + std::to_string(l);
    auto& level = list.sublist(name);
    const bool own = overrides.isSublist(name) && names_smoothers(overrides.sublist(name));
    if (!own && !names_smoothers(overrides)) smooth_by_gauss_seidel(level, 3);
    if (l >= first_small_level && !overrides.isParameter("aggregation: ordering"))
      level.set("aggregation: ordering", "graph");
  }
}

/// Debian's direct coarse solver is wrong on more than one rank, so a level small enough to be the coarsest, also where
/// the user says how small, must be too small for two.
void keep_coarsest_on_one_rank(Teuchos::ParameterList& list) {
  const char* const coarsest = "coarse: max size";
  const char* const least = "repartition: min rows per proc";
  if (list.isType<int>(coarsest) && list.isType<int>(least))
    list.set(least, std::max(list.get<int>(coarsest), list.get<int>(least)));
}

/// Whoever names smoothers gets those alone: MueLu lets ours go before "smoother: type".
Teuchos::ParameterList parameters_for(int dim, int ranks, const Teuchos::ParameterList& overrides) {
  Teuchos::ParameterList list("MueLu");
  list.set("verbosity", "none");
  list.set("number of equations", dim);
  list.set("problem: symmetric", true);
  list.set("coarse: max size", 1000);
  list.set("rap: fix zero diagonals", true);  // an aggregate of one node has columns of zeros for its turns
  if (!names_smoothers(overrides)) smooth_by_gauss_seidel(list, 1);
  treat_small_levels(list, dim, ranks, overrides);
  if (dim == 2 && ranks > 1) list.set("aggregation: min agg size", least_of_aggregate);
  if (dim == 3) {
    list.set("multigrid algorithm", "emin");
    list.set("emin: num iterations", steps_to_least_energy);
  }
  if (ranks > 1) {
    list.set("repartition: enable", true);
    list.set("repartition: partitioner", "zoltan2");
    list.set("repartition: start level", 1);
    list.set("repartition: min rows per proc", 2000);
  }
  list.setParameters(overrides);
  if (ranks > 1) keep_coarsest_on_one_rank(list);
  return list;
}

/// MueLu factors its coarsest level, which is on one rank, where it first solves with it. That would fail inside an
/// iteration, on that rank alone, and again at each.
template <class Hierarchy>
void factor_coarsest(Hierarchy& hierarchy) {
  const auto& level = hierarchy.GetLevel(hierarchy.GetNumLevels() - 1);
  const auto a = matrix_of(*level);
  if (a.is_null() || !level->IsAvailable("PreSmoother")) return;
  using Vectors = Xpetra::MultiVectorFactory<double, LocalOrdinal, GlobalOrdinal, TpetraMap::node_type>;
  const auto b = Vectors::Build(a->getRangeMap(), 1), x = Vectors::Build(a->getDomainMap(), 1);
  b->putScalar(1);
  try {
    level->template Get<CoarseSolver>("PreSmoother")->Apply(*x, *b, true);
  } catch (const std::runtime_error& error) {
    throw SolverFailure(std::string("MueLu could not solve its coarsest level: ") + error.what());
  }
  if (!std::isfinite(x->getVector(0)->norm2()))
    throw SolverFailure("MueLu could not solve its coarsest level: the solution is not a number");
}

}  // namespace

/// Forwards down and backwards up: symmetric, an iteration more than symmetric sweeps take, 0.75 of their time.
void smooth_by_gauss_seidel(Teuchos::ParameterList& list, int sweeps) {
  for (const auto* way : {"pre", "post"}) {
    const std::string smoother = std::string("smoother: ") + way;
    list.set(smoother + " type", "RELAXATION");
    auto& parameters = list.sublist(smoother + " params");
    parameters.set("relaxation: type", "Gauss-Seidel");
    parameters.set("relaxation: sweeps", sweeps);
  }
  list.sublist("smoother: post params").set("relaxation: backward mode", true);
}

struct AmgPreconditioner::Data {
  Teuchos::RCP<MueLu::TpetraOperator<double, LocalOrdinal, GlobalOrdinal, TpetraMap::node_type>> hierarchy;
};

AmgPreconditioner::AmgPreconditioner(const Teuchos::RCP<TpetraMatrix>& a,
                                     const Teuchos::RCP<TpetraMultiVector>& coordinates,
                                     const Teuchos::RCP<TpetraMultiVector>& near_null, int dim,
                                     const Teuchos::ParameterList& overrides, TrafficOf sent_for)
    : data_(std::make_unique<Data>()), sent_for_(sent_for) {
  auto list = parameters_for(dim, a->getComm()->getSize(), overrides);
  // MueLu gives a part that finds no rank with rows to rank -1.
  if (any_of_ranks(*a->getComm(), a->getNodeNumRows() == 0)) list.set("repartition: remap parts", false);
  auto& user = list.sublist("user data");
  user.set("Coordinates", Teuchos::RCP<Coordinates>(coordinates));
  user.set("Nullspace", near_null);
  Teuchos::RCP<TpetraOperator> op = a;
  data_->hierarchy = MueLu::CreateTpetraPreconditioner(op, list);
  all_or_none(*a->getComm(), [&] { factor_coarsest(*data_->hierarchy->GetHierarchy()); });
}

AmgPreconditioner::~AmgPreconditioner() = default;

void AmgPreconditioner::apply(const TpetraVector& r, TpetraVector& z) const {
  const TrafficScope sent_for(sent_for_);
  data_->hierarchy->apply(r, z);
}

std::vector<MultigridLevel> AmgPreconditioner::levels() const {
  auto& hierarchy = *data_->hierarchy->GetHierarchy();
  const auto& comm = *data_->hierarchy->getDomainMap()->getComm();
  std::vector<MultigridLevel> levels(static_cast<std::size_t>(hierarchy.GetGlobalNumLevels()));
  for (int l = 0; l < static_cast<int>(levels.size()); ++l) {
    const auto a = l < hierarchy.GetNumLevels() ? matrix_of(*hierarchy.GetLevel(l)) : LevelMatrix();
    const long long rows = a.is_null() ? 0 : static_cast<long long>(a->getNodeNumRows());
    const long long entries = a.is_null() ? 0 : static_cast<long long>(a->getNodeNumEntries());
    levels[l].rows = total_over_ranks(comm, rows);
    levels[l].entries = total_over_ranks(comm, entries);
    levels[l].ranks = total_over_ranks(comm, rows > 0 ? 1 : 0);
  }
  return levels;
}

}  // namespace voussoir
