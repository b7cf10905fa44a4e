#include "segmentation/balls/internal/ball_frame.hpp"

#include <Eigen/Geometry>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

/// Integrals over a solid of 1, x and x x^T, about a point near it.
struct Moments {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  /// The tetrahedron between a triangle and the point, which is 0.
  void add(const Eigen::Matrix3d& corners) {
    const double share = corners.determinant() / 6;
    const Eigen::Vector3d sum = corners.rowwise().sum();
    volume += share;
    first += share / 4 * sum;
    second += share / 20 * (corners * corners.transpose() + sum * sum.transpose());
  }
};

Moments moments_of(const geometry::Tessellation& surface, const Eigen::Vector3d& about) {
  Moments result;
  for (const geometry::FaceTriangles& face : surface.faces)
    for (Eigen::Index t = 0; t < face.triangles.cols(); ++t) {
      Eigen::Matrix3d corners;
      for (int i = 0; i < 3; ++i) corners.col(i) = face.points.col(face.triangles(i, t)) - about;
      result.add(corners);
    }
  return result;
}

}  // namespace

BallFrame ball_frame(const geometry::Brep& solid) {
  const Eigen::Vector3d about = (solid.box()[0] + solid.box()[1]) / 2;
  const Moments moments = moments_of(tessellate(solid), about);
  const Eigen::Vector3d way = moments.first / moments.volume;
  // Of a solid ellipsoid: radius^2 / 5 along each axis.
  const PrincipalAxes main = principal_axes(moments.second / moments.volume - way * way.transpose());
  if (!(moments.volume > 0 && main.values[0] > 0))
    throw Error(ErrorCode::unsupported, "its face does not bound a body");
  BallFrame result{about + way, main.axes, (5 * main.values).cwiseSqrt()};
  result.axes.col(2) = result.axes.col(0).cross(result.axes.col(1));
  return result;
}

}  // namespace isopatch::segmentation
