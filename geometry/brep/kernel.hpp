#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/brep/brep_parts.hpp"
#include "geometry/brep/measure.hpp"
#include "geometry/brep/tessellation.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// What a Brep shows of itself without computing.
struct BrepTables {
  std::vector<BrepFace> faces;
  std::vector<BrepEdge> edges;
  Eigen::Matrix3Xd vertices;
  std::array<Eigen::Vector3d, 2> box;
};

/// What a CAD library must be able to do for `Brep`, which explains the functions and checks their ids.
///
/// The one implementation is in `opencascade/`, a module that is loaded when the first solid is made.
class BrepKernel {
 public:
  virtual ~BrepKernel() = default;

  virtual const BrepTables& tables() const = 0;

  virtual Measure volume() const = 0;
  virtual Measure area(FaceId face) const = 0;

  virtual Eigen::Vector3d point(EdgeId edge, double t) const = 0;
  virtual Eigen::Vector3d tangent(EdgeId edge, double t) const = 0;
  virtual EdgeProjection project(EdgeId edge, const Eigen::Vector3d& point) const = 0;
  virtual NurbsCurve curve(EdgeId edge) const = 0;

  virtual DomainBox domain(FaceId face) const = 0;
  /// @return nothing if the face has no such use
  virtual std::optional<Eigen::Vector2d> domain_point(FaceId face, EdgeUse use, double t) const = 0;
  virtual std::optional<Eigen::Vector2d> domain_tangent(FaceId face, EdgeUse use, double t) const = 0;
  virtual Eigen::Vector3d point(FaceId face, const Eigen::Vector2d& uv) const = 0;
  virtual Eigen::Matrix<double, 3, 2> derivatives(FaceId face, const Eigen::Vector2d& uv) const = 0;
  virtual Eigen::Matrix3d second_derivatives(FaceId face, const Eigen::Vector2d& uv) const = 0;
  virtual FaceProjection project(FaceId face, const Eigen::Vector3d& point) const = 0;
  virtual FaceProjection project(FaceId face, const Eigen::Vector3d& point,
                                 const Eigen::Vector2d& start) const = 0;
  virtual bool contains(FaceId face, const Eigen::Vector2d& uv) const = 0;
  virtual std::optional<Carrier> carrier(FaceId face) const = 0;

  virtual Tessellation tessellate(const TessellationOptions& options) const = 0;
};

}  // namespace isopatch::geometry
