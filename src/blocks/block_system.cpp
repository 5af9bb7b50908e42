#include "blocks/block_system.hpp"

#include "linalg/reduce.hpp"

namespace voussoir {

int BlockSystem::local_block(BlockId id) const {
  const auto search = [&](int first, int last) {
    const int end = last;
    while (first < last) {
      const int middle = first + (last - first) / 2;
      if (nodes_of(middle).id < id)
        first = middle + 1;
      else
        last = middle;
    }
    return first < end && nodes_of(first).id == id ? first : -1;
  };
  const int owned = search(0, owned_blocks_);
  return owned >= 0 ? owned : search(owned_blocks_, local_blocks());
}

void BlockSystem::apply_stiffness(const std::vector<double>& u, std::vector<double>& y) const {
  y.resize(u.size());
  for (int b = 0; b < local_blocks(); ++b) {
    const auto& block = nodes_of(b);
    block.stiffness->multiply(&u[components_ * block.first_local], &y[components_ * block.first_local]);
  }
}

void BlockSystem::internal_forces(const std::vector<double>& u, std::vector<double>& y) const {
  if (rigid_motion_.empty())
    apply_stiffness(u, y);
  else
    apply_stiffness(deformation(u), y);
}

std::vector<double> BlockSystem::deformation(const std::vector<double>& u) const {
  auto d = u;
  for (std::size_t i = 0; i < rigid_motion_.size(); ++i) d[i] -= rigid_motion_[i];
  return d;
}

double BlockSystem::elastic_energy(const std::vector<double>& u) const {
  std::vector<double> ku;
  apply_stiffness(u, ku);
  double energy = 0;
  for (int i = 0; i < components_ * owned_nodes(); ++i) energy += u[i] * ku[i] / 2;
  return total_over_ranks(*comm_, energy);
}

}  // namespace voussoir
