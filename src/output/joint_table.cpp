#include "output/joint_table.hpp"

#include <cmath>

#include "base/text.hpp"

namespace voussoir {
namespace {

struct Column {
  const char* name;
  double JointRow::*value;
};

constexpr Column numbers[] = {{"x_m", &JointRow::x},
                              {"y_m", &JointRow::y},
                              {"length_m", &JointRow::length},
                              {"force_x_N", &JointRow::force_x},
                              {"force_y_N", &JointRow::force_y},
                              {"normal_force_N", &JointRow::normal_force},
                              {"shear_N", &JointRow::shear},
                              {"through_x_m", &JointRow::through_x},
                              {"through_y_m", &JointRow::through_y},
                              {"eccentricity_m", &JointRow::eccentricity},
                              {"edge_margin", &JointRow::edge_margin},
                              {"edge_x_m", &JointRow::edge_x},
                              {"edge_y_m", &JointRow::edge_y},
                              {"friction_margin", &JointRow::friction_margin},
                              {"friction_x_m", &JointRow::shear_x},
                              {"friction_y_m", &JointRow::shear_y},
                              {"opening_m", &JointRow::opening},
                              {"damage", &JointRow::damage}};

}  // namespace

std::string joint_table(const std::vector<JointRow>& rows) {
  std::string text = "block_i,block_j";
  for (const auto& column : numbers) text += std::string(",") + column.name;
  text += ",sides,hinge,slides\n";
  for (const auto& row : rows) {
    text += std::to_string(row.block_i) + ',' + std::to_string(row.block_j);
    for (const auto& column : numbers) {
      const double value = row.*column.value;
      text += ',' + (std::isfinite(value) ? number_text(value) : "");
    }
    text += ',' + std::to_string(row.sides) + ',' + std::to_string(row.hinge) + ',' + std::to_string(row.slides) + '\n';
  }
  return text;
}

}  // namespace voussoir
