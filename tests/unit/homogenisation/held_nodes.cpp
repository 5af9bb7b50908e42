// Multigrid of the continuum where supports hold so much that nodes are alone between held ones, or on a line.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <functional>

#include "homogenisation/continuum.hpp"
#include "linalg/linear_solver.hpp"
#include "unit/blocks/cubes.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr int n = 8;       // cells along an edge of a cube
constexpr int middle = 4;  // a node there is in the middle of it, and of the joint in the middle of both cubes

struct Solved {
  int iterations = 0;
  double residual = 1;
  std::size_t levels = 0;
};

/// Under noise on what is free.
template <int dim>
Solved solved(const BlockSource<dim>& source, const Structure<dim>& s, const std::vector<char>& held,
              const Teuchos::ParameterList& muelu = {}) {
  const ContactPoints points(source, s);
  const Continuum continuum(s, points, held, muelu);
  const auto b = noise_vector(continuum.space().map());
  for (int i = 0; i < dim * continuum.space().owned_clusters(); ++i)
    if (continuum.space().held()[i]) local_view_to_write(*b)[i] = 0;
  const auto x = Teuchos::rcp(new TpetraVector(b->getMap()));
  LinearSolver solver({});
  const auto result = solver.solve(continuum.matrix(), continuum.preconditioner(), b, x, 1e-8);
  return {result.iterations, relative_residual(*continuum.matrix(), *b, *x), continuum.levels().size()};
}

/// The lower of two cubes is held, but for nodes on its lattice, which are held along the first axis at most.
using IsFree = std::function<bool(int i, int j, int k)>;

Solved lower_cube_held(const IsFree& is_free, bool along_x = false, const Teuchos::ParameterList& muelu = {}) {
  const auto source = two_cubes(n);
  const auto s = structure_of(*source, everyone());
  std::vector<char> held(3 * s.nodes(), 0);
  for (int node = 0; node < s.nodes(); ++node) {
    std::array<int, 3> at{};
    for (int a = 0; a < 3; ++a) {
      Vector<3> axis{};
      axis[a] = 1;
      at[a] = static_cast<int>(std::lround(n * dot(s.position()[node], turned(axis))));
    }
    if (s.blocks()[s.block_of_node()[node]].mesh.id == 1 || at[2] > n) continue;
    const bool free = is_free(at[0], at[1], at[2]);
    for (int c = 0; c < 3; ++c) held[3 * node + c] = !free || (along_x && c == 0);
  }
  return solved<3>(*source, s, held, muelu);
}

bool inside(int i, int j, int k) { return std::min({i, j, k}) > 0 && std::max({i, j, k}) < n; }
bool nowhere(int, int, int) { return false; }
bool in_the_middle(int i, int j, int k) { return i == middle && j == middle && k == middle; }
bool beside_each_other(int i, int j, int k) { return (i == middle || i == middle - 1) && j == middle && k == middle; }
bool on_a_line(int i, int j, int k) { return inside(i, j, k) && i == middle && k == middle; }
bool on_lines(int i, int j, int k) { return inside(i, j, k) && j % 2 == 0 && k % 2 == 0; }
bool alone(int i, int j, int k) { return inside(i, j, k) && i % 2 == 0 && j % 2 == 0 && k % 2 == 0; }
bool of_the_joint(int i, int j, int k) { return i == middle && j == middle && k == n; }

// MueLu alone fails at single nodes, and takes 24 iterations on a line. Where the node of the joint is free all its
// neighbours belong to the other cube, and so to another rank: to multigrid it is a group of its own there.
TEUCHOS_UNIT_TEST(HeldNodes, TakeAsManyIterationsWhateverIsFreeBetweenThem) {
  const auto whole = lower_cube_held(nowhere);
  TEST_EQUALITY(whole.levels, 2u);
  const IsFree patterns[]{in_the_middle, beside_each_other, on_a_line, on_lines, ::alone, of_the_joint};
  const auto compare = [&](const Solved& result) {
    out << result.iterations << " iterations, " << whole.iterations << " with all held\n";
    TEST_EQUALITY(result.levels, 2u);
    TEST_COMPARE(result.residual, <=, 1.001e-8);
    // Nodes that are each for themselves add eigenvalues up to 2 and down to a half or so.
    TEST_COMPARE(result.iterations, <=, whole.iterations + 2);
  };
  for (const auto& is_free : patterns) compare(lower_cube_held(is_free));
  compare(lower_cube_held(in_the_middle, true));
}

// Stones of 2 x 2 cells: the one node inside of each is free, in the lower half of the wall.
TEUCHOS_UNIT_TEST(HeldNodes, TakeAsManyIterationsInThePlane) {
  WallParameters parameters;
  parameters.courses = parameters.blocks_per_course = 16;
  parameters.cells_along = 2;
  const auto source = make_wall(parameters);
  const auto s = structure_of(*source, everyone());
  int iterations[2];
  for (const bool free : {false, true}) {
    std::vector<char> held(2 * s.nodes(), 0);
    for (int i = 0; i < s.nodes(); ++i) {
      const double course = s.position()[i][1] / parameters.block_height;
      const bool is_inside = std::abs(course - std::floor(course) - 0.5) < 0.1;
      const auto& block = s.blocks()[s.block_of_node()[i]];
      bool between = true;
      for (const int end : {0, block.nodes - 1})
        between = between && std::abs(s.position()[i][0] - s.position()[block.first_local + end][0]) > 1e-9;
      if (course < 8.1 && !(free && is_inside && between)) held[2 * i] = held[2 * i + 1] = 1;
    }
    const auto result = solved<2>(*source, s, held);
    TEST_EQUALITY(result.levels, 2u);
    TEST_COMPARE(result.residual, <=, 1.001e-8);
    iterations[free] = result.iterations;
  }
  out << iterations[true] << " iterations, " << iterations[false] << " with all held\n";
  TEST_COMPARE(iterations[true], <=, iterations[false] + 2);
}

// As where everything but single nodes is held: there is nothing left to coarsen.
TEUCHOS_UNIT_TEST(HeldNodes, NeedNoMultigridWhereAllOthersAreHeld) {
  const auto source = two_cubes(n);
  const auto s = structure_of(*source, everyone());
  std::vector<char> held(3 * s.nodes(), 1);
  for (int b = 0; b < static_cast<int>(s.blocks().size()); ++b) {
    const int inside_of_it = s.nodes_of(b).first_local + ((n + 1) * (n + 1) + n + 2) * middle;
    for (int c = 0; c < 3; ++c) held[3 * inside_of_it + c] = 0;
  }
  const auto result = solved<3>(*source, s, held);
  TEST_EQUALITY(result.levels, 0u);
  TEST_COMPARE(result.residual, <=, 1.001e-8);
  TEST_COMPARE(result.iterations, <=, 6);  // unknowns
}

// Without the diagonal of columns of zeros the coarsest matrix is singular, on one rank: that must be a failure of all
// ranks, before an iteration begins, and the factors of the whole continuum take over.
TEUCHOS_UNIT_TEST(Continuum, IsFactoredWhereMultigridFails) {
  if (everyone()->getSize() == 1) return;  // the node of the joint has neighbours
  Teuchos::ParameterList muelu("MueLu");
  muelu.set("rap: fix zero diagonals", false);
  const auto result = lower_cube_held(of_the_joint, false, muelu);
  TEST_EQUALITY(result.levels, 0u);
  TEST_EQUALITY(result.iterations, 1);
  TEST_COMPARE(result.residual, <=, 1e-8);
}

}  // namespace
