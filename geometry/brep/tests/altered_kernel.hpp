#pragma once

#include <memory>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/kernel.hpp"

namespace isopatch::geometry::test {

/// What a solid's kernel says, but for what a test alters: solids that contradict themselves, as damaged
/// files give them and no builder makes.
struct Altered {
  BrepTables tables;
  double volume_factor = 1;
  Eigen::Vector3d triangles_moved_by = Eigen::Vector3d::Zero();  ///< of the first face alone
  FaceId moved_face = {};                                        ///< whose surface lies elsewhere
  Eigen::Vector3d face_moved_by = Eigen::Vector3d::Zero();
};

class AlteredKernel final : public BrepKernel {
 public:
  AlteredKernel(Brep brep, Altered altered) : brep_(std::move(brep)), altered_(std::move(altered)) {}

  const BrepTables& tables() const override { return altered_.tables; }
  Measure volume() const override {
    const Measure volume = kernel().volume();
    return {altered_.volume_factor * volume.value, volume.error};
  }
  Measure area(FaceId face) const override { return kernel().area(face); }
  Eigen::Vector3d point(EdgeId edge, double t) const override { return kernel().point(edge, t); }
  Eigen::Vector3d tangent(EdgeId edge, double t) const override { return kernel().tangent(edge, t); }
  EdgeProjection project(EdgeId edge, const Eigen::Vector3d& point) const override {
    return kernel().project(edge, point);
  }
  NurbsCurve curve(EdgeId edge) const override { return kernel().curve(edge); }
  DomainBox domain(FaceId face) const override { return kernel().domain(face); }
  std::optional<Eigen::Vector2d> domain_point(FaceId face, EdgeUse use, double t) const override {
    return kernel().domain_point(face, use, t);
  }
  std::optional<Eigen::Vector2d> domain_tangent(FaceId face, EdgeUse use, double t) const override {
    return kernel().domain_tangent(face, use, t);
  }
  Eigen::Vector3d point(FaceId face, const Eigen::Vector2d& uv) const override {
    const Eigen::Vector3d point = kernel().point(face, uv);
    return face == altered_.moved_face ? Eigen::Vector3d(point + altered_.face_moved_by) : point;
  }
  Eigen::Matrix<double, 3, 2> derivatives(FaceId face, const Eigen::Vector2d& uv) const override {
    return kernel().derivatives(face, uv);
  }
  Eigen::Matrix3d second_derivatives(FaceId face, const Eigen::Vector2d& uv) const override {
    return kernel().second_derivatives(face, uv);
  }
  FaceProjection project(FaceId face, const Eigen::Vector3d& point) const override {
    return kernel().project(face, point);
  }
  FaceProjection project(FaceId face, const Eigen::Vector3d& point,
                         const Eigen::Vector2d& start) const override {
    return kernel().project(face, point, start);
  }
  bool contains(FaceId face, const Eigen::Vector2d& uv) const override { return kernel().contains(face, uv); }
  std::optional<Carrier> carrier(FaceId face) const override { return kernel().carrier(face); }
  Tessellation tessellate(const TessellationOptions& options) const override {
    Tessellation mesh = kernel().tessellate(options);
    mesh.faces.front().points.colwise() += altered_.triangles_moved_by;
    return mesh;
  }

 private:
  const BrepKernel& kernel() const { return brep_.kernel(); }
  Brep brep_;
  Altered altered_;
};

/// The solid after `change` has altered what it says of itself.
template <class Change>
Brep altered(const Brep& brep, Change change) {
  Altered result{brep.kernel().tables()};
  change(result);
  return Brep(std::make_shared<AlteredKernel>(brep, std::move(result)));
}

}  // namespace isopatch::geometry::test
