#include "statics/linear_programme.hpp"

#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#include <CoinError.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "statics/limit_analysis_parameters.hpp"

namespace voussoir {
namespace {

bool (*asked_to_stop)() = nullptr;

bool is_to_stop() { return asked_to_stop && asked_to_stop(); }

/// Between iterations of CLP, which take microseconds.
class Listener final : public ClpEventHandler {
 public:
  ClpEventHandler* clone() const override { return new Listener(*this); }
  int event(Event) override {
    const int go_on = -1, stop = 1;  // as CLP reads them
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return go_on;
    next_ = now + std::chrono::milliseconds(100);
    return is_to_stop() ? stop : go_on;
  }

 private:
  std::chrono::steady_clock::time_point next_;
};

double bound(double value) { return std::isfinite(value) ? value : std::copysign(COIN_DBL_MAX, value); }

}  // namespace

struct LinearProgramme::Parts {
  ClpSimplex simplex;
  std::vector<double> row_lower, row_upper, lower, upper, cost, value;
  std::vector<CoinBigIndex> start{0};
  std::vector<int> row;
  bool loaded = false;
  std::size_t given = 0;  ///< columns that CLP has

  void load() {
    if (loaded) return give_columns();
    const int columns = static_cast<int>(lower.size());
    const CoinPackedMatrix matrix(true, static_cast<int>(row_lower.size()), columns, start.back(), value.data(),
                                  row.data(), start.data(), nullptr);
    simplex.loadProblem(matrix, lower.data(), upper.data(), cost.data(), row_lower.data(), row_upper.data());
    loaded = true;
    given = lower.size();
  }

