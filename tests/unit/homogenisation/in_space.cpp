// Three dimensions: contact points, unknowns, the system and the motions of blocks of two cubes, one on the other.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "homogenisation/block_motions.hpp"
#include "joints/tractions.hpp"
#include "linalg/local_view.hpp"
#include "unit/blocks/cubes.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

const Vector<3> up = turned({0, 0, 1});

enum class Chosen { none, even, all };
enum class On { nothing, ground, normals };

/// The cubes with the points of even numbers selected, or all, or none; the lower one may be held at its base, or slide
/// on it and the upper one be held along the joint by its nodes there.
struct TwoCubes {
  std::unique_ptr<BlockSource<3>> source;
  Structure<3> structure;
  ContactPoints points;
  Held held;
  std::vector<char> selected;
  MergedSpace space;

  explicit TwoCubes(int n, Chosen chosen, On on = On::nothing)
      : source(two_cubes(n)),
        structure(structure_of(*source, everyone())),
        points(*source, structure),
        held(std::vector<char>(3 * structure.nodes(), 0)),
        selected(choice(chosen)),
        space(structure, points, selected, hold(on)) {}

  bool is_upper(int node) const { return structure.blocks()[structure.block_of_node()[node]].mesh.id == 1; }
  /// What moves all nodes of the upper cube, or of both.
  template <class Motion>
  std::vector<double> displacement(const Motion& of_place, bool both = false) const {
    std::vector<double> u(3 * structure.nodes(), 0.0);
    for (int i = 0; i < structure.nodes(); ++i)
      for (int c = 0; c < 3; ++c)
        if (both || is_upper(i)) u[3 * i + c] = of_place(structure.position()[i])[c];
    return u;
  }
  /// Resistances by chance, as stiff as the stones: positive definite along the tangents, whose directions interact.
  std::vector<PointStiffness> resistances(bool coupled) const {
    std::vector<PointStiffness> all;
    for (const auto& p : points.points()) {
      PointStiffness s;
      s.normal = 1e9 * (2 + noise(7 * p.id));
      s.tangential = {1e9 * (2 + noise(7 * p.id + 1)), 0.9e9 * noise(7 * p.id + 2), 1e9 * (2 + noise(7 * p.id + 3))};
      if (coupled) s.coupling = {1e9 * noise(7 * p.id + 4), 1e9 * noise(7 * p.id + 5)};
      all.push_back(s);
    }
    return all;
  }
  /// By the global number of an unknown, so that it does not depend on ranks.
  std::vector<double> proximal() const {
    std::vector<double> weight;
    for (int i = 0; i < 3 * space.owned_clusters(); ++i)
      weight.push_back(1e7 * (2 + noise(space.map()->getGlobalElement(i))));
    return weight;
  }

 private:
  std::vector<char> choice(Chosen chosen) const {
    std::vector<char> marks;
    for (const auto& p : points.points())
      marks.push_back(chosen == Chosen::all || (chosen == Chosen::even && p.id % 2 == 0));
    return marks;
  }
  const Held& hold(On on) {
    const Matrix<3> axes{up, turned({1, 0, 0}), turned({0, 1, 0})};
    for (int i = 0; i < structure.nodes(); ++i) {
      const double height = dot(structure.position()[i], up);
      const bool at_base = std::abs(height) < 1e-9, at_joint = is_upper(i) && std::abs(height - 1) < 1e-9;
      for (int c = 0; on == On::ground && at_base && c < 3; ++c) held[3 * i + c] = 1;
      if (on != On::normals || !(at_base || at_joint)) continue;
      held.set_frame(i, axes);
      held[3 * i + (at_base ? 0 : 1)] = 1;
    }
    return held;
  }
};

/// Entries of H between unknowns of this rank, as a dense matrix [columns x columns]; rows of others stay empty.
using Dense = std::vector<std::vector<double>>;

Dense rows_of(const SystemMatrix& matrix, const MergedSpace& space) {
  Dense h(3 * space.clusters(), std::vector<double>(3 * space.clusters(), 0.0));
  const auto rows = matrix.local();
  for (int i = 0; i < 3 * space.owned_clusters(); ++i)
    for (std::size_t e = rows.start[i]; e < rows.start[i + 1]; ++e) h[i][rows.column[e]] += rows.value[e];
  return h;
}

