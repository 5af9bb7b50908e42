#include "loads/ground_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/parameter_section.hpp"
#include "base/plane_and_space.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "blocks/assembly.hpp"
#include "loads/acceleration_unit.hpp"
#include "loads/load.hpp"
#include "loads/time_series.hpp"

namespace voussoir {
namespace {

// A ground that ends faster than this share of its largest velocity, or further away than this share of its largest
// displacement, has not come back to rest; less is hardly seen beside its motion. Displacements have the larger share,
// for they add up what velocities leave, and a fault may leave some.
constexpr double still_moving = 0.02, still_away = 0.1;
// So many rows, each a second after the other from 0 or 1 on, are more likely row numbers than times.
constexpr std::size_t rows_that_count = 20;

bool count_rows(const std::vector<double>& time) {
  if (time.size() < rows_that_count || time.front() < 0 || time.front() > 1) return false;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] != time.front() + static_cast<double>(k) || time[k] != std::floor(time[k])) return false;
  return true;
}

/// A record in m/s2, and what is to be said of it.
struct MotionRecord {
  PiecewiseLinear acceleration;
  std::string remark;
  Warnings warnings;

  MotionRecord() = default;
  MotionRecord(const GroundMotionParameters& p, const std::string& file, const ValueColumn& column,
               const std::string& where, const Teuchos::Comm<int>& comm)
      : key_(column.key.substr(0, 1) + " record"), where_(where) {
    auto series = read_time_series(file, p.layout, column, where, comm);
    check_heading(p, file, series.heading);
    if (count_rows(series.time))
      warn("row_numbers", static_cast<double>(series.time.size()),
           "its times are " + number_text(series.time.front()) + ", " + number_text(series.time.front() + 1) +
               ", ... to " + number_text(series.time.back()) +
               " s, a second from row to row: if they number the rows, name the time column, or give layout = values");
    for (double& a : series.value) a *= p.scale * in_si(p.unit);
    acceleration = {std::move(series.time), std::move(series.value)};
    const auto drift = drift_of(acceleration);
    if (p.corrected) acceleration = with_corrected_baseline(acceleration);
    describe(p.corrected, drift);
  }

 private:
  void warn(const std::string& kind, double how_much, const std::string& text) {
    warnings.push_back({kind, where_, "", how_much, text});
  }

  void check_heading(const GroundMotionParameters& p, const std::string& file,
                     const std::vector<std::string>& heading) {
    const bool at2 = p.layout.layout == RecordLayout::peer_at2;
    if (names_other_motion(heading))
      throw InputError(where_ + " = " + in_quotes(file) +
                       "\n  must hold accelerations, but its heading names another "
                       "motion.\n  Give the record of the acceleration of the same event.");
    const auto unit = unit_named_in(heading);
    if (!unit || in_si(*unit) == in_si(p.unit)) return;
    const std::string both = "its heading says " + word_of(*unit) + ", where unit = " + word_of(p.unit);
    if (at2)
      throw InputError(where_ + " = " + in_quotes(file) + "\n  must be in the unit that the scene gives, but " + both +
                       ".\n  Give unit = " + word_of(*unit) + ".");
    // A scale, or the factor of a stage, may be there to convert.
    if (p.scale == 1)
      warn("record_unit", in_si(p.unit) / in_si(*unit),
           both + ": accelerations are taken " + number_text(in_si(p.unit) / in_si(*unit)) +
               " times as large; give unit = " + word_of(*unit) + ", or mend the heading");
  }

  void describe(bool corrected, const Drift& drift) {
    const auto& time = acceleration.time();
    double peak = 0;
    for (const double a : acceleration.value()) peak = std::max(peak, std::abs(a));
    const std::string end =
        "at " + three_digits(drift.velocity) + " m/s, " + three_digits(drift.displacement) + " m away";
    remark = key_ + ": " + counted(time.size(), "row") + " from " + number_text(time.front()) + " to " +
             number_text(time.back()) + " s, at most " + number_text(peak) + " m/s2; the ground " +
             (corrected ? "would end " : "ends ") + end + (corrected ? ", and is brought back to rest. " : ". ");
    const bool moves = std::abs(drift.velocity) > still_moving * drift.peak_velocity;
    const bool away = std::abs(drift.displacement) > still_away * drift.peak_displacement;
    if (corrected || (!moves && !away)) return;
    warn("record_ends_moving", drift.share(),
         "the ground ends " + end + ", where its largest velocity is " + three_digits(drift.peak_velocity) +
             " m/s and its largest displacement " + three_digits(drift.peak_displacement) +
             " m; unless it did so, baseline = corrected brings it back to rest where it began");
  }

