#include "model/stated_problem.hpp"

#include <algorithm>
#include <map>

#include "base/check.hpp"
#include "linalg/local_view.hpp"
#include "linalg/mpi_handle.hpp"
#include "model/contact_problem.hpp"
#include "output/even_rows.hpp"

namespace voussoir {
namespace {

class Statement {
 public:
  Statement(ContactProblem& problem, const TpetraVector& x, const PointField& lambda)
      : problem_(problem),
        parts_(problem.parts()),
        space_(problem.space()),
        dim_(problem.components()),
        x_(x, Teuchos::Copy),
        lambda_(lambda) {
    stated_.components = dim_;
    number_forces();
    number_unknowns();
  }

  FclibProblem all() {
    write_stiffness();
    write_springs();
    write_points();
    write_vectors();
    return std::move(stated_);
  }

 private:
  MPI_Comm mpi() const { return mpi_handle(*parts_.structure.comm()); }
  bool free(int unknown) const { return !space_.held()[unknown]; }
  int owned_unknowns() const { return dim_ * space_.owned_clusters(); }
  double give(int point, int component) const {
    return parts_.compliance.empty() ? 0.0 : parts_.compliance[point].along(component);
  }

  void number_forces() {
    std::vector<long long> ids;
    for (int k = 0; k < problem_.owned_points(); ++k)
      if (problem_.selected()[k]) {
        points_.push_back(k);
        ids.push_back(problem_.number_of(k));
      }
    long long count = 0;
    for (const auto number : numbered_without_gaps(ids, parts_.points.total(), mpi(), count))
      for (int c = 0; c < dim_; ++c) stated_.h.column.push_back(dim_ * number + c);
    stated_.h.columns = dim_ * count;
  }

  /// Numbers of free unknowns, known to ranks that read them; then of springs.
  void number_unknowns() {
    const auto& node_id = parts_.structure.node_id();
    const long long of_nodes = dim_ * parts_.structure.total_nodes(), of_points = dim_ * parts_.points.total();
    std::vector<long long> ids;
    for (int k = 0; k < owned_unknowns(); ++k)
      if (free(k)) ids.push_back(dim_ * node_id[space_.representative()[k / dim_]] + k % dim_);
    unknowns_ = static_cast<int>(ids.size());
    for (const int k : points_)
      for (int c = 0; c < dim_; ++c)
        if (give(k, c) > 0) ids.push_back(of_nodes + dim_ * problem_.number_of(k) + c);
    long long count = 0;
    stated_.m.column = numbered_without_gaps(ids, of_nodes + of_points, mpi(), count);
    stated_.m.columns = stated_.m.rows = stated_.h.rows = count;
    TpetraVector number(space_.map()), seen(space_.column_map());
    number.putScalar(-1);
    double* value = local_view_to_write(number);  // whole numbers far below 2^53
    for (int k = 0, next = 0; k < owned_unknowns(); ++k)
      if (free(k)) value[k] = static_cast<double>(stated_.m.column[next++]);
    seen.doImport(number, space_.import(), Tpetra::INSERT);
    const double* there = local_view(seen);
    number_.assign(there, there + static_cast<std::size_t>(dim_) * space_.clusters());
  }

  /// A column, its entries by rows.
  static void add(SparseColumns& matrix, const std::map<int, double>& column) {
    matrix.entries.push_back(static_cast<int>(column.size()));
    for (const auto& [row, value] : column) {
      matrix.row.push_back(row);
      matrix.value.push_back(value);
    }
  }

  /// M is symmetric: its rows are its columns.
  void write_stiffness() {
    SystemMatrix matrix(parts_.structure, parts_.points, problem_.selection(), space_);
    matrix.update(std::vector<PointStiffness>(problem_.points()), std::vector<double>(owned_unknowns(), 0.0));
    const auto rows = matrix.local();
    for (int k = 0; k < owned_unknowns(); ++k) {
      if (!free(k)) continue;
      std::map<int, double> column;
      for (auto e = rows.start[k]; e < rows.start[k + 1]; ++e)
        if (number_[rows.column[e]] >= 0 && rows.value[e] != 0)
          column[static_cast<int>(number_[rows.column[e]])] = rows.value[e];
      add(stated_.m, column);
    }
  }