/// R^T (K + B^T D B) R + proximal, by its definition.
Dense sum_by_definition(const TwoCubes& t, const std::vector<PointStiffness>& stiffness) {
  const int n = 3 * t.space.clusters();
  const auto& cluster = t.space.cluster();
  Dense h(n, std::vector<double>(n, 0.0));
  for (const auto& block : t.structure.blocks()) {
    const auto& k = *block.stiffness;
    const auto unknown = [&](int i) { return 3 * cluster[block.first_local + i / 3] + i % 3; };
    for (int i = 0; i < k.rows(); ++i)
      for (int e = k.start[i]; e < k.start[i + 1]; ++e) h[unknown(i)][unknown(k.column[e])] += k.value[e];
  }
  for (int q = 0; q < t.points.size(); ++q) {
    if (!t.selected[q]) continue;
    const auto& p = t.points.points()[q];
    const auto& s = stiffness[q];
    const double d[3][3] = {{s.normal, 0, 0},
                            {s.coupling[0], s.tangential[0], s.tangential[1]},
                            {s.coupling[1], s.tangential[1], s.tangential[2]}};
    Dense b(3, std::vector<double>(n, 0.0));
    for (int a = 0; a < 3; ++a)
      for (int c = 0; c < 3; ++c) {
        b[a][3 * cluster[p.shares_j.first()] + c] += p.axis[a][c];
        b[a][3 * cluster[p.shares_i.first()] + c] -= p.axis[a][c];
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int a = 0; a < 3; ++a)
          for (int c = 0; c < 3; ++c) h[i][j] += b[a][i] * d[a][c] * b[c][j];
  }
  const auto proximal = t.proximal();
  for (std::size_t i = 0; i < proximal.size(); ++i) h[i][i] += proximal[i];
  return h;
}

