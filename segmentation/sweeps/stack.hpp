#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// A rectangle in a plane that is a side of one of a stack's hexahedra.
struct StackSide {
  Eigen::Vector2d low, high;  ///< along the plane's x and y, m
  int quad;                   ///< of the stack's drawing
  std::array<int, 2> edges;   ///< of the drawing, along x and y; -1 for what runs along the stack
};

/// A straight piece, m.
using Line = std::array<Eigen::Vector3d, 2>;

/// Whether a solid whose faces are floors and walls along a direction is a stack: drawn over each other, the
/// floors bound material by turns, and it is the solid's.
/// @cost  that of laying its floors over each other, some milliseconds each
bool is_stack(const geometry::Brep& solid, const SweepFrame& frame);

/// A stack divided into columns of hexahedra, which may be divided further.
class Stack {
 public:
  /// @param solid  must outlive it
  /// @param lines  on its floors; they become sides of hexahedra
  /// @throws Error unsupported  it is no stack, or its drawing cannot be divided: names the place
  Stack(const geometry::Brep& solid, SweepFrame frame, const std::vector<Line>& lines = {},
        const QuadrangulationOptions& options = {});
  Stack(Stack&&) noexcept;
  Stack& operator=(Stack&&) noexcept;
  ~Stack();

  const SweepFrame& frame() const;
  int quadrilaterals() const;
  int levels() const;

  /// Sides of its hexahedra in a plane, as far as they are rectangles along the plane's x and y.
  std::vector<StackSide> sides_on(const geometry::PlaneSurface& plane, double tolerance) const;
  /// Straight edges in a plane across it between sides of hexahedra there.
  std::vector<Line> lines_on(const geometry::PlaneSurface& plane, double tolerance) const;
  /// Divides a side, and whatever has to be with it, so that hexahedra meet side to side as before. Sides
  /// found before are no longer valid.
  /// @param axis   0 or 1: along which it is divided
  /// @param share  of the way from its low to its high end, in (0, 1)
  void divide(const geometry::PlaneSurface& plane, const StackSide& side, int axis, double share);
  /// Divides all columns in a plane across it.
  /// @param height  as its frame measures, m
  void divide_at(double height);

  /// Its hexahedra; they are checked to fill the solid.
  /// @param kept_free  ranges of heights that levels bend away from where they are no floors, m
  /// @throws Error unsupported  they do not
  geometry::CellComplex complex(const std::vector<std::array<double, 2>>& kept_free = {}) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isopatch::segmentation
