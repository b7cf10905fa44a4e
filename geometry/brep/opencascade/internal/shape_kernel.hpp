#pragma once

#include <BRepTopAdaptor_FClass2d.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <map>
#include <memory>
#include <mutex>
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

struct FaceMeasure;
struct FaceMeasureOptions;

/// A solid of OpenCASCADE.
class ShapeKernel final : public BrepKernel {
 public:
  explicit ShapeKernel(ShapeInput input);
  ~ShapeKernel() override;

  const BrepTables& tables() const override { return tables_; }
  Measure volume() const override;
  Measure area(FaceId face) const override;
  Eigen::Vector3d point(EdgeId edge, double t) const override;
  Eigen::Vector3d tangent(EdgeId edge, double t) const override;
  EdgeProjection project(EdgeId edge, const Eigen::Vector3d& point) const override;
  NurbsCurve curve(EdgeId edge) const override;
  DomainBox domain(FaceId face) const override;
  std::optional<Eigen::Vector2d> domain_point(FaceId face, EdgeUse use, double t) const override;
  std::optional<Eigen::Vector2d> domain_tangent(FaceId face, EdgeUse use, double t) const override;
  Eigen::Vector3d point(FaceId face, const Eigen::Vector2d& uv) const override;
  Eigen::Matrix<double, 3, 2> derivatives(FaceId face, const Eigen::Vector2d& uv) const override;
  Eigen::Matrix3d second_derivatives(FaceId face, const Eigen::Vector2d& uv) const override;
  FaceProjection project(FaceId face, const Eigen::Vector3d& point) const override;
  FaceProjection project(FaceId face, const Eigen::Vector3d& point,
                         const Eigen::Vector2d& start) const override;
  bool contains(FaceId face, const Eigen::Vector2d& uv) const override;
  std::optional<Carrier> carrier(FaceId face) const override;
  Tessellation tessellate(const TessellationOptions& options) const override;

  const ShapeInput& input() const { return input_; }
  const FaceGeometry& of(FaceId face) const { return faces_[static_cast<std::size_t>(face.value)]; }
  const EdgeGeometry& of(EdgeId edge) const { return edges_[static_cast<std::size_t>(edge.value)]; }

 private:
  // What is computed when first asked for.
  struct Lazy;

  const FaceMeasure& measure(std::size_t face) const;
  FaceMeasureOptions measure_options() const;

  ShapeInput input_;
  BrepTables tables_;
  std::vector<FaceGeometry> faces_;
  std::vector<EdgeGeometry> edges_;
  std::unique_ptr<Lazy> lazy_;
};

}  // namespace isopatch::geometry
