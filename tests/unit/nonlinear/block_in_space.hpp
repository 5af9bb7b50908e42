// A square block of four elastic corners on the ground, in space: weight on every corner, springs that hold it, forces.
//
// Unknowns are the displacements (x, y, z) of the corners. Corners are joined by springs along edges and diagonals, and
// each is tied to where it was by a soft spring along x and y, so that a block that slides comes to rest.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Teuchos_DefaultSerialComm.hpp>

#include "linalg/local_view.hpp"
#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir::test {

class BlockInSpace : public NonlinearProblem {
 public:
  static constexpr int corners = 4, unknowns = 12;
  static constexpr double weight = 25, holding = 1000, stone = 1e6;  // [N], [N/m], [N/m]
  static constexpr double radius = 0.5;                              // [m] of the corners
  using Place = std::array<double, 2>;

  /// @param force  [N] along x and y at each corner
  BlockInSpace(double friction, const std::array<Place, corners>& force) : law_(corners, {friction, 0, 0}) {
    map_ = Teuchos::rcp(new TpetraMap(unknowns, unknowns, 0, Teuchos::rcp(new Teuchos::SerialComm<int>())));
    for (int a = 0; a < corners; ++a) {
      load_[3 * a] = force[a][0];
      load_[3 * a + 1] = force[a][1];
      load_[3 * a + 2] = -weight;
      stiffness_[3 * a][3 * a] += holding;
      stiffness_[3 * a + 1][3 * a + 1] += holding;
      for (int b = 0; b < a; ++b) join(a, b);
    }
  }
  /// Of a corner, from the middle.
  static Place corner(int a) {
    const double angle = (a + 0.5) * std::acos(-1.0) / 2;
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

  Teuchos::RCP<const TpetraMap> map() const override { return map_; }
  int components() const override { return 3; }
  int points() const override { return corners; }
  int owned_points() const override { return corners; }
  const std::vector<char>& selected() const override { return selected_; }
  const PointLaws& law() const override { return law_; }
  const std::vector<double>& local_stiffness() const override { return local_stiffness_; }
  const PointField& slip_origin() const override { return none_; }
  void evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) override {
    evaluate_direction(x, r, gap);
    for (int i = 0; i < unknowns; ++i) local_view_to_write(r)[i] -= load_[i];
  }
  void evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) override {
    const double* u = local_view(d);
    gap.assign(3 * corners, 0.0);
    for (int a = 0; a < corners; ++a)
      for (int c = 0; c < 3; ++c) gap[3 * a + c] = u[3 * a + axis(c)];
    std::vector<double> sum(unknowns, 0.0);
    for (int i = 0; i < unknowns; ++i)
      for (int j = 0; j < unknowns; ++j) sum[i] += stiffness_[i][j] * u[j];
    std::copy(sum.begin(), sum.end(), local_view_to_write(y));
  }
  void subtract_contact_forces(const PointField& lambda, TpetraVector& r) override {
    for (int a = 0; a < corners; ++a)
      for (int c = 0; c < 3; ++c) local_view_to_write(r)[3 * a + axis(c)] -= lambda[3 * a + c];
  }
  const std::vector<double>& proximal_weight() const override { return proximal_; }
  LinearSolveResult solve(const std::vector<PointStiffness>& resistance, double proximal,
                          const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                          const SolveRequest&) override {
    auto h = stiffness_;
    for (int a = 0; a < corners; ++a) {
      const auto& r = resistance[a];
      h[3 * a + 2][3 * a + 2] += r.normal;
      for (int t = 0; t < 2; ++t) {
        h[3 * a + t][3 * a + 2] += r.coupling[t];
        for (int u = 0; u < 2; ++u) h[3 * a + t][3 * a + u] += r.along(t, u);
      }
    }
    for (int i = 0; i < unknowns; ++i) h[i][i] += proximal * proximal_[i];
    std::vector<double> x(local_view(*b), local_view(*b) + unknowns);
    eliminate(h, x);
    std::copy(x.begin(), x.end(), local_view_to_write(*d));
    return {1, true, "", false};
  }
  double force_scale() const override { return weight; }
  double length_scale() const override { return 2 * radius; }

 private:
  using Matrix = std::array<std::array<double, unknowns>, unknowns>;
  static int axis(int component) { return component == 0 ? 2 : component - 1; }
  /// A spring along the line between two corners.
  void join(int a, int b) {
    const Place p = corner(a), q = corner(b);
    const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
    const double e[] = {(q[0] - p[0]) / length, (q[1] - p[1]) / length};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (const auto& [m, n, sign] : {std::tuple{a, a, 1}, {b, b, 1}, {a, b, -1}, {b, a, -1}})
          stiffness_[3 * m + i][3 * n + j] += sign * stone * e[i] * e[j];
  }
  /// Gauss with pivots of rows.
  static void eliminate(Matrix& h, std::vector<double>& x) {
    for (int i = 0; i < unknowns; ++i) {
      int p = i;
      for (int k = i; k < unknowns; ++k)
        if (std::abs(h[k][i]) > std::abs(h[p][i])) p = k;
      std::swap(h[i], h[p]);
      std::swap(x[i], x[p]);
      for (int k = 0; k < unknowns; ++k) {
        if (k == i) continue;
        const double share = h[k][i] / h[i][i];
        for (int j = i; j < unknowns; ++j) h[k][j] -= share * h[i][j];
        x[k] -= share * x[i];
      }
    }
    for (int i = 0; i < unknowns; ++i) x[i] /= h[i][i];
  }

  Teuchos::RCP<const TpetraMap> map_;
  PointLaws law_;
  std::vector<char> selected_ = std::vector<char>(corners, 1);
  std::vector<double> local_stiffness_ = std::vector<double>(corners, stone);
  std::vector<double> proximal_ = std::vector<double>(unknowns, 1e-3);
  std::array<double, unknowns> load_{};
  Matrix stiffness_{};
  PointField none_;
};

}  // namespace voussoir::test