  std::string key_, where_;
};

/// Mass of each node, shaken.
template <int dim>
class GroundMotion final : public Load<dim> {
 public:
  GroundMotion(const GroundMotionParameters& p, const LoadSite<dim>& site)
      : steady_(in_dimension<dim>({p.ax, p.ay, p.az})) {
    const std::array<ValueColumn, 3> column{
        {{"x column", p.column_x}, {"y column", p.column_y}, {"z column", p.column_z}}};
    const std::array<std::string, 3> file{p.record_x, p.record_y, p.record_z};
    for (int c = 0; c < dim; ++c) {
      const std::string key = column[c].key.substr(0, 1) + " record";
      if (!file[c].empty()) record_[c] = {p, file[c], column[c], site.where + " > " + key, *site.structure.comm()};
    }
    mass_.reserve(static_cast<std::size_t>(site.structure.nodes()));
    for (const auto& b : site.structure.blocks())
      for (const double volume : nodal_volumes(b.mesh, b.material, site.structure.model()))
        mass_.push_back(b.material.density * volume);
  }

  void add(const std::vector<LoadMoment>& moments, BlockForces& force, std::vector<double>&) const override {
    for (int c = 0; c < dim; ++c) {
      double a = 0;
      for (const auto& [time, factor] : moments) a += factor * (steady_[c] + recorded(c, time));
      if (a == 0) continue;
      for (std::size_t i = 0; i < mass_.size(); ++i) force.of_nodes[dim * i + c] -= mass_[i] * a;
    }
  }

  bool of_stones() const override { return true; }
  std::size_t bytes() const override {
    std::size_t bytes = sizeof(*this) + mass_.capacity() * sizeof(double);
    for (const auto& record : record_) bytes += record.acceleration.bytes();
    return bytes;
  }

  bool moves() const override {
    return std::any_of(record_.begin(), record_.end(), [](const auto& r) { return !r.acceleration.time().empty(); });
  }

  void add_corners(double from, double to, std::vector<double>& times) const override {
    for (const auto& record : record_) record.acceleration.add_corners(from, to, times);
  }

  double resolution() const override {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& record : record_) shortest = std::min(shortest, record.acceleration.resolution());
    return shortest;
  }

  double resolution(double from, double to) const override {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& record : record_) shortest = std::min(shortest, record.acceleration.resolution(from, to));
    return shortest;
  }

  std::string remark() const override {
    std::string all;
    for (const auto& record : record_) all += record.remark;
    return all;
  }

  Warnings warnings() const override {
    Warnings all;
    for (const auto& record : record_) all.insert(all.end(), record.warnings.begin(), record.warnings.end());
    return all;
  }

 private:
  /// [m/s2], 0 before and after the record
  double recorded(int c, double time) const {
    const auto& record = record_[c].acceleration;
    const auto& times = record.time();
    return times.empty() || time < times.front() || time > times.back() ? 0.0 : record(time);
  }

  Vector<dim> steady_;
  std::array<MotionRecord, dim> record_;
  std::vector<double> mass_;  ///< [kg] per local node
};

}  // namespace

void GroundMotionParameters::declare(ParameterSection& section) {
  section.add("x record", record_x, "file with accelerations of the ground to the right over time");
  section.add("y record", record_y, "file with accelerations of the ground upwards over time; in space along y");
  section.add("z record", record_z, "file with accelerations of the ground upwards over time, in space");
  layout.declare(section);
  for (const auto& [key, column] :
       {std::pair{"x column", &column_x}, std::pair{"y column", &column_y}, std::pair{"z column", &column_z}})
    section.add(key, *column, "-", between(0, 1000), "of its record, where rows hold more than two numbers, from 1");
  layout.check(section, {{"x column", column_x, !record_x.empty()},
                         {"y column", column_y, !record_y.empty()},
                         {"z column", column_z, !record_z.empty()}});
  section.add_choice<AccelerationUnit>("unit", unit, acceleration_units(),
                                       "of all records; g is 9.80665 m/s2, gal is cm/s2");
  section.add("scale", scale, "-", any_number(), "times every value of the file");
  section.add_choice<bool>("baseline", corrected, {{"as recorded", false}, {"corrected", true}},
                           "corrected takes off the linear acceleration that leaves the ground at rest where it began");
  section.add("ax", ax, "m/s2", any_number().usually(1e-4, 1000), "acceleration to the right; 0.15 g = 1.4715");
  section.add("ay", ay, "m/s2", any_number().usually(1e-4, 1000), "acceleration upwards; in space along y");
  section.add("az", az, "m/s2", any_number().usually(1e-4, 1000), "acceleration upwards in space");
}

