#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "segmentation/decomposition/cutting_error.hpp"
#include "segmentation/decomposition/parted_sides.hpp"
#include "segmentation/decomposition/search_cell.hpp"

namespace isopatch::segmentation {

/// "faces 3, 7, 9": those of the solid that an unfinished part has pieces of, for messages; "no face" if
/// it lies inside.
std::string faces_of_unfinished(const CutTree& tree, const CellStore& store);

/// The error of a search that ended with parts that are no base solids; their concave edges are its fault.
CuttingError unfinished_search(const std::string& message, const CutTree& tree, const CellStore& store);

/// An error about cells that are all base solids; the edges where they meet in parts are its fault.
CuttingError unfinished_meeting(const Error& error, const geometry::Brep& solid,
                                const geometry::CellComplex& cells, const std::vector<PartedSide>& t_joints);

/// An edge as a polyline of 17 points, m.
Eigen::Matrix3Xd polyline(const CellShapes& shapes, EdgeId edge);

}  // namespace isopatch::segmentation