  void write_springs() {
    auto number = stated_.m.column.begin() + unknowns_;
    for (const int k : points_)
      for (int c = 0; c < dim_; ++c)
        if (give(k, c) > 0) add(stated_.m, {{static_cast<int>(*number++), 1 / give(k, c)}});
  }

  void write_points() {
    auto spring = stated_.m.column.begin() + unknowns_;
    for (const int k : points_) {
      const auto& axis = parts_.points.points()[k].axis;
      for (int a = 0; a < dim_; ++a) {
        std::map<int, double> column;
        parts_.points.at(k).each([&](int node, double weight) {
          const int cluster = space_.cluster()[node];
          const auto along = space_.held().to_own(cluster, axis[a]);
          for (int c = 0; c < dim_; ++c)
            if (const auto number = number_[dim_ * cluster + c]; number >= 0 && along[c] != 0)
              column[static_cast<int>(number)] += weight * along[c];
        });
        if (give(k, a) > 0) column[static_cast<int>(*spring++)] = 1;
        add(stated_.h, column);
      }
      const auto law = problem_.law()[k];
      VOUSSOIR_EXPECT(law.cohesion == 0 && law.tension == 0 && std::isfinite(law.friction) && "dry joints");
      stated_.mu.push_back(law.friction);
    }
  }

  /// f and w are residual and motion where free unknowns are 0; u is the motion where they are as they are.
  void write_vectors() {
    const auto& slipped = problem_.slip_origin();
    const auto motion = [&](const TpetraVector& where, TpetraVector& residual) {
      PointField gap;
      problem_.evaluate(where, residual, gap);
      for (std::size_t i = 0; i < slipped.size(); ++i) gap[i] -= slipped[i];
      return gap;
    };
    TpetraVector residual(problem_.map());
    const auto u = motion(x_, residual);
    double* x = local_view_to_write(x_);
    for (int k = 0; k < owned_unknowns(); ++k)
      if (free(k)) stated_.v.push_back(std::exchange(x[k], 0.0));
    const auto w = motion(x_, residual);
    auto others = lambda_;  // of points that are no unknowns
    for (int i = 0; i < dim_ * problem_.points(); ++i)
      if (problem_.selected()[i / dim_]) others[i] = 0;
    problem_.subtract_contact_forces(others, residual);
    const double* r = local_view(residual);
    for (int k = 0; k < owned_unknowns(); ++k)
      if (free(k)) stated_.f.push_back(-r[k]);
    for (const int k : points_)
      for (int i = dim_ * k; i < dim_ * (k + 1); ++i) {
        const double way = give(k, i - dim_ * k) * lambda_[i];  // of the spring
        stated_.w.push_back(w[i]);
        stated_.u.push_back(u[i] + way);
        stated_.r.push_back(lambda_[i]);
        if (give(k, i - dim_ * k) == 0) continue;
        stated_.f.push_back(0);
        stated_.v.push_back(way);
      }
  }

  ContactProblem& problem_;
  const ContactProblem::Parts& parts_;
  const MergedSpace& space_;
  const int dim_;
  TpetraVector x_;
  const PointField& lambda_;
  int unknowns_ = 0;               ///< owned and free, without springs
  std::vector<int> points_;        ///< owned, whose forces are unknown
  std::vector<long long> number_;  ///< of the unknowns that this rank reads; below 0 where they are held
  FclibProblem stated_;
};

}  // namespace

FclibProblem stated(ContactProblem& problem, const TpetraVector& x, const PointField& lambda) {
  return Statement(problem, x, lambda).all();
}

}  // namespace voussoir
