// Masonry that needs no file: walls and arches of the plane; in space walls with returns and openings, prisms, domes,
// barrel vaults.
#pragma once

#include <map>
#include <string>

namespace voussoir {

class ParameterSection;

/// How a block is divided; P1 triangles or Q1 quadrilaterals.
enum class CellType { triangle, quadrilateral, quadratic_triangle };

std::string words_of(CellType);
void declare_cell_type(ParameterSection&, CellType&);

/// Head joints of odd courses above the middles of the stones below, or above theirs.
enum class WallBond { running, stack };

/// Corners of cells on the round surface, or stones cut with plane faces between their own corners.
enum class StoneFaces { round, plane };

enum class ReturnsTo { back, front };

/// What is asked of any of them.
struct MasonryParameters {
  virtual ~MasonryParameters() = default;
  /// Cells of all stones, of triangles those of the quadrilaterals they halve. In space an opening counts as a share of
  /// its wall.
  virtual double cell_count() const = 0;
  /// [m] of the longest edge of a cell, within the difference of chord and arc.
  virtual double longest_edge() const = 0;
  /// Takes edges longer by a factor, as near as whole numbers of cells allow.
  virtual void coarsen(double factor) = 0;
  /// One line for the head of a run.
  virtual std::string words() const = 0;
};

/// A rectangular opening in a wall [m]; blocks that lie inside are left out.
struct Opening {
  double x_from = 0, x_to = 0, y_from = 0, y_to = 0;
  void declare(ParameterSection&);
};

/// A wall of the plane in running bond: even courses (0, 2, ...) of full blocks, odd ones begin and end with half ones.
/// Block sets: "course 0", ...; facet sets: "base", "top", "left", "right".
struct WallParameters final : MasonryParameters {
  int courses = 8;
  int blocks_per_course = 8;
  double block_length = 0.5;   ///< [m]
  double block_height = 0.25;  ///< [m]
  int cells_along = 4;         ///< cells along a full block, even (a half block has half of them)
  int cells_up = 2;
  CellType cells = CellType::quadrilateral;
  std::map<std::string, Opening> openings;
  double cell_count() const override;
  double longest_edge() const override;
  void coarsen(double factor) override;
  std::string words() const override;
  void declare(ParameterSection&);
};

/// Circular arch of equal voussoirs numbered from the right springing, on optional piers.
/// Block sets: "ring", "pier left", "pier right"; facet sets: "springing left", "springing right"
/// (the lowest faces: of the ring, or of the piers where there are any), "extrados", "intrados".
struct ArchParameters final : MasonryParameters {
  double radius = 5.0;     ///< [m] of the middle line
  double thickness = 1.0;  ///< [m] radial
  double embrace = 180.0;  ///< [degree]
  int voussoirs = 31;
  int cells_radial = 4;
  int cells_along = 2;  ///< circumferential cells of a voussoir
  CellType cells = CellType::quadrilateral;
  double pier_height = 0.0;  ///< [m] 0 = no piers (stilts); only with an embrace of 180 degrees
  int pier_courses = 4;      ///< blocks a pier is made of
  double cell_count() const override;
  double longest_edge() const override;
  void coarsen(double factor) override;
  std::string words() const override;
  void declare(ParameterSection&);
};

/// A rectangular opening through a wall [m]. Its sides lie on half stones, its edges on beds. A lintel lies on half a
/// stone at either side of it, unless it reaches the top of the wall.
struct OpeningInSpace {
  double x_from = 0, x_to = 0, z_from = 0, z_to = 0;
  void declare(ParameterSection&);
};

/// A wall of boxes in space, one stone thick: x along it, y through it, z up. In running bond odd courses begin and end
/// with half blocks; returns, bonded in, have the corner in odd courses. The ground is a course of full blocks below.
/// Block sets: "course 0", ..., "ground", "facade", "return left", "return right", "lintels"; facet sets: "base",
/// "top", "left", "right", "front" (y 0), "back", "ground", "return left inside", "return right inside", "return ends".
struct WallInSpaceParameters final : MasonryParameters {
  int courses = 8;
  int blocks_per_course = 4;
  double block_length = 0.5;   ///< [m]
  double block_height = 0.25;  ///< [m]
  double thickness = 0.25;     ///< [m]
  WallBond bond = WallBond::running;
  int cells_along = 2;  ///< cells along a full block, even in running bond
  int cells_up = 2;
  int cells_across = 2;
  double ground_height = 0;  ///< [m] of the ground; 0 = none
  int return_left = 0;       ///< full blocks from the outer face of the wall to the end of the return; 0 = none
  int return_right = 0;
  ReturnsTo returns_to = ReturnsTo::back;
  std::map<std::string, OpeningInSpace> openings;
  double cell_count() const override;
  double longest_edge() const override;
  void coarsen(double factor) override;
  std::string words() const override;
  void declare(ParameterSection&);
};

/// A stack of equal boxes. Block sets: "course 0", ..., "ground"; facet sets as a wall's.
struct PrismParameters final : MasonryParameters {
  double length = 1.0;  ///< [m] along x
  double width = 0.6;   ///< [m] along y
  double height = 2.0;  ///< [m] of all stones
  int stones = 1;       ///< on each other
  int cells_along = 2;  ///< of a stone
  int cells_across = 2;
  int cells_up = 2;
  double ground_height = 0;  ///< [m] 0 = none
  double cell_count() const override;
  double longest_edge() const override;
  void coarsen(double factor) override;
  std::string words() const override;
  void declare(ParameterSection&);
};

/// A dome about z with its centre at the origin, of courses equal in angle and numbered from the springing upward.
/// Block sets: "course 0", ..., "ground"; facet sets: "base", "oculus", "intrados", "extrados", "ground".
struct DomeParameters final : MasonryParameters {
  double radius = 5.0;      ///< [m] of the middle surface
  double thickness = 0.5;   ///< [m] radial
  double oculus = 10.0;     ///< [degree] from the crown, where the last course ends
  double springing = 90.0;  ///< [degree] from the crown, where course 0 begins
  int courses = 8;
  int lunes = 16;  ///< stones of a course
  WallBond bond = WallBond::running;
  StoneFaces faces = StoneFaces::round;
  int cells_radial = 2;
  int cells_round = 2;  ///< of a stone; even in running bond
  int cells_up = 2;
  double ground_height = 0;  ///< [m] along the meridian below the springing; 0 = none
  double cell_count() const override;
  double longest_edge() const override;
  void coarsen(double factor) override;
  std::string words() const override;
  void declare(ParameterSection&);
};

/// An arch of the plane x, z with its centre at the origin, drawn out along y from 0. Courses lie along y.
/// Block sets: "course 0", ..., "ground left", "ground right"; facet sets: "springing left", "springing right",
/// "intrados", "extrados", "front", "back", "ground left", "ground right".
struct BarrelVaultParameters final : MasonryParameters {
  double radius = 3.0;     ///< [m] of the middle surface
  double thickness = 0.4;  ///< [m] radial
  double embrace = 180.0;  ///< [degree]
  double length = 4.0;     ///< [m] along y
  int voussoirs = 15;      ///< from springing to springing: courses
  int stones_along = 4;    ///< full stones of courses 0, 2, ...
  WallBond bond = WallBond::running;
  StoneFaces faces = StoneFaces::round;
  int cells_radial = 2;
  int cells_round = 1;       ///< of a stone, from springing to springing
  int cells_along = 2;       ///< of a full stone; even in running bond
  double ground_height = 0;  ///< [m] beyond the springings; 0 = none
  double cell_count() const override;
  double longest_edge() const override;
  void coarsen(double factor) override;
  std::string words() const override;
  void declare(ParameterSection&);
};

}  // namespace voussoir
