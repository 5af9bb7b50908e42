// Rigid motions of blocks with three numbers each in the plane, or six in space: what block_motions.cpp makes.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "homogenisation/block_motions.hpp"
#include "linalg/shared_system.hpp"

namespace voussoir {

struct BlockMotions::Kernel {
  virtual ~Kernel() = default;
  virtual void factor_on_first_rank() = 0;
  virtual SolvedBy update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) = 0;
  virtual void add(const TpetraVector& r, TpetraVector& z) const = 0;
  virtual long long size() const = 0;
  virtual std::vector<MultigridLevel> levels() const = 0;
  virtual long long bytes() const = 0;
};

template <int dim>
class BlockMotions::Motions final : public BlockMotions::Kernel {
 public:
  Motions(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
          const std::vector<char>& active, const SharedSystemParameters&);
  void factor_on_first_rank() override { system_->factor_on_first_rank(); }
  SolvedBy update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) override;
  void add(const TpetraVector& r, TpetraVector& z) const override;
  long long size() const override { return system_->size(); }
  std::vector<MultigridLevel> levels() const override { return system_->levels(); }
  long long bytes() const override;

 private:
  static constexpr int modes = dim + dim * (dim - 1) / 2;  ///< of a block: translations and turns
  using Modes = std::array<double, modes>;
  /// A node copy that moves with its block.
  struct Copy {
    int block;        ///< among those that are active and that this rank knows, its own first
    Vector<dim> arm;  ///< [-] from the first node of the block, by the length of its first diagonal
  };
  /// What the motions of one block contribute to some combination of unknowns.
  struct Term {
    int block;
    Modes value;
  };
  using Row = std::vector<Term>;  ///< ascending by block

  static Modes motion(const Vector<dim>& arm, const Vector<dim>& direction);
  static Vector<dim> displacement(const Vector<dim>& arm, const Modes&);
  std::vector<int> copies_met(const std::vector<char>& selected) const;
  void number_blocks(const std::vector<char>& active, const SharedSystemParameters&);
  SharedSystem::Bodies rigid_motions(const std::vector<char>& active) const;
  void find_copies(const std::vector<int>& met);
  void set_pattern(const std::vector<char>& selected);
  void add_elastic_energy();
  void add_motion(int cluster, Vector<dim> direction, double factor, Row&) const;
  std::size_t place(int block, int other) const;
  void add_to(int block, int other, const Modes& left, const double* right);
  void add_product(const Row&, double factor);

  const BlockSystem& structure_;
  const ContactPoints& points_;
  const MergedSpace& space_;
  int blocks_ = 0;               ///< that are active and that this rank knows
  std::vector<int> number_;      ///< of each local block among them, -1 where it is not active
  std::vector<int> copy_start_;  ///< per cluster, those of other ranks too where an owned block touches them
  std::vector<Copy> copies_;
  std::vector<int> couplings_;   ///< owned selected points that couple clusters
  LocalCsr matrix_;              ///< upper half of this rank's part of Z^T H Z; values while it is factored
  std::vector<double> elastic_;  ///< its part of Z^T K Z, in the pattern of the matrix
  std::unique_ptr<SharedSystem> system_;
};

}  // namespace voussoir