TEUCHOS_UNIT_TEST(ContactPointsInSpace, PairTheNodesOfTheFaceThatTwoCubesShare) {
  for (const int n : {1, 2}) {
    const TwoCubes t(n, Chosen::all);
    TEST_EQUALITY(t.points.total(), (n + 1) * (n + 1));
    TEST_EQUALITY(t.points.total_joints(), 1);
    double area = 0;
    for (int k = 0; k < t.points.size(); ++k) {
      const auto& p = t.points.points()[k];
      const auto& x = t.structure.position();
      TEST_ASSERT(!t.is_upper(p.shares_i.first()) && t.is_upper(p.shares_j.first()));
      TEST_COMPARE(norm(x[p.shares_j.first()] - x[p.shares_i.first()]), <=, 1e-15);
      TEST_FLOATING_EQUALITY(dot(x[p.shares_i.first()], up), 1.0, 1e-14);
      if (k < t.points.owned()) area += p.area;
    }
    TEST_FLOATING_EQUALITY(sum_over_ranks(*everyone(), area), 1.0, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(ContactPointsInSpace, HaveRightHandedAxesWhoseNormalLeadsFromTheLowerCubeToTheUpper) {
  const TwoCubes t(2, Chosen::all);
  for (const auto& p : t.points.points()) {
    TEST_FLOATING_EQUALITY(dot(p.axis[0], up), 1.0, 1e-14);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) TEST_COMPARE(std::abs(dot(p.axis[a], p.axis[b]) - (a == b)), <=, 1e-15 * 10);
    TEST_FLOATING_EQUALITY(dot(p.axis[0], cross(p.axis[1], p.axis[2])), 1.0, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(ContactPointsInSpace, SeeACubeThatIsLiftedPushedTwistedAndTilted) {
  const TwoCubes t(2, Chosen::all);
  const Vector<3> along = turned({1, 0, 0}), corner = turned({0, 0, 1});
  const auto motion = [&](const ContactPoint& p, const auto& of_place) {
    return PointOperator(p, 3).motion(t.displacement(of_place));
  };
  for (const auto& p : t.points.points()) {
    const auto arm = t.structure.position()[p.shares_i.first()] - corner;
    const auto lifted = motion(p, [&](const Vector<3>&) { return up; });
    TEST_FLOATING_EQUALITY(lifted[0], 1.0, 1e-14);
    TEST_COMPARE(std::hypot(lifted[1], lifted[2]), <=, 1e-14);
    const auto pushed = motion(p, [&](const Vector<3>&) { return along; });
    TEST_COMPARE(std::abs(pushed[0]), <=, 1e-14);
    TEST_FLOATING_EQUALITY(std::hypot(pushed[1], pushed[2]), 1.0, 1e-14);
    // About its corner: every point goes as far as it is away, along its joint.
    const auto twisted = motion(p, [&](const Vector<3>& x) { return cross(up, x - corner); });
    TEST_COMPARE(std::abs(twisted[0]), <=, 1e-14);
    TEST_COMPARE(std::abs(std::hypot(twisted[1], twisted[2]) - norm(arm)), <=, 1e-14);
    // About its edge along x: a point opens by its distance from the edge.
    const auto tilted = motion(p, [&](const Vector<3>& x) { return cross(along, x - corner); });
    TEST_COMPARE(std::abs(tilted[0] - dot(arm, turned({0, 1, 0}))), <=, 1e-14);
    TEST_COMPARE(std::hypot(tilted[1], tilted[2]), <=, 1e-14);
    const auto together = t.displacement([&](const Vector<3>& x) { return up + cross(along, x); }, true);
    TEST_COMPARE(norm(PointOperator(p, 3).motion(together)), <=, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(MergedSpaceInSpace, TiesCubesAtPointsThatAreNotSelected) {
  for (const int n : {1, 2}) {
    const TwoCubes bonded(n, Chosen::none), half(n, Chosen::even), free(n, Chosen::all);
    const int face = (n + 1) * (n + 1), all = 2 * (n + 1) * face;
    TEST_EQUALITY(bonded.space.map()->getGlobalNumElements(), Tpetra::global_size_t(3 * (all - face)));
    TEST_EQUALITY(half.space.map()->getGlobalNumElements(), Tpetra::global_size_t(3 * (all - face / 2)));
    TEST_EQUALITY(free.space.map()->getGlobalNumElements(), Tpetra::global_size_t(3 * all));
    for (int k = 0; k < half.points.size(); ++k)
      TEST_EQUALITY(half.space.tied(half.points.points()[k]), !half.selected[k]);
  }
}

TEUCHOS_UNIT_TEST(SystemMatrixInSpace, IsTheSumOfItsDefinition) {
  for (const int n : {1, 2})
    for (const auto chosen : {Chosen::even, Chosen::all}) {
      const TwoCubes t(n, chosen, On::ground);
      SystemMatrix matrix(t.structure, t.points, t.selected, t.space);
      const auto stiffness = t.resistances(true);
      matrix.update(stiffness, t.proximal());
      TEST_ASSERT(matrix.couple(stiffness));
      const auto found = rows_of(matrix, t.space), expected = sum_by_definition(t, stiffness);
      const auto& held = t.space.held();
      for (int i = 0; i < 3 * t.space.owned_clusters(); ++i)
        for (int j = 0; j < 3 * t.space.clusters(); ++j) {
          if (!held[i] && !held[j]) TEST_COMPARE(std::abs(found[i][j] - expected[i][j]), <=, 1e-14 * 1e10);
          if ((held[i] || held[j]) && i != j) TEST_EQUALITY(found[i][j], 0.0);
          if (held[i] && i == j) TEST_COMPARE(found[i][j], >, 0);
        }
    }
}

// H x = R^T (K R x + B^T D B R x) where unknowns of nodes go along axes of their own.
TEUCHOS_UNIT_TEST(SystemMatrixInSpace, GoesAlongTheAxesOfNodesThatAreHeldAlongANormal) {
  const TwoCubes t(2, Chosen::all, On::normals);
  SystemMatrix matrix(t.structure, t.points, t.selected, t.space);
  const auto stiffness = t.resistances(false);
  matrix.update(stiffness, {});
  TpetraVector x(t.space.map()), found(t.space.map()), expected(t.space.map());
  for (int i = 0; i < 3 * t.space.owned_clusters(); ++i)
    local_view_to_write(x)[i] = t.space.held()[i] ? 0 : noise(t.space.map()->getGlobalElement(i));
  matrix.matrix()->apply(x, found);
  std::vector<double> u, forces;
  t.space.scatter(x, u);
  for (int i = 0; i < t.structure.nodes(); ++i) {
    const Vector<3> moved{u[3 * i], u[3 * i + 1], u[3 * i + 2]};
    const double height = dot(t.structure.position()[i], up);
    if (std::abs(height) < 1e-9) TEST_COMPARE(std::abs(dot(moved, up)), <=, 1e-14);
    if (t.is_upper(i) && std::abs(height - 1) < 1e-9) TEST_COMPARE(std::abs(dot(moved, turned({1, 0, 0}))), <=, 1e-14);
  }
  t.structure.apply_stiffness(u, forces);
  std::vector<double> gap, resists;
  relative_motions(t.points, u, gap);
  resists.assign(gap.size(), 0.0);
  for (int k = 0; k < t.points.size(); ++k) {
    resists[3 * k] = stiffness[k].normal * gap[3 * k];
    for (int a = 1; a < 3; ++a)
      for (int b = 1; b < 3; ++b) resists[3 * k + a] += stiffness[k].along(a - 1, b - 1) * gap[3 * k + b];
  }
  add_contact_forces(t.points, {}, resists, 1.0, forces);
  t.space.sum(forces, expected);
  for (int i = 0; i < 3 * t.space.owned_clusters(); ++i)
    if (!t.space.held()[i]) TEST_COMPARE(std::abs(local_view(found)[i] - local_view(expected)[i]), <=, 1e-14 * 1e11);
  // What a displacement prescribes comes back, and its unknowns are those it had.
  TpetraVector back(t.space.map());
  t.space.average(u, back);
  for (int i = 0; i < 3 * t.space.owned_clusters(); ++i)
    TEST_COMPARE(std::abs(local_view(back)[i] - local_view(x)[i]), <=, 1e-14);
}

TEUCHOS_UNIT_TEST(SystemMatrixInSpace, IsSymmetricWhereFrictionDoesNotFollowThePressure) {
  const TwoCubes t(2, Chosen::all, On::ground);
  SystemMatrix matrix(t.structure, t.points, t.selected, t.space);
  const auto stiffness = t.resistances(false);
  matrix.update(stiffness, t.proximal());
  TEST_ASSERT(!matrix.couple(stiffness));
  const auto h = rows_of(matrix, t.space);
  for (int i = 0; i < 3 * t.space.owned_clusters(); ++i)
    for (int j = 0; j < i; ++j) TEST_COMPARE(std::abs(h[i][j] - h[j][i]), <=, 1e-16 * 1e10);
}

TEUCHOS_UNIT_TEST(BlockMotionsInSpace, GiveBackTheSixRigidMotionsOfEveryCubeFromWhatTheSystemMakesOfThem) {
  for (const int n : {1, 2}) {
    const TwoCubes t(n, Chosen::all);
    SystemMatrix matrix(t.structure, t.points, t.selected, t.space);
    const auto stiffness = t.resistances(false);
    matrix.update(stiffness, t.proximal());
    BlockMotions motions(t.structure, t.points, t.selected, t.space, {1, 1});
    TEST_EQUALITY(motions.size(), 12);
    motions.update(stiffness, t.proximal());
    for (int upper = 0; upper < 2; ++upper)
      for (int m = 0; m < 6; ++m) {
        Vector<3> axis{};
        axis[m % 3] = 1;
        const auto move = [&](const Vector<3>& x) { return m < 3 ? axis : cross(axis, x); };
        auto u = t.displacement(move, true);
        for (int i = 0; i < t.structure.nodes(); ++i)
          for (int c = 0; c < 3; ++c)
            if (t.is_upper(i) != (upper == 1)) u[3 * i + c] = 0;
        TpetraVector x(t.space.map()), hx(t.space.map()), back(t.space.map());
        t.space.average(u, x);
        matrix.matrix()->apply(x, hx);
        motions.add(hx, back);
        back.update(-1.0, x, 1.0);
        // Motions of about 1; moduli and proximal weights lie two orders of magnitude apart.
        TEST_COMPARE(back.normInf(), <=, 1e-11);
      }
  }
}

TEUCHOS_UNIT_TEST(SystemMatrixInSpace, ResistsNoMotionOfCubesThatNothingHolds) {
  const TwoCubes t(2, Chosen::all);
  SystemMatrix matrix(t.structure, t.points, t.selected, t.space);
  matrix.update(std::vector<PointStiffness>(t.points.size()), {});
  TpetraVector x(t.space.map()), hx(t.space.map());
  t.space.average(t.displacement([](const Vector<3>& y) { return up + cross(Vector<3>{1, 2, 3}, y); }), x);
  matrix.matrix()->apply(x, hx);
  TEST_COMPARE(hx.normInf(), <=, 1e-14 * 1e10);  // entries of about 1e9 N/m, motions of a few metres
}

}  // namespace
