#include "output/fclib_file.hpp"

#include <numeric>

#include "linalg/agree.hpp"
#include "linalg/fail_together.hpp"
#include "linalg/mpi_handle.hpp"
#include "linalg/reduce.hpp"
#include "output/even_rows.hpp"
#include "output/hdf5_file.hpp"
#include "output/safe_file.hpp"

namespace voussoir {
namespace {

constexpr int compressed_columns = -1;  ///< how FCLib names such a matrix, where others have a number of entries

const std::string elsewhere = "give another file with --fclib=FILE.hdf5";

class FclibWriter {
 public:
  FclibWriter(const std::string& file, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
      : file_(file, comm, Hdf5File::Mode::create, elsewhere), comm_(*comm) {}

  void number(const std::string& path, long long value) {
    const bool mine = comm_.getRank() == 0;
    const std::vector<int> of_first(mine ? 1 : 0, static_cast<int>(value));
    file_.write_rows(path, std::vector<long long>(of_first.size(), 0), of_first, {1, 1, ""});
  }

  void text(const std::string& path, const std::string& words) {
    file_.write_texts(path, {words + '\0'});  // whose end readers look for
  }

  void vector(const std::string& path, const std::vector<long long>& rows, const std::vector<double>& values,
              const Table& table) {
    file_.write_rows(path, rows, values, table);
  }

  void matrix(const std::string& path, const SparseColumns& a, const char* unit) {
    const auto comm = mpi_handle(comm_);
    const EvenRows even(a.column, a.columns, comm);
    const auto count = even.gather(a.entries, 1);
    std::vector<long long> start(count.size());
    long long next = sum_before(std::accumulate(count.begin(), count.end(), 0LL), comm);
    for (std::size_t k = 0; k < count.size(); ++k) {
      start[k] = next;
      next += count[k];
    }
    const auto all = total_over_ranks(comm_, static_cast<long long>(a.row.size()));
    const auto mine = even.scatter(start, 1);
    std::vector<long long> ids = a.column, entry;
    std::vector<int> pointer(mine.begin(), mine.end());
    for (std::size_t k = 0; k < mine.size(); ++k)
      for (int e = 0; e < a.entries[k]; ++e) entry.push_back(mine[k] + e);
    if (comm_.getRank() == 0) {
      ids.push_back(a.columns);
      pointer.push_back(static_cast<int>(all));
    }
    number(path + "/m", a.rows);
    number(path + "/n", a.columns);
    number(path + "/nz", compressed_columns);
    number(path + "/nzmax", all);
    file_.write_rows(path + "/p", ids, pointer, {a.columns + 1, 1, "", "where columns begin"});
    file_.write_rows(path + "/i", entry, a.row, {all, 1, "", "rows"});
    file_.write_rows(path + "/x", entry, a.value, {all, 1, unit, "values"});
  }

  void close() { file_.close(); }

 private:
  Hdf5File file_;
  const Teuchos::Comm<int>& comm_;
};

/// The points whose components are columns, by the first of them.
std::vector<long long> points_of(const SparseColumns& h, int components) {
  std::vector<long long> points;
  for (std::size_t k = 0; k < h.column.size(); k += components) points.push_back(h.column[k] / components);
  return points;
}

void write_all(FclibWriter& to, const FclibProblem& problem, bool solved, const FclibWords& words) {
  const std::string at = "/fclib_global";
  const auto& unknowns = problem.m.column;
  const auto& forces = problem.h.column;
  const auto n = problem.m.columns, m = problem.h.columns;
  to.number(at + "/spacedim", problem.components);
  to.matrix(at + "/M", problem.m, "N/m");
  to.matrix(at + "/H", problem.h, "-");
  to.vector(at + "/vectors/f", unknowns, problem.f, {n, 1, "N", "loads and what supports that move do"});
  to.vector(at + "/vectors/w", forces, problem.w, {m, 1, "m", "motion of points where v is 0"});
  to.vector(at + "/vectors/mu", points_of(problem.h, problem.components), problem.mu,
            {m / problem.components, 1, "-", "coefficient of friction"});
  to.text(at + "/info/title", words.title);
  to.text(at + "/info/description", words.description);
  to.text(at + "/info/math_info", words.math_info);
  if (solved) {
    to.vector("/solution/v", unknowns, problem.v, {n, 1, "m", "displacements"});
    to.vector("/solution/u", forces, problem.u, {m, 1, "m", "gap and slip of each point"});
    to.vector("/solution/r", forces, problem.r, {m, 1, "N", "force of each point"});
  }
  to.close();
}

}  // namespace

long long entries_of(const FclibProblem& problem, const Teuchos::Comm<int>& comm) {
  return total_over_ranks(comm, static_cast<long long>(problem.m.row.size()));
}

void write_fclib(const std::string& file, const FclibProblem& problem, bool solved, const FclibWords& words,
                 const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const std::string beside = file + ".part";
  FclibWriter to(beside, comm);
  fail_together(*comm, [&] { write_all(to, problem, solved, words); });  // before it is closed, which takes all ranks
  on_first_rank(*comm, [&] { publish_file(beside, file, elsewhere); });
}

}  // namespace voussoir
