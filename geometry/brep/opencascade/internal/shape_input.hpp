#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/kernel.hpp"

namespace isopatch::geometry {

/// What a ShapeKernel is made of.
struct ShapeInput {
  TopoDS_Shape shape;              ///< solid or shell of the faces, with outward normals
  std::vector<TopoDS_Face> faces;  ///< oriented as in the shape, in the order of their ids
  std::vector<TopoDS_Vertex>
      vertices;  ///< first vertices, in the order of their ids; others follow as they are met
  std::vector<TopoDS_Edge> edges;              ///< the same of edges
  std::vector<std::string> names;              ///< one a face, or none at all
  std::vector<std::optional<Colour>> colours;  ///< the same
  double metres = 1;                           ///< that one unit of the shape's coordinates measures
};

/// A face's use of an edge: the curve in its domain.
struct UseCurve {
  Handle(Geom2d_Curve) curve;
  double first = 0, last = 0;  ///< at the edge's start and end
};

struct FaceGeometry {
  TopoDS_Face face;              ///< oriented along its surface
  Handle(Geom_Surface) surface;  ///< in the model's frame
  DomainBox domain;
  std::map<EdgeUse, UseCurve> uses;
};

struct EdgeGeometry {
  TopoDS_Edge edge;            ///< oriented along its curve
  Handle(Geom_Curve) curve;    ///< in the model's frame
  double first = 0, last = 0;  ///< at start and end
};

}  // namespace isopatch::geometry
