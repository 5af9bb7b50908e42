// What the parameters of masonry make: how many cells of what length, in words.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/words.hpp"
#include "mesh/masonry_parameters.hpp"

namespace voussoir {
namespace {

const double radian_per_degree = std::acos(-1.0) / 180;

/// Cells for edges longer by a factor, a multiple of `step`.
int coarser(int cells, double factor, int step = 1) {
  return step * std::max(1, static_cast<int>(std::lround(cells / (step * factor))));
}

int halves(WallBond bond) { return bond == WallBond::running ? 2 : 1; }

std::string times(double a, double b, double c) {
  return number_text(a) + " x " + number_text(b) + " x " + number_text(c);
}

std::string hexahedra(int a, int b, int c) { return times(a, b, c) + " hexahedra"; }

std::string bond_words(WallBond bond) { return bond == WallBond::running ? "running bond" : "stack bond"; }

std::string on_a_ground(double height) { return height > 0 ? ", on a ground" : ""; }

double product(std::initializer_list<double> factors) {
  double all = 1;
  for (const double factor : factors) all *= factor;
  return all;
}

}  // namespace

std::string words_of(CellType cells) {
  return cells == CellType::triangle        ? "triangles"
         : cells == CellType::quadrilateral ? "quadrilaterals"
                                            : "quadratic triangles";
}

double WallParameters::cell_count() const {
  return product({double(courses), double(blocks_per_course), double(cells_along), double(cells_up)});
}

double WallParameters::longest_edge() const { return std::max(block_length / cells_along, block_height / cells_up); }

void WallParameters::coarsen(double factor) {
  cells_along = coarser(cells_along, factor, 2);
  cells_up = coarser(cells_up, factor);
}

std::string WallParameters::words() const {
  return "wall in running bond, " + counted(courses, "course") + " of " + counted(blocks_per_course, "block") + ' ' +
         number_text(block_length) + " x " + number_text(block_height) + " m, " + std::to_string(cells_along) + " x " +
         std::to_string(cells_up) + ' ' + words_of(cells) +
         (openings.empty() ? "" : ", " + counted(static_cast<int>(openings.size()), "opening"));
}

double ArchParameters::cell_count() const {
  return product({double(cells_radial), double(cells_along)}) *
         (voussoirs + (pier_height > 0 ? 2.0 * pier_courses : 0.0));
}

double ArchParameters::longest_edge() const {
  const double outer = (radius + thickness / 2) * embrace * radian_per_degree;
  return std::max(thickness / cells_radial, outer / voussoirs / cells_along);
}

void ArchParameters::coarsen(double factor) {
  cells_radial = coarser(cells_radial, factor);
  cells_along = coarser(cells_along, factor);
}

std::string ArchParameters::words() const {
  return "arch of radius " + number_text(radius) + " m, thickness " + number_text(thickness) + " m, " +
         number_text(embrace) + " degrees, " + counted(voussoirs, "voussoir") + ", " + std::to_string(cells_radial) +
         " x " + std::to_string(cells_along) + ' ' + words_of(cells) +
         (pier_height > 0 ? ", piers of " + number_text(pier_height) + " m" : "");
}

double WallInSpaceParameters::cell_count() const {
  // A return is as many blocks long as it says, without the half that the wall has at the corner.
  double blocks = blocks_per_course;
  for (const int stones : {return_left, return_right}) blocks += std::max(stones - 0.5, 0.0);
  double left_out = 0;
  for (const auto& named : openings) {
    const OpeningInSpace& o = named.second;
    left_out += (o.x_to - o.x_from) * (o.z_to - o.z_from) / (block_length * block_height);
  }
  const double layers = double(courses) * cells_up + (ground_height > 0 ? 1 : 0);
  return std::max(blocks * layers - left_out * cells_up, 0.0) * product({double(cells_along), double(cells_across)});
}

double WallInSpaceParameters::longest_edge() const {
  return std::max({block_length / cells_along, block_height / cells_up, thickness / cells_across});
}

void WallInSpaceParameters::coarsen(double factor) {
  cells_along = coarser(cells_along, factor, openings.empty() ? halves(bond) : 2);
  cells_up = coarser(cells_up, factor);
  cells_across = coarser(cells_across, factor);
}

std::string WallInSpaceParameters::words() const {
  std::string text = "wall in space, " + bond_words(bond) + ", " + counted(courses, "course") + " of " +
                     counted(blocks_per_course, "block") + ' ' + times(block_length, thickness, block_height) + " m, " +
                     hexahedra(cells_along, cells_across, cells_up);
  if (return_left > 0) text += ", left return of " + counted(return_left, "block");
  if (return_right > 0) text += ", right return of " + counted(return_right, "block");
  if (!openings.empty()) text += ", " + counted(static_cast<int>(openings.size()), "opening");
  return text + on_a_ground(ground_height);
}

double PrismParameters::cell_count() const {
  return product({double(cells_along), double(cells_across), double(cells_up)}) *
         (stones + (ground_height > 0 ? 1.0 / cells_up : 0.0));
}

double PrismParameters::longest_edge() const {
  return std::max({length / cells_along, width / cells_across, height / stones / cells_up});
}

void PrismParameters::coarsen(double factor) {
  cells_along = coarser(cells_along, factor);
  cells_across = coarser(cells_across, factor);
  cells_up = coarser(cells_up, factor);
}

std::string PrismParameters::words() const {
  return "prism " + times(length, width, height) + " m, " + counted(stones, "stone") + ", " +
         hexahedra(cells_along, cells_across, cells_up) + on_a_ground(ground_height);
}

double DomeParameters::cell_count() const {
  return product({double(lunes), double(cells_radial), double(cells_round)}) *
         (double(courses) * cells_up + (ground_height > 0 ? 1 : 0));
}

double DomeParameters::longest_edge() const {
  const double outer = radius + thickness / 2;
  const double widest = springing < 90 ? springing : std::max(oculus, 90.0);  // [degree] from the crown
  // Below a springing that leans the ground is wider still.
  const double flare = std::max(ground_height * std::cos(springing * radian_per_degree), 0.0);
  return std::max(
      {thickness / cells_radial,
       (outer * std::sin(widest * radian_per_degree) + flare) * 360 * radian_per_degree / lunes / cells_round,
       outer * (springing - oculus) * radian_per_degree / courses / cells_up});
}

void DomeParameters::coarsen(double factor) {
  cells_radial = coarser(cells_radial, factor);
  cells_round = coarser(cells_round, factor, halves(bond));
  cells_up = coarser(cells_up, factor);
}

std::string DomeParameters::words() const {
  return "dome of radius " + number_text(radius) + " m, thickness " + number_text(thickness) + " m, " +
         number_text(oculus) + " to " + number_text(springing) + " degrees, " + bond_words(bond) + ", " +
         counted(courses, "course") + " of " + counted(lunes, "stone") + ", " +
         hexahedra(cells_radial, cells_round, cells_up) + on_a_ground(ground_height);
}

double BarrelVaultParameters::cell_count() const {
  return product({double(stones_along), double(cells_radial), double(cells_along)}) *
         (double(voussoirs) * cells_round + (ground_height > 0 ? 2 : 0));
}

double BarrelVaultParameters::longest_edge() const {
  return std::max({thickness / cells_radial, length / stones_along / cells_along,
                   (radius + thickness / 2) * embrace * radian_per_degree / voussoirs / cells_round});
}

void BarrelVaultParameters::coarsen(double factor) {
  cells_radial = coarser(cells_radial, factor);
  cells_round = coarser(cells_round, factor);
  cells_along = coarser(cells_along, factor, halves(bond));
}

std::string BarrelVaultParameters::words() const {
  return "barrel vault of radius " + number_text(radius) + " m, thickness " + number_text(thickness) + " m, " +
         number_text(embrace) + " degrees, length " + number_text(length) + " m, " + bond_words(bond) + ", " +
         counted(voussoirs, "course") + " of " + counted(stones_along, "stone") + ", " +
         hexahedra(cells_radial, cells_round, cells_along) + on_a_ground(ground_height);
}

}  // namespace voussoir
