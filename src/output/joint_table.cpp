#include "output/joint_table.hpp"

#include <cmath>
#include <functional>

#include "base/check.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

struct Column {
  std::string name;
  std::function<double(const JointRow&)> value;
};

std::vector<Column> columns_of(int components) {
  std::vector<Column> all;
  const auto add = [&](const std::string& name, double JointRow::*value) {
    all.push_back({name, [value](const JointRow& row) { return row.*value; }});
  };
  const auto add_each = [&](const std::string& before, const std::string& after,
                            std::array<double, 3> JointRow::*value) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
      all.push_back({before + "xyz"[c] + after, [value, c](const JointRow& row) { return (row.*value)[c]; }});
  };
  const bool in_space = components == 3;
  add_each("", "_m", &JointRow::middle);
  add(in_space ? "area_m2" : "length_m", &JointRow::extent);
  add_each("force_", "_N", &JointRow::force);
  add("normal_force_N", &JointRow::normal_force);
  add("shear_N", &JointRow::shear);
  if (in_space) add("twist_Nm", &JointRow::twist);
  add_each("through_", "_m", &JointRow::through);
  add("eccentricity_m", &JointRow::eccentricity);
  add("edge_margin", &JointRow::edge_margin);
  add_each("edge_", "_m", &JointRow::edge);
  add("friction_margin", &JointRow::friction_margin);
  add_each("friction_", "_m", &JointRow::least_shear);
  add("opening_m", &JointRow::opening);
  add("damage", &JointRow::damage);
  return all;
}

}  // namespace

std::string joint_table(const std::vector<JointRow>& rows, int components) {
  VOUSSOIR_EXPECT(components == 2 || components == 3);
  const auto columns = columns_of(components);
  std::string text = "block_i,block_j";
  for (const auto& column : columns) text += ',' + column.name;
  text += ",sides,hinge,slides\n";
  for (const auto& row : rows) {
    text += std::to_string(row.block_i) + ',' + std::to_string(row.block_j);
    for (const auto& column : columns) {
      const double value = column.value(row);
      text += ',' + (std::isfinite(value) ? number_text(value) : "");
    }
    text += ',' + std::to_string(row.sides) + ',' + std::to_string(row.hinge) + ',' + std::to_string(row.slides) + '\n';
  }
  return text;
}

}  // namespace voussoir
