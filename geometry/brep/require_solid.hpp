#pragma once

#include <string>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/edge_graph.hpp"

namespace isopatch::geometry {

/// "edge 3 from vertex 1 at (0, 0.1, 0) to vertex 2 at (1, 0, 0) m, of faces 0 and 4".
std::string describe(const Brep& brep, EdgeId edge);
std::string describe(const Brep& brep, VertexId vertex);
/// With its name, if it has one.
std::string describe(const Brep& brep, FaceId face);

/// An edge as a fault shows it: its number and 25 points.
SolidFault::Edge drawn(const Brep& brep, EdgeId edge);

/// What keeps faces from bounding a solid, the first few entities named; "" if nothing does.
std::string boundary_problem(const Brep& brep, const BoundaryReport& report);

/// The edges with their faces, and the vertices, that keep faces from bounding a solid.
SolidFault boundary_fault(const Brep& brep, const BoundaryReport& report);

/// @throws SolidError not_manifold  with the problem and its places
void require_solid(const Brep& brep);

}  // namespace isopatch::geometry
