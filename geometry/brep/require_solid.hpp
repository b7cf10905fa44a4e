#pragma once

#include <string>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/edge_graph.hpp"

namespace isopatch::geometry {

/// "edge 3 from vertex 1 at (0, 0.1, 0) to vertex 2 at (1, 0, 0) m, of faces 0 and 4".
std::string describe(const Brep& brep, EdgeId edge);
std::string describe(const Brep& brep, VertexId vertex);
/// With its name, if it has one.
std::string describe(const Brep& brep, FaceId face);

/// What keeps faces from bounding a solid, the first few entities named; "" if nothing does.
std::string boundary_problem(const Brep& brep, const BoundaryReport& report);

/// @throws Error not_manifold  with the problem
void require_solid(const Brep& brep);

}  // namespace isopatch::geometry
