#include "model/carried_points.hpp"

#include "base/check.hpp"

namespace voussoir {

void begin_points(const std::vector<char>& begins, const ContactPoints& points, ContactState& state) {
  const int n = points.components();
  for (int k = 0; k < points.size(); ++k) {
    if (!begins[k]) continue;
    state.selected[k] = 1;
    state.status[k] = static_cast<char>(PointStatus::open);
    if (state.slip_origin.empty()) continue;
    const auto motion = points.at(k).motion(state.displacement);
    for (int c = 1; c < n; ++c) state.slip_origin[n * k + c] = motion[c];
  }
}

void carry_points(const ContactPoints& from, const ContactPoints& to, const std::vector<int>& before,
                  ContactState& state) {
  VOUSSOIR_EXPECT(from.components() == to.components() && before.size() == static_cast<std::size_t>(to.size()));
  each_list_of_points(state, to.components(), [&](const char*, auto& list, int values, double) {
    if (list.empty()) return;
    VOUSSOIR_EXPECT(list.size() == static_cast<std::size_t>(values) * from.size());
    const auto old = list;
    list.assign(static_cast<std::size_t>(values) * before.size(), {});
    for (std::size_t k = 0; k < before.size(); ++k)
      for (int c = 0; c < values && before[k] >= 0; ++c) list[values * k + c] = old[values * before[k] + c];
  });
  std::vector<char> begins;
  for (const int k : before) begins.push_back(k < 0);
  begin_points(begins, to, state);
  const int n = to.components();
  for (int k = 0; k < to.size(); ++k) {
    if (begins[k] || state.slip_origin.empty()) continue;
    const auto more = to.at(k).motion(state.displacement) - from.at(before[k]).motion(state.displacement);
    for (int c = 1; c < n; ++c) state.slip_origin[n * k + c] += more[c];
  }
}

}  // namespace voussoir
