#include "model/handed_over.hpp"

#include "base/check.hpp"
#include "base/finite.hpp"

namespace voussoir {

void expect_state(const Model& model, const ContactState& s) {
  VOUSSOIR_EXPECT(is_of_nodes(model, s.displacement) && "displacement: of the model's node copies");
  VOUSSOIR_EXPECT(all_finite(s.displacement) && "displacement: finite");
  VOUSSOIR_EXPECT(is_of_points(model, s.lambda) && "lambda: of the model's points");
  VOUSSOIR_EXPECT(all_finite(s.lambda) && "lambda: finite");
  VOUSSOIR_EXPECT((s.slip_origin.empty() || is_of_points(model, s.slip_origin)) && "slip_origin: of points, or none");
  VOUSSOIR_EXPECT(is_per_point(model, s.selected) && "selected: per point");
  VOUSSOIR_EXPECT(is_per_point(model, s.status) && "status: per point");
  VOUSSOIR_EXPECT((!model.weakens() || is_per_point(model, s.opened)) && "opened: per point where joints weaken");
  VOUSSOIR_EXPECT(s.slipped.size() == s.opened.size() && "slipped: as many as opened");
  VOUSSOIR_EXPECT((s.initial_gap.empty() || is_per_point(model, s.initial_gap)) && "initial_gap: per point, or none");
  VOUSSOIR_EXPECT((s.velocity.empty() || is_of_nodes(model, s.velocity)) && "velocity: of node copies, or none");
  VOUSSOIR_EXPECT(all_finite(s.velocity) && "velocity: finite");
  VOUSSOIR_EXPECT((s.acceleration.empty() || is_of_nodes(model, s.acceleration)) && "acceleration: as velocity");
  VOUSSOIR_EXPECT(s.largest_energy >= 0 && "largest energy: not negative");
}

void expect_input(const Model& model, const StepInput& input) {
  VOUSSOIR_EXPECT(is_of_nodes(model, input.load) && "load: of the model's node copies");
  VOUSSOIR_EXPECT(all_finite(input.load) && "load: finite");
  VOUSSOIR_EXPECT(is_of_nodes(model, input.prescribed) && "prescribed displacement: of the model's node copies");
  VOUSSOIR_EXPECT(all_finite(input.prescribed) && "prescribed displacement: finite");
  VOUSSOIR_EXPECT((!input.in_time || is_of_nodes(model, input.in_time->own_load)) && "own load: of node copies");
}

}  // namespace voussoir
