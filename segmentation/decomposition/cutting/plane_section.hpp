#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {

/// A loop and where its places are, m.
struct SpacedLoop {
  CuttingLoop loop;
  std::vector<Eigen::Vector3d> places;
};

/// The loop in which a plane through a straight edge of a cell cuts it, next to that edge. Curved sides it
/// may cross once. Sides that lie in the plane at its outline are extended.
/// @param edge  of the sides' graph, in the plane
/// @param into  direction in the plane away from the edge, into the cell
/// @return nothing where the section is no simple loop
/// @cost O(edges + sides)
std::optional<SpacedLoop> plane_section(const CellShapes& shapes, const CellSides& sides, EdgeId edge,
                                        const Eigen::Vector3d& normal, const Eigen::Vector3d& into,
                                        double same_point);

/// The same next to where the plane crosses a side.
/// @param side   face of the graph
/// @param point  in the side and the plane
/// @param along  direction of the plane in the side
std::optional<SpacedLoop> plane_section(const CellShapes& shapes, const CellSides& sides, FaceId side,
                                        const Eigen::Vector3d& point, const Eigen::Vector3d& along,
                                        const Eigen::Vector3d& normal, double same_point);

/// The sections by planes through an edge: those of its two sides, the one between them, and those through
/// each vertex, wherever they run into the cell there.
std::vector<SpacedLoop> plane_sections(const CellShapes& shapes, const CellSides& sides, EdgeId edge,
                                       double same_point);

}  // namespace isopatch::segmentation
