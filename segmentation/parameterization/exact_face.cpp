#include "segmentation/parameterization/internal/exact_face.hpp"

#include <Eigen/Geometry>
#include <vector>

#include "geometry/splines/grid.hpp"
#include "segmentation/parameterization/internal/edge_samples.hpp"

namespace isopatch::segmentation {

using geometry::KnotVector;
namespace {

/// Of the distance that is good enough: nearer is exact, and no other net need be looked at.
constexpr double clearly_exact = 1e-4;

/// A net's boundary and sizes, with its directions exchanged where `turned`.
class NetView {
 public:
  NetView(const std::array<KnotVector, 2>& knots, bool turned)
      : n_(knots[0].size()), m_(knots[1].size()), turned_(turned) {}
  int along() const { return turned_ ? m_ : n_; }
  int across() const { return turned_ ? n_ : m_; }
  Eigen::Index at(int i, int j) const {
    return turned_ ? j + Eigen::Index(n_) * i : i + Eigen::Index(n_) * j;
  }

 private:
  int n_, m_;
  bool turned_;
};

struct Axis {
  Eigen::Vector3d center, direction;
};

/// The axis of the circle through three points; nothing if they lie on a line.
std::optional<Axis> axis_through(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c) {
  const Eigen::Vector3d u = b - a, v = c - a, normal = u.cross(v);
  const double square = normal.squaredNorm();
  if (!(square > 1e-12 * u.squaredNorm() * v.squaredNorm())) return std::nullopt;
  const Eigen::Vector3d to_center = (u.squaredNorm() * v - v.squaredNorm() * u).cross(normal) / (2 * square);
  return Axis{a + to_center, normal.normalized()};
}

/// The edge at the low end of a direction turned along the arc at the low end of the other.
std::optional<RationalNet> turned_net(const std::array<KnotVector, 2>& knots, RationalNet net, bool turned) {
  const NetView view(knots, turned);
  const KnotVector& along = knots[turned ? 1 : 0];
  RationalNet arc = RationalNet::of_size(view.along());
  for (int i = 0; i < view.along(); ++i) {
    arc.points.col(i) = net.points.col(view.at(i, 0));
    arc.weights[i] = net.weights[view.at(i, 0)];
  }
  const geometry::NurbsCurve curve({along}, arc.points, arc.weights);
  const auto at = [&](double share) {
    return curve.point(geometry::Parameter<1>(along.first() + share * along.length()));
  };
  const std::optional<Axis> axis = axis_through(at(0), at(0.5), at(1));
  if (!axis) return std::nullopt;
  const Eigen::Vector3d radius = arc.points.col(0) - axis->center, beside = axis->direction.cross(radius);
  for (int i = 1; i + 1 < view.along(); ++i) {
    const Eigen::Vector3d way = arc.points.col(i) - axis->center;
    const double cosine = way.dot(radius) / radius.squaredNorm(),
                 sine = way.dot(beside) / radius.squaredNorm();
    for (int j = 1; j + 1 < view.across(); ++j) {
      const Eigen::Vector3d point = net.points.col(view.at(0, j));
      const Eigen::Vector3d foot = axis->center + axis->direction * axis->direction.dot(point - axis->center);
      const Eigen::Vector3d own = point - foot;
      net.points.col(view.at(i, j)) = foot + cosine * own + sine * axis->direction.cross(own);
      net.weights[view.at(i, j)] = arc.weights[i] * net.weights[view.at(0, j)];
    }
  }
  return net;
}

DeviationGrid distances(const FaceMap& map, const std::array<KnotVector, 2>& knots, const RationalNet& net,
                        const std::array<std::vector<double>, 2>& at) {
  const Eigen::Matrix3Xd points =
      geometry::points_on_grid(geometry::NurbsSurface(knots, net.points, net.weights), {at[0], at[1]});
  const Eigen::Matrix2Xd starts = map.domain_grid(at[0], at[1]);
  DeviationGrid result{at[0], at[1], Eigen::VectorXd(points.cols())};
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result.values[i] =
        (map.face().surface(project(map, points.col(i), starts.col(i))) - points.col(i)).norm();
  return result;
}

}  // namespace

std::optional<ExactFace> exact_face(const FaceMap& map, const std::array<KnotVector, 2>& knots,
                                    const RationalNet& framed, const std::array<std::vector<double>, 2>& at,
                                    double distance) {
  // Where the blend of the sides folds in the domain, that of the nets would too.
  if (map.kind() != FaceMapKind::coons) return std::nullopt;
  std::vector<RationalNet> nets{framed};
  for (const bool turned : {false, true})
    if (auto net = turned_net(knots, framed, turned)) nets.push_back(std::move(*net));
  std::optional<ExactFace> best;
  double least = distance;
  for (RationalNet& net : nets) {
    if (!has_fair_weights(net)) continue;
    DeviationGrid deviations = distances(map, knots, net, at);
    const double largest = deviations.values.maxCoeff();
    if (!(largest <= least)) continue;
    best = ExactFace{std::move(net), std::move(deviations)};
    // In a plane all of them are exact, and the blend is the one with even inner points.
    if (largest < clearly_exact * distance) break;
    least = largest;
  }
  return best;
}

}  // namespace isopatch::segmentation