std::string GroundMotionParameters::summary() const {
  std::string words = "ground motion";
  if (!record_x.empty()) words += ", x record " + record_x;
  if (!record_y.empty()) words += ", y record " + record_y;
  if (!record_z.empty()) words += ", z record " + record_z;
  if (words.find("record") != std::string::npos)
    words += std::string(" in ") + word_of(unit) + " times " + number_text(scale);
  if (az != 0)
    words += ", " + vector_text(Vector<3>{ax, ay, az}) + " m/s2";
  else if (ax != 0 || ay != 0)
    words += ", " + vector_text(Vector<2>{ax, ay}) + " m/s2";
  return words;
}

bool GroundMotionParameters::is_zero() const {
  return ax == 0 && ay == 0 && az == 0 && (scale == 0 || (record_x.empty() && record_y.empty() && record_z.empty()));
}

std::vector<KeyOfSpace> GroundMotionParameters::keys_of_space() const {
  std::vector<KeyOfSpace> keys;
  if (!record_z.empty()) keys.push_back({"z record", " = " + in_quotes(record_z)});
  add_if_given(keys, "az", az, "m/s2");
  return keys;
}

double Drift::share() const {
  const auto over = [](double end, double peak) { return peak > 0 ? std::abs(end) / peak : 0.0; };
  return std::max(over(velocity, peak_velocity), over(displacement, peak_displacement));
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
    drift.peak_displacement = std::max(drift.peak_displacement, std::abs(drift.displacement));
  }
  return drift;
}

PiecewiseLinear with_corrected_baseline(const PiecewiseLinear& acceleration) {
  const auto& t = acceleration.time();
  auto value = acceleration.value();
  const auto moves = [](double a) { return a != 0; };
  const auto first = std::find_if(value.begin(), value.end(), moves);
  if (first == value.end() || value.size() < 2) return acceleration;
  const auto last = std::find_if(value.rbegin(), value.rend(), moves).base();
  const auto from = static_cast<std::size_t>(first - value.begin()) - (first == value.begin() ? 0 : 1);
  const auto to = static_cast<std::size_t>(last - value.begin()) - (last == value.end() ? 1 : 0);
  // Drifts add up: those of a constant and of a line between the two zeros must make up that of the record.
  std::vector<double> constant(t.size(), 0.0), line = constant;
  for (std::size_t k = from; k <= to; ++k) {
    constant[k] = 1;
    line[k] = (t[k] - t[from]) / (t[to] - t[from]);
  }
  const auto whole = drift_of(acceleration), d0 = drift_of({t, constant}), d1 = drift_of({t, line});
  const double determinant = d0.velocity * d1.displacement - d1.velocity * d0.displacement;
  const double c0 = (whole.velocity * d1.displacement - d1.velocity * whole.displacement) / determinant;
  const double c1 = (d0.velocity * whole.displacement - whole.velocity * d0.displacement) / determinant;
  for (std::size_t k = from; k <= to; ++k) value[k] -= c0 * constant[k] + c1 * line[k];
  return {t, std::move(value)};
}

template <>
std::unique_ptr<Load<2>> make_load_of<2>(const GroundMotionParameters& p, const LoadSite<2>& site) {
  return std::make_unique<GroundMotion<2>>(p, site);
}

template <>
std::unique_ptr<Load<3>> make_load_of<3>(const GroundMotionParameters& p, const LoadSite<3>& site) {
  return std::make_unique<GroundMotion<3>>(p, site);
}

}  // namespace voussoir
