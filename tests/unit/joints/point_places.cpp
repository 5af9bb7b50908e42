// Points found again by their places, on any number of ranks.
#include "joints/point_places.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

namespace {

using namespace voussoir;

/// Points of one to three on a line of joints, on the borders of blocks k and k + 1.
std::vector<PointPlace> line(int joints) {
  std::vector<PointPlace> all;
  for (int j = 0; j < joints; ++j)
    for (int p = 0; p <= j % 3; ++p) all.push_back({j, j + 1, {1.0 * j, 0.1 * p, 0}, {1, 0, 0}});
  return all;
}

// As a state is restored: saved points are shared out evenly by their numbers, while each rank asks for other joints,
// those at its borders with its neighbours; what was not there when the state was saved has no number.
TEUCHOS_UNIT_TEST(PointPlaces, AreFoundOverRanksAsOnOne) {
  const auto comm = Tpetra::getDefaultComm();
  const int ranks = comm->getSize(), rank = comm->getRank();
  const auto saved = line(23);
  const auto total = static_cast<long long>(saved.size());
  const long long from = total * rank / ranks, to = total * (rank + 1) / ranks;
  auto asked = line(25);  // two joints are new
  std::vector<PointPlace> mine;
  std::vector<int> place;
  for (int k = static_cast<int>(asked.size()) - 1; k >= 0; --k) {
    const int joint = asked[k].block_i;
    if (joint % ranks != rank && (joint + 1) % ranks != rank) continue;
    mine.push_back(asked[k]);
    mine.back().place[2] = 4e-10;
    place.push_back(k);
  }
  const auto found = same_places_over_ranks(mine, {saved.begin() + from, saved.begin() + to}, from, 1e-9, *comm);
  TEST_EQUALITY(found.size(), mine.size());
  for (std::size_t k = 0; k < mine.size(); ++k) TEST_EQUALITY(found[k], place[k] < total ? place[k] : -1);
}

}  // namespace
