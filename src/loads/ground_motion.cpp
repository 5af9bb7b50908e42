#include "loads/ground_motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "blocks/assembly.hpp"
#include "loads/csv_table.hpp"
#include "loads/load.hpp"

namespace voussoir {
namespace {

constexpr double standard_gravity = 9.80665;  // [m/s2] what records call g
// A record whose ground still moves at the end at more than this share of its largest velocity has a drifting baseline.
constexpr double worth_saying = 0.02;

/// A record in m/s2 from its file.
PiecewiseLinear read_record(const GroundMotionParameters& p, const std::string& file, const std::string& where,
                            const Teuchos::Comm<int>& comm) {
  auto table = read_csv(file, 2, where, comm);
  check_rising(table.columns[0], file, where);
  for (double& a : table.columns[1]) a *= p.scale * (p.in_g ? standard_gravity : 1.0);
  const PiecewiseLinear record(std::move(table.columns[0]), std::move(table.columns[1]));
  return p.corrected ? with_corrected_baseline(record) : record;
}

std::string remark_on(const PiecewiseLinear& record, const std::string& key) {
  if (record.time().empty()) return "";
  double peak = 0;
  for (const double a : record.value()) peak = std::max(peak, std::abs(a));
  const auto drift = drift_of(record);
  std::string text = key + ": " + std::to_string(record.time().size()) + " rows from " +
                     number_text(record.time().front()) + " to " + number_text(record.time().back()) + " s, at most " +
                     number_text(peak) + " m/s2; the ground ends at " + number_text(drift.velocity) + " m/s, " +
                     number_text(drift.displacement) + " m away";
  if (std::abs(drift.velocity) > worth_saying * drift.peak_velocity)
    text += " (its baseline drifts: baseline = corrected brings the ground back to rest)";
  return text + ". ";
}

/// Mass of each node, shaken.
class GroundMotion final : public Load<2> {
 public:
  GroundMotion(const GroundMotionParameters& p, const LoadSite<2>& site) : steady_{p.ax, p.ay} {
    const auto& comm = *site.structure.comm();
    if (!p.record_x.empty()) record_[0] = read_record(p, p.record_x, site.where + " > x record", comm);
    if (!p.record_y.empty()) record_[1] = read_record(p, p.record_y, site.where + " > y record", comm);
    mass_.reserve(static_cast<std::size_t>(site.structure.nodes()));
    for (const auto& b : site.structure.blocks())
      for (const double volume : nodal_volumes(b.mesh, site.structure.model().thickness))
        mass_.push_back(b.material.density * volume);
  }

  void add(double factor, double time, std::vector<double>& force, std::vector<double>&) const override {
    for (int c = 0; c < 2; ++c) {
      const double a = factor * (steady_[c] + recorded(c, time));
      if (a == 0) continue;
      for (std::size_t i = 0; i < mass_.size(); ++i) force[2 * i + c] -= mass_[i] * a;
    }
  }

  std::size_t bytes() const override {
    return sizeof(*this) + mass_.capacity() * sizeof(double) + record_[0].bytes() + record_[1].bytes();
  }

  double resolution() const override { return std::min(record_[0].resolution(), record_[1].resolution()); }

  std::string remark() const override { return remark_on(record_[0], "x record") + remark_on(record_[1], "y record"); }

 private:
  /// [m/s2], 0 before and after the record
  double recorded(int c, double time) const {
    const auto& times = record_[c].time();
    return times.empty() || time < times.front() || time > times.back() ? 0.0 : record_[c](time);
  }

  Vector<2> steady_;
  PiecewiseLinear record_[2];
  std::vector<double> mass_;  ///< [kg] per local node
};

}  // namespace

void GroundMotionParameters::declare(ParameterSection& section) {
  section.add("x record", record_x, "CSV file with rows time [s], acceleration of the ground to the right");
  section.add("y record", record_y, "CSV file with rows time [s], acceleration of the ground upwards");
  section.add_choice<bool>("unit", in_g, {{"m/s2", false}, {"g", true}}, "of both records; g is 9.80665 m/s2");
  section.add("scale", scale, "-", any_number(), "times every value of the file");
  section.add_choice<bool>("baseline", corrected, {{"as recorded", false}, {"corrected", true}},
                           "corrected takes off the linear acceleration that leaves the ground at rest where it began");
  section.add("ax", ax, "m/s2", any_number(), "acceleration to the right; 0.15 g = 1.4715");
  section.add("ay", ay, "m/s2", any_number(), "acceleration upwards");
}

std::string GroundMotionParameters::summary() const {
  std::string words = "ground motion";
  if (!record_x.empty()) words += ", x record " + record_x;
  if (!record_y.empty()) words += ", y record " + record_y;
  if (words.find("record") != std::string::npos)
    words += std::string(" in ") + (in_g ? "g" : "m/s2") + " times " + number_text(scale);
  if (ax != 0 || ay != 0) words += ", (" + number_text(ax) + ", " + number_text(ay) + ") m/s2";
  return words;
}

bool GroundMotionParameters::is_zero() const {
  return ax == 0 && ay == 0 && (scale == 0 || (record_x.empty() && record_y.empty()));
}

Drift drift_of(const PiecewiseLinear& acceleration) {
  const auto& t = acceleration.time();
  const auto& a = acceleration.value();
  Drift drift;
  for (std::size_t k = 1; k < t.size(); ++k) {
    const double step = t[k] - t[k - 1];
    drift.displacement += step * drift.velocity + step * step * (2 * a[k - 1] + a[k]) / 6;
    drift.velocity += step * (a[k - 1] + a[k]) / 2;
    drift.peak_velocity = std::max(drift.peak_velocity, std::abs(drift.velocity));
  }
  return drift;
}

PiecewiseLinear with_corrected_baseline(const PiecewiseLinear& acceleration) {
  const auto drift = drift_of(acceleration);
  const auto& t = acceleration.time();
  const double length = t.back() - t.front();
  if (length <= 0) return acceleration;
  // c0 + c1 (t - t0) with the same velocity and displacement at the end.
  const double c1 = 12 * (drift.velocity * length / 2 - drift.displacement) / (length * length * length);
  const double c0 = drift.velocity / length - c1 * length / 2;
  auto value = acceleration.value();
  for (std::size_t k = 0; k < t.size(); ++k) value[k] -= c0 + c1 * (t[k] - t.front());
  return {t, std::move(value)};
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const GroundMotionParameters& p, const LoadSite<2>& site) {
  return std::make_unique<GroundMotion>(p, site);
}

}  // namespace voussoir
