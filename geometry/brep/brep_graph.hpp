#pragma once

#include "geometry/brep/brep.hpp"
#include "geometry/topology/edge_graph.hpp"

namespace isopatch::geometry {

/// The boundary of a solid without its geometry; same numbers.
EdgeGraph edge_graph(const Brep& brep);

}  // namespace isopatch::geometry
