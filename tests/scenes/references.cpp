// Walls and an arch against solutions of an independent program (reference/README.md).
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::vector<std::vector<double>> rows_of(const std::string& file) {
  std::ifstream in(repository("/tests/scenes/reference/") + file);
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error("cannot read " + file);
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::vector<double> row;
    std::stringstream words(line);
    for (std::string word; std::getline(words, word, ',');) row.push_back(std::stod(word));
    rows.push_back(row);
  }
  return rows;
}

/// Block and position; positions of the files have 9 digits.
using Place = std::tuple<long long, long long, long long>;
Place place(double block, double x, double y) {
  return {std::llround(block), std::llround(x * 1e6), std::llround(y * 1e6)};
}

/// Largest difference of displacements relative to the largest.
double displacement_error(const Solution& s, const std::string& file) {
  std::map<Place, Vector<2>> expected;
  double largest = 0, worst = 0;
  for (const auto& row : rows_of(file)) {
    expected[place(row[0], row[1], row[2])] = {row[3], row[4]};
    largest = std::max(largest, std::hypot(row[3], row[4]));
  }
  if (expected.size() != s.position.size()) throw std::runtime_error(file + " has another number of nodes");
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    const auto& x = s.position[i];
    worst = std::max(worst, norm(s.displacement[i] - expected.at(place(s.block_of_node[i], x[0], x[1]))));
  }
  return worst / largest;
}

/// Largest difference of the contact force a block receives at a node, relative to the largest such force.
double force_error(const Solution& s, const std::string& file) {
  std::map<Place, Vector<2>> force;
  const auto add = [&](double block, const Vector<2>& x, const Vector<2>& n, double p, double q, double sign) {
    auto& f = force[place(block, x[0], x[1])];
    f = f + Vector<2>{sign * (p * n[0] - q * n[1]), sign * (p * n[1] + q * n[0])};
  };
  for (const auto& row : rows_of(file)) {
    add(row[0], {row[2], row[3]}, {row[4], row[5]}, row[6], row[7], -1);
    add(row[1], {row[2], row[3]}, {row[4], row[5]}, row[6], row[7], 1);
  }
  double largest = 0, worst = 0;
  for (const auto& [where, f] : force) largest = std::max(largest, norm(f));
  for (const auto& p : s.points) {
    if (s.held[p.node_i][0] && s.held[p.node_j][0]) continue;
    add(p.block_i, p.position, p.normal, p.normal_force, p.tangential_force, 1);
    add(p.block_j, p.position, p.normal, p.normal_force, p.tangential_force, -1);
  }
  for (const auto& [where, f] : force) worst = std::max(worst, norm(f));
  return worst / largest;
}

Vector<2> reaction(const Solution& s) {
  Vector<2> sum{};
  for (std::size_t i = 0; i < s.residual.size(); ++i)
    for (int c = 0; c < 2; ++c)
      if (s.held[i][c]) sum[c] += s.residual[i][c];
  return sum;
}

void check_wall(int courses, double weight, Teuchos::FancyOStream& out, bool& success) {
  const auto s = solved(wall_scene(courses));
  const std::string name = "W" + std::to_string(courses);
  const double u = displacement_error(s, name + "_displacement.csv"), f = force_error(s, name + "_contact.csv");
  out << name << ": displacement " << u << ", forces " << f << "\n";
  TEST_COMPARE(u, <, 1e-6);
  TEST_COMPARE(f, <, 1e-5);
  // The reaction is the sum of all nodal residuals: equilibrium to 1e-8 of the largest force at each of a thousand
  // nodes is worth about 1e-7 in the sum.
  const auto r = reaction(s);
  TEST_FLOATING_EQUALITY(r[1], weight, 1e-7);
  TEST_FLOATING_EQUALITY(r[0], -0.15 * weight, 1e-6);
}

TEUCHOS_UNIT_TEST(References, WallOf4) { check_wall(4, 39240.0, out, success); }

TEUCHOS_UNIT_TEST(References, WallOf8) { check_wall(8, 156960.0, out, success); }

// Friction remembers the path, so the settlement is made in the steps of the reference; in a single step the
// difference is 3e-5.
TEUCHOS_UNIT_TEST(References, ArchOf31) {
  Scene scene = arch_scene(31);
  set_increments(scene, 20);
  const auto s = solved(scene);
  const double u = displacement_error(s, "A31_displacement.csv"), f = force_error(s, "A31_contact.csv");
  out << "A31: displacement " << u << ", forces " << f << "\n";
  TEST_COMPARE(u, <, 1e-6);
  TEST_COMPARE(f, <, 1e-5);
  TEST_FLOATING_EQUALITY(reaction(s)[1], 308058.4, 1e-6);  // the reference is printed with 7 digits
  int open = 0, slip = 0;
  for (const auto& p : s.points) {
    open += p.gap > 1e-6 * 0.005;  // openings reach 6.7e-4 m
    slip += p.gap <= 1e-6 * 0.005 && std::abs(p.tangential_force) > 0.6 * p.normal_force * (1 - 1e-6);
  }
  TEST_EQUALITY(open, 58);
  TEST_EQUALITY(slip, 6);
}

}  // namespace
