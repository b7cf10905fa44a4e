#include "segmentation/decomposition/combinatorics/internal/loop_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/base/dense_matrices.hpp"

namespace isopatch::segmentation {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double positive_angle(double angle) {
  return angle < 0 ? angle + full_turn : angle;
}

Eigen::Vector3d face_normal(const CellGraph& graph, const Eigen::Matrix3Xd& points, FaceId face) {
  const CellGraph::Corners& corners = graph.face(face);
  Eigen::Matrix3Xd polygon(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k)
    polygon.col(static_cast<Eigen::Index>(k)) = points.col(corners[k].value);
  return area_vector(polygon);
}

// From one direction to another, counter-clockwise around a normal, [0, 2 pi).
double turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& normal) {
  return positive_angle(std::atan2(from.cross(to).dot(normal.normalized()), from.dot(to)));
}

// Inside two faces with outward normals that meet in an edge, walked as the first has it to its left.
double dihedral(const Eigen::Vector3d& first, const Eigen::Vector3d& second, const Eigen::Vector3d& along) {
  const double bend = std::atan2(first.cross(second).dot(along.normalized()), first.dot(second));
  return positive_angle(std::numbers::pi - bend);
}

// Directions to the corners of a face after and before a place on it.
struct CornerArms {
  Eigen::Vector3d next, previous;
};
CornerArms arms(const CellGraph& graph, const CellIncidence& incidence, const Eigen::Matrix3Xd& points,
                FaceId face, const LoopPlace& place, const Eigen::Vector3d& at) {
  const CellGraph::Corners& corners = graph.face(face);
  const int n = static_cast<int>(corners.size());
  int before = 0, after = 0;
  if (place.auxiliary()) {
    const std::vector<EdgeId>& sides = incidence.sides(face);
    before = static_cast<int>(std::find(sides.begin(), sides.end(), place.edge) - sides.begin());
    after = (before + 1) % n;
  } else {
    const int corner =
        static_cast<int>(std::find(corners.begin(), corners.end(), place.vertex) - corners.begin());
    before = (corner + n - 1) % n;
    after = (corner + 1) % n;
  }
  return {points.col(corners[after].value) - at, points.col(corners[before].value) - at};
}

double indirection_at(const CornerArms& corner, const Eigen::Vector3d& chord, const Eigen::Vector3d& normal) {
  const double alpha = turn(corner.next, corner.previous, normal), part = turn(corner.next, chord, normal);
  if (alpha <= 0) return 2;
  if (part <= alpha) return std::abs(2 * part - alpha) / alpha;
  return (alpha + 2 * std::min(part - alpha, full_turn - part)) / alpha;
}

}  // namespace

Eigen::Matrix3Xd place_points(const CellGraph& graph, const Eigen::Matrix3Xd& points,
                              const CuttingLoop& loop) {
  Eigen::Matrix3Xd result(3, loop.length());
  for (int k = 0; k < loop.length(); ++k) {
    const LoopPlace& place = loop.places[k];
    if (place.auxiliary()) {
      const CellGraph::Edge& edge = graph.edge(place.edge);
      result.col(k) = (points.col(edge.start.value) + points.col(edge.end.value)) / 2;
    } else {
      result.col(k) = points.col(place.vertex.value);
    }
  }
  return result;
}

Eigen::Vector3d area_vector(const Eigen::Matrix3Xd& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Index n = polygon.cols();
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    const Eigen::Vector3d a = polygon.col(k) - polygon.col(0), b = polygon.col(k + 1) - polygon.col(0);
    sum += a.cross(b) / 2;
  }
  return sum;
}

double unevenness(const Eigen::Matrix3Xd& polygon) {
  const double area = area_vector(polygon).norm();
  if (!(area > 0)) return 1;
  const Eigen::Vector3d middle = polygon.rowwise().mean();
  const Eigen::Matrix3Xd offsets = polygon.colwise() - middle;
  const double least = principal_axes(offsets * offsets.transpose()).values[0];
  return std::sqrt(std::max(0.0, least) / static_cast<double>(polygon.cols()) / area);
}

double indirection(const CellGraph& graph, const CellIncidence& incidence, const Eigen::Matrix3Xd& points,
                   const CuttingLoop& loop) {
  const Eigen::Matrix3Xd at = place_points(graph, points, loop);
  double sum = 0;
  for (int k = 0; k < loop.length(); ++k) {
    if (!loop.steps[k].auxiliary()) continue;
    const FaceId face = loop.steps[k].face;
    const Eigen::Vector3d normal = face_normal(graph, points, face);
    const int next = (k + 1) % loop.length();
    const Eigen::Vector3d chord = at.col(next) - at.col(k);
    sum +=
        indirection_at(arms(graph, incidence, points, face, loop.places[k], at.col(k)), chord, normal) +
        indirection_at(arms(graph, incidence, points, face, loop.places[next], at.col(next)), -chord, normal);
  }
  return sum;
}

std::vector<DividedAngle> divided_angles(const CellGraph& graph, const CellIncidence& incidence,
                                         const Eigen::Matrix3Xd& points, const CuttingLoop& loop) {
  const Eigen::Matrix3Xd at = place_points(graph, points, loop);
  const Eigen::Vector3d cut = area_vector(at);
  std::vector<DividedAngle> result;
  for (int k = 0; k < loop.length(); ++k) {
    const LoopStep& step = loop.steps[k];
    FaceId left = step.face, right = step.face;
    if (!step.auxiliary()) {
      const bool forwards = graph.edge(step.edge).start == loop.places[k].vertex;
      left = forwards ? incidence.left(step.edge) : incidence.right(step.edge);
      right = forwards ? incidence.right(step.edge) : incidence.left(step.edge);
    }
    const Eigen::Vector3d along = at.col((k + 1) % loop.length()) - at.col(k);
    const Eigen::Vector3d on_left = face_normal(graph, points, left),
                          on_right = face_normal(graph, points, right);
    DividedAngle angle{dihedral(on_left, -cut, along), dihedral(on_right, cut, -along), true};
    // Rounding: angles of exact right angles differ by about 1e-15.
    angle.inside = std::abs(angle.left + angle.right - dihedral(on_left, on_right, along)) < 1e-6;
    result.push_back(angle);
  }
  return result;
}

}  // namespace isopatch::segmentation