  /// Those that were added, all at once: CLP copies its whole matrix for each call.
  void give_columns() {
    if (given == lower.size()) return;
    const auto first = start[given];
    std::vector<CoinBigIndex> begins;
    for (std::size_t k = given; k < start.size(); ++k) begins.push_back(start[k] - first);
    simplex.addColumns(static_cast<int>(lower.size() - given), lower.data() + given, upper.data() + given,
                       cost.data() + given, begins.data(), row.data() + first, value.data() + first);
    for (; given < lower.size(); ++given) simplex.setColumnStatus(static_cast<int>(given), ClpSimplex::atLowerBound);
  }
};

void rest_at_lower_bound(ProgrammeBasis& basis, int column) {
  constexpr unsigned char kind = 7;  // bits of a status that say which it is
  if (basis.size() <= static_cast<std::size_t>(column)) return;
  auto& status = basis[static_cast<std::size_t>(column)];
  if ((status & kind) != ClpSimplex::basic)
    status = static_cast<unsigned char>((status & ~kind) | ClpSimplex::atLowerBound);
}

void end_linear_programmes_when(bool (*asked)()) { asked_to_stop = asked; }

LinearProgramme::LinearProgramme() : parts_(std::make_unique<Parts>()) {
  const Listener listener;
  parts_->simplex.passInEventHandler(&listener);
  parts_->simplex.setLogLevel(0);
  parts_->simplex.setOptimizationDirection(-1);
  parts_->simplex.scaling(0);  // callers give rows and columns of size one; scaled prices may be worth nothing unscaled
  parts_->simplex.setPrimalTolerance(LimitAnalysisParameters::tolerance);
  parts_->simplex.setDualTolerance(LimitAnalysisParameters::tolerance);
}
LinearProgramme::~LinearProgramme() = default;
LinearProgramme::LinearProgramme(LinearProgramme&&) noexcept = default;
LinearProgramme& LinearProgramme::operator=(LinearProgramme&&) noexcept = default;

int LinearProgramme::add_row(double lower, double upper) {
  VOUSSOIR_EXPECT(lower <= upper && "bounds: ascending");
  parts_->row_lower.push_back(bound(lower));
  parts_->row_upper.push_back(bound(upper));
  return rows() - 1;
}

int LinearProgramme::add_column(std::vector<ProgrammeEntry> entries, double lower, double upper, double cost) {
  VOUSSOIR_EXPECT(lower <= upper && "bounds: ascending");
  auto& p = *parts_;
  for (const auto& e : entries) {
    if (e.value == 0) continue;
    p.row.push_back(e.row);
    p.value.push_back(e.value);
  }
  p.start.push_back(static_cast<CoinBigIndex>(p.row.size()));
  p.lower.push_back(bound(lower));
  p.upper.push_back(bound(upper));
  p.cost.push_back(cost);
  return columns() - 1;
}

void LinearProgramme::set_row(int row, double lower, double upper) {
  VOUSSOIR_EXPECT(row >= 0 && row < rows() && "row: of the programme");
  VOUSSOIR_EXPECT(lower <= upper && "bounds: ascending");
  parts_->row_lower[static_cast<std::size_t>(row)] = bound(lower);
  parts_->row_upper[static_cast<std::size_t>(row)] = bound(upper);
  if (parts_->loaded) parts_->simplex.setRowBounds(row, bound(lower), bound(upper));
}

void LinearProgramme::set_column(int column, double lower, double upper) {
  VOUSSOIR_EXPECT(column >= 0 && column < columns() && "column: of the programme");
  VOUSSOIR_EXPECT(lower <= upper && "bounds: ascending");
  parts_->lower[static_cast<std::size_t>(column)] = bound(lower);
  parts_->upper[static_cast<std::size_t>(column)] = bound(upper);
  if (static_cast<std::size_t>(column) < parts_->given)
    parts_->simplex.setColumnBounds(column, bound(lower), bound(upper));
}

void LinearProgramme::set_cost(int column, double cost) {
  VOUSSOIR_EXPECT(column >= 0 && column < columns() && "column: of the programme");
  parts_->cost[static_cast<std::size_t>(column)] = cost;
  if (static_cast<std::size_t>(column) < parts_->given) parts_->simplex.setObjectiveCoefficient(column, cost);
}

int LinearProgramme::rows() const { return static_cast<int>(parts_->row_lower.size()); }
int LinearProgramme::columns() const { return static_cast<int>(parts_->lower.size()); }

ProgrammeBasis LinearProgramme::basis() const {
  if (!parts_->loaded) return {};
  parts_->give_columns();
  const unsigned char* status = parts_->simplex.statusArray();
  return {status, status + columns() + rows()};
}

void LinearProgramme::start_from(ProgrammeBasis basis) {
  const auto of_rows = static_cast<std::size_t>(rows()), all = static_cast<std::size_t>(columns()) + of_rows;
  if (basis.size() < of_rows || basis.size() > all) return;
  parts_->load();
  basis.insert(basis.end() - rows(), all - basis.size(), static_cast<unsigned char>(ClpSimplex::atLowerBound));
  parts_->simplex.copyinStatus(basis.data());
}

ProgrammeSolution LinearProgramme::maximise() {
  if (is_to_stop()) return {};
  auto& simplex = parts_->simplex;
  try {
    const bool again = parts_->loaded;
    parts_->load();
    if (again) {
      simplex.primal();
    } else {
      ClpSolve how;
      how.setSolveType(ClpSolve::useDual);
      how.setPresolveType(ClpSolve::presolveOff);  // undone, it leaves prices less exact
      simplex.initialSolve(how);
      // Costs of columns without bounds leave its first basis without feasible prices; what it then takes for a
      // contradiction is none until the primal method, from the same basis, agrees.
      if (simplex.status() != 0) simplex.primal();
    }
  } catch (const CoinError&) {
    return {};
  }
  return solution();
}

ProgrammeSolution LinearProgramme::maximise_from_prices() {
  if (is_to_stop()) return {};
  auto& simplex = parts_->simplex;
  try {
    parts_->load();
    simplex.dual();
    if (simplex.status() != 0) simplex.primal();
  } catch (const CoinError&) {
    return {};
  }
  return solution();
}

ProgrammeSolution LinearProgramme::solution() const {
  const auto& simplex = parts_->simplex;
  ProgrammeSolution solution;
  constexpr ProgrammeEnd ends[] = {ProgrammeEnd::optimal, ProgrammeEnd::infeasible, ProgrammeEnd::unbounded};
  const int status = simplex.status();
  solution.end = status >= 0 && status < 3 ? ends[status] : ProgrammeEnd::failed;
  solution.value = simplex.objectiveValue();
  const double* x = simplex.getColSolution();
  const double* price = simplex.getRowPrice();
  solution.x.assign(x, x + columns());
  solution.price.assign(price, price + rows());
  solution.iterations = simplex.numberIterations();
  return solution;
}

}  // namespace voussoir
