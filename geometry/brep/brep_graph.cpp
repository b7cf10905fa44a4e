#include "geometry/brep/brep_graph.hpp"

namespace isopatch::geometry {

EdgeGraph edge_graph(const Brep& brep) {
  EdgeGraph graph;
  graph.vertex_count = static_cast<int>(brep.vertices().cols());
  for (const BrepEdge& edge : brep.edges()) graph.edges.push_back({edge.start, edge.end});
  for (const BrepFace& face : brep.faces()) graph.faces.push_back({face.loops});
  return graph;
}

}  // namespace isopatch::geometry
