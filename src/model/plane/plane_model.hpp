// A model of the plane: where its blocks come from, and what supports, mass and waves are by their geometry.
#pragma once

#include "model/model.hpp"

namespace voussoir {

class PlaneModel : public Model {
 public:
  /// Builds blocks, joints and the continuum of a scene whose mesh has been checked. Collective.
  PlaneModel(const Scene&, const BlockSource<2>&, const Teuchos::RCP<const Teuchos::Comm<int>>&);

  const BlockSource<2>& source() const { return source_; }
  const Structure<2>& structure() const override { return *structure_; }
  AnyGeometry geometry() const override { return Geometry<2>{source_, *structure_}; }
  const BlockGraph& graph() const override { return source_.graph(); }
  double follow(const std::vector<double>& displacement) override;
  std::unique_ptr<const BlockSystem> mass() const override;
  std::unique_ptr<Model> of_time_step(const BlockSystem& mass, const MidpointRule&, double tolerance) const override;
  double wave_speed(int block) const override;
  double passage(int block) const override;
  std::vector<double> initial_velocities() const override;

 private:
  PlaneModel(const PlaneModel& at_rest, const BlockSystem& mass, const MidpointRule&, double tolerance);
  void set_families(const Scene&);
  void hold_supports() override;
  std::vector<char> between_supports() const;
  double stiffness_beside(int node) const override;
  Vector<2> centre_of_rotation(const InitialVelocityParameters&) const;

  const BlockSource<2>& source_;
  std::unique_ptr<Structure<2>> structure_;
};

/// Of a model that is one of the plane.
inline Geometry<2> plane_geometry(const Model& model) { return std::get<Geometry<2>>(model.geometry()); }

}  // namespace voussoir
