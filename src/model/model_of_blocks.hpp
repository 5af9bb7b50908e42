// What a model is by the geometry of its blocks: where they come from, and what supports, mass, waves and velocities as
// time begins are. What the plane and space do each in their way is in model/plane and model/space.
#pragma once

#include "model/model.hpp"

namespace voussoir {

template <int dim>
class ModelOfBlocks : public Model {
 public:
  /// Builds blocks, joints and the continuum of a scene whose mesh has been checked. Collective.
  ModelOfBlocks(const Scene&, const BlockSource<dim>&, const Teuchos::RCP<const Teuchos::Comm<int>>&);

  const BlockSource<dim>& source() const { return source_; }
  const Structure<dim>& structure() const override { return *structure_; }
  AnyGeometry geometry() const override { return Geometry<dim>{source_, *structure_}; }
  std::vector<Neighbour> neighbours(BlockId b) const override { return source_.neighbours(b); }
  double move_geometry(const std::vector<double>& displacement) override;
  std::unique_ptr<const BlockSystem> mass() const override;
  std::unique_ptr<Model> of_time_step(const BlockSystem& mass, const MidpointRule&, double tolerance) const override;
  double wave_speed(int block) const override;
  double passage(int block) const override;
  std::vector<double> initial_velocities() const override;

 private:
  ModelOfBlocks(const ModelOfBlocks& at_rest, const BlockSystem& mass, const MidpointRule&, double tolerance);
  void set_families(const Scene&);
  void hold_supports() override;
  std::vector<char> between_supports() const;
  double stiffness_beside(int node) const override;
  Vector<dim> centre_of_rotation(const InitialVelocityParameters&) const;

  const BlockSource<dim>& source_;
  std::unique_ptr<Structure<dim>> structure_;
  std::shared_ptr<const std::vector<double>> cell_size_;  ///< [m] in space, of local nodes
};

template <>
double ModelOfBlocks<2>::wave_speed(int) const;
template <>
double ModelOfBlocks<3>::wave_speed(int) const;
template <>
double ModelOfBlocks<2>::stiffness_beside(int) const;
template <>
double ModelOfBlocks<3>::stiffness_beside(int) const;
extern template class ModelOfBlocks<2>;
extern template class ModelOfBlocks<3>;

}  // namespace voussoir
