// Everything of a scene that stays the same through its load steps, on this rank.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "homogenisation/continuum.hpp"
#include "joints/contact_law.hpp"
#include "scene/scene.hpp"
#include "simulation/loads_at_work.hpp"

namespace voussoir {

template <int dim>
class Model {
 public:
  /// Builds blocks, joints and the continuum of a scene whose mesh has been checked. Collective.
  Model(const Scene&, const BlockSource<dim>&, const Teuchos::RCP<const Teuchos::Comm<int>>&);

  const Scene& scene() const { return scene_; }
  const BlockSource<dim>& source() const { return source_; }
  const Structure<dim>& structure() const { return *structure_; }
  const ContactPoints<dim>& points() const { return *points_; }
  const Continuum<dim>& continuum() const { return *continuum_; }
  /// 1 where a support prescribes the displacement [dim x local node copies].
  const std::vector<char>& held() const { return held_; }
  /// Stiffness a point sees in the cells beside it [N/m].
  const std::vector<double>& local_stiffness() const { return local_stiffness_; }
  /// Law of each point, unbroken.
  const std::vector<PointLaw>& law() const { return law_; }
  bool brittle() const { return brittle_; }

  /// Nodal forces [N] and prescribed displacements [m] under load factors by name of the load.
  /// @param time  [s] for loads with a time function; 0 as long as no dynamic stage has passed
  void loads(const std::map<std::string, double>& factors, double time, std::vector<double>& force,
             std::vector<double>& prescribed) const;
  const LoadsAtWork<dim>& loads() const { return *loads_; }

 private:
  void set_laws();
  int facet_set(const std::string& name) const;

  const Scene& scene_;
  const BlockSource<dim>& source_;
  std::unique_ptr<Structure<dim>> structure_;
  std::unique_ptr<ContactPoints<dim>> points_;
  std::unique_ptr<Continuum<dim>> continuum_;
  std::vector<char> held_;
  std::vector<double> local_stiffness_;
  std::vector<PointLaw> law_;
  bool brittle_ = false;
  std::unique_ptr<LoadsAtWork<dim>> loads_;
};

extern template class Model<2>;

}  // namespace voussoir
