// What stones owe to tied points beyond their law: the local criterion beside the error in the energy norm.
//
// An energy norm cannot see a local mechanism. A stone that hangs from a tied joint violates the law of that joint by
// its own weight, however small a part of the energy of the structure that is, and without the tie it falls. So every
// point is given no more than its law admits, and what a block then lacks is held against its own load:
//
//     z = K u - f - B^T P(lambda)        on node copies [N], P the projection on the law; 0 where supports hold
//     share of a block = max(|sum z|, |sum x cross z| / radius) / max(|sum f|, |sum x cross f| / radius)
//
// With z added to the loads the lawful forces P(lambda) are in balance on every block. So a bound on the shares of
// blocks is a statement about loads: what stands stands under loads that differ by no more than that share of each
// stone's own. The resultants of a group of blocks are the sums of theirs, since what two of them exchange cancels: the
// bound holds for every group too.
//
// Two questions follow. Does every stone, with all that depends on it alone (dependent_stones.hpp), find a balance
// between its neighbours? What hangs, slides or tips by itself is found so, however small its excess. And where the
// share of a stone is larger than a bound, do all stones together find one, as rigid bodies between springs
// (stone_relaxation.hpp)? Those that do not are loose.
#pragma once

#include <memory>
#include <vector>

#include "base/warning.hpp"
#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Which blocks owe more to ties than they may.
struct TieBalance {
  std::vector<char> loose;  ///< per local block, halo included: 1 where nothing but ties balances it
  bool any = false;         ///< some block of some rank is
  double largest = 0;       ///< [-] largest share of the loose blocks
  int where = -1;           ///< the block that has it, the lowest number of several
};

/// Tells which blocks owe more to ties than they may. Kept for a run: what depends on stones alone is made anew only
/// where their places, supports or presence have changed, and where they found balance is asked first the next time.
class TieCriterion {
 public:
  explicit TieCriterion(const Model&);
  ~TieCriterion();

  /// Collective.
  /// @param state    with forces of all points, tied ones too, ghosts up to date
  /// @param cluster  per local node copy; a point is tied when its nodes have the same cluster
  /// @param borne    K u - f of each block alone [N, dim x local node copies]: what joints and supports bear
  /// @param load     forces on the stones from outside, which shares refer to [N, dim x local node copies]
  /// @param largest_normal  force of all points of all ranks [N]
  TieBalance judge(const PointLaws& law, const ContactState& state, const std::vector<int>& cluster,
                   const std::vector<double>& borne, const std::vector<double>& load, double largest_normal);

 private:
  struct Kernel {
    virtual ~Kernel() = default;
    virtual TieBalance judge(const PointLaws&, const ContactState&, const std::vector<int>& cluster,
                             const std::vector<double>& borne, const std::vector<double>& load, double unknown) = 0;
  };
  template <int dim>
  class KernelIn;

  const Model& model_;
  std::unique_ptr<Kernel> kernel_;
};

/// What is said where ties may not be released (selection > largest rounds): one warning, or none.
/// @param share, block  largest share of a loose stone's load that ties bear, and that stone; -1 for none
Warnings held_by_ties(double share, int block, const std::string& when);

}  // namespace voussoir
