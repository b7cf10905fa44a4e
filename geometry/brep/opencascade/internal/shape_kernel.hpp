#pragma once

#include <BRepTopAdaptor_FClass2d.hxx>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/brep/kernel.hpp"
#include "geometry/brep/opencascade/internal/shape_input.hpp"

namespace isopatch::geometry {

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
