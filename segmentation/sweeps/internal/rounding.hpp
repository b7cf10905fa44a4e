#pragma once

#include <map>
#include <tuple>
#include <utility>

#include "geometry/base/ids.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// What is not straight up or level in columns of hexahedra. Numbers are those of the drawing and of levels.
struct Rounding {
  using Flat = std::pair<int, int>;           ///< number, level
  using Upright = std::tuple<int, int, int>;  ///< number, low and high level
  /// A side on a face of the solid.
  struct Side {
    Flat from;                       ///< the edge that it begins at
    geometry::NurbsSurface surface;  ///< u along that edge from start to end, v away from it
    FaceId origin;
  };
  std::map<Flat, Eigen::Vector3d> vertices;
  std::map<Flat, geometry::NurbsCurve> level_edges;       ///< from start to end
  std::map<Upright, geometry::NurbsCurve> upright_edges;  ///< by vertex, from low to high
  std::map<Flat, Side> floors;                            ///< by quadrilateral
  std::map<Upright, Side> walls;                          ///< by edge

  /// What is one because a hexahedron between them has been left out: the first is made, the second is not.
  std::map<Flat, Flat> same_vertices, same_level_edges;  ///< the second's number: the first's
  struct Leaning {
    Flat flat;      ///< of a level
    bool reversed;  ///< as an edge: it runs from the high to the low end; as a side: it looks into the cell
  };
  std::map<Upright, Leaning> leaning_edges, leaning_walls;  ///< edges and quadrilaterals of a level instead
};

}  // namespace isopatch::segmentation
