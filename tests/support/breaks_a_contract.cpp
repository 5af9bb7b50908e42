// Holds linear solves to their word: where a contract breaks on one rank alone, within a solve of all of them, the job
// ends and says which; the rank does not go on as if its solve had stopped, while the others wait for it.
#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

#include "base/check.hpp"
#include "linalg/linear_solver.hpp"
#include "linalg/local_view.hpp"

namespace {

using namespace voussoir;

/// Stands still on the last rank in its third application; others go on to the next norm.
class BreaksOnTheLastRank final : public Preconditioner {
 public:
  void apply(const TpetraVector& r, TpetraVector& z) const override {
    const auto comm = r.getMap()->getComm();
    const bool last_rank_breaks_here = ++applied_ == 3 && comm->getRank() + 1 == comm->getSize();
    VOUSSOIR_ASSERT(!last_rank_breaks_here);
    z.update(1.0, r, 0.0);
  }

 private:
  mutable int applied_ = 0;
};

/// Divides row by row, by different numbers, so that conjugate gradients take many iterations.
class Diagonal final : public TpetraOperator {
 public:
  explicit Diagonal(Teuchos::RCP<const TpetraMap> map) : map_(std::move(map)) {}
  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return map_; }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return map_; }
  void apply(const TpetraMultiVector& x, TpetraMultiVector& y, Teuchos::ETransp, double, double) const override {
    for (std::size_t i = 0; i < map_->getNodeNumElements(); ++i) {
      const auto row = static_cast<int>(i);
      y.getVectorNonConst(0)->replaceLocalValue(
          row, (1.0 + static_cast<double>(map_->getGlobalElement(row))) * x.getData(0)[row]);
    }
  }

 private:
  Teuchos::RCP<const TpetraMap> map_;
};

TEUCHOS_UNIT_TEST(LinearSolver, ABrokenContractOfOneRankEndsTheJob) {
  const auto map = Teuchos::rcp(new TpetraMap(100, 0, Tpetra::getDefaultComm()));
  const auto b = Teuchos::rcp(new TpetraVector(map)), x = Teuchos::rcp(new TpetraVector(map));
  b->putScalar(1.0);
  LinearSolver solver({});
  const auto a = Teuchos::rcp(new Diagonal(map));
  // As in the main program, nobody catches what ends it.
  const auto solve = [&]() noexcept {
    return solver.solve(a, std::make_shared<BreaksOnTheLastRank>(), b, x, 1e-10).converged;
  };
  TEST_ASSERT(!solve());
}

}  // namespace
