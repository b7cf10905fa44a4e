#include "segmentation/reconstruction/internal/freeform_edges.hpp"

#include <algorithm>

#include "geometry/brep/carrier_solid.hpp"
#include "segmentation/reconstruction/internal/fit_curves.hpp"
#include "segmentation/reconstruction/internal/meeting_point.hpp"

namespace isopatch::segmentation {
namespace {

constexpr int intervals_of_edge = geometry::CarrierSolid::points_of_edge - 1;
constexpr int most_sampled_pieces = 16;
// Edges that turn by less than 46 degrees in a vertex go on in each other there.
constexpr double smooth_cosine = 0.7;
constexpr std::size_t points_beyond = 4;

Eigen::Matrix3Xd sampled(const geometry::NurbsCurve& curve, int intervals) {
  Eigen::Matrix3Xd points(3, intervals + 1);
  for (int i = 0; i <= intervals; ++i)
    points.col(i) = curve.point(curve.low() + (curve.high() - curve.low()) * i / intervals);
  return points;
}

Eigen::Matrix3Xd as_columns(const std::vector<Eigen::Vector3d>& points) {
  return Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3,
                                            static_cast<Eigen::Index>(points.size()));
}

/// Edges that end in a vertex where others go on smoothly, as cuts across a band make them, have no corner
/// there: they follow points of their continuations too.
class SmoothEdges {
 public:
  SmoothEdges(const Wireframe& wires, const Regions& regions) : wires_(wires), regions_(regions) {
    at_vertex_.resize(wires.vertices.size());
    for (std::size_t e = 0; e < wires.edges.size(); ++e) {
      if (wires.edges[e].points.size() < 2) continue;
      at_vertex_[static_cast<std::size_t>(wires.edges[e].start)].push_back({e, false});
      at_vertex_[static_cast<std::size_t>(wires.edges[e].end)].push_back({e, true});
    }
  }

  geometry::NurbsCurve curve(std::size_t number, double tolerance) const {
    const std::vector<Eigen::Vector3d>& own = wires_.edges[number].points;
    std::vector<Eigen::Vector3d> all = beyond({number, false});
    std::reverse(all.begin(), all.end());
    const std::size_t before = all.size();
    all.insert(all.end(), own.begin(), own.end());
    const std::vector<Eigen::Vector3d> after = beyond({number, true});
    all.insert(all.end(), after.begin(), after.end());
    if (all.size() == 2) return geometry::NurbsCurve({geometry::KnotVector()}, as_columns(all));
    const CurveSample sample = by_length(as_columns(all));
    geometry::NurbsCurve whole = fit_curves({sample}, tolerance).curves.front();
    if (all.size() == own.size()) return whole;
    const double low = sample.t[static_cast<Eigen::Index>(before)],
                 high = sample.t[static_cast<Eigen::Index>(before + own.size()) - 1];
    const int count = 2 * std::max(intervals_of_edge, 4 * whole.knots(0).element_count()) + 1;
    CurveSample part{Eigen::VectorXd::LinSpaced(count, 0, 1), Eigen::Matrix3Xd(3, count)};
    for (int i = 0; i < count; ++i)
      part.points.col(i) = whole.point(geometry::Parameter<1>(low + (high - low) * part.t[i]));
    part.points.leftCols<1>() = own.front();
    part.points.rightCols<1>() = own.back();
    return fit_curves({part}, tolerance).curves.front();
  }

 private:
  struct End {
    std::size_t edge;
    bool is_end;
  };

  /// Points of an edge from one of its ends on.
  std::vector<Eigen::Vector3d> from(const End& end) const {
    std::vector<Eigen::Vector3d> result = wires_.edges[end.edge].points;
    if (end.is_end) std::reverse(result.begin(), result.end());
    return result;
  }

  /// Points past an end, nearest first.
  std::vector<Eigen::Vector3d> beyond(const End& end) const {
    const WireEdge& edge = wires_.edges[end.edge];
    const std::vector<Eigen::Vector3d> own = from(end);
    std::vector<Eigen::Vector3d> best;
    double least = smooth_cosine;
    for (const End& other : at_vertex_[static_cast<std::size_t>(end.is_end ? edge.end : edge.start)]) {
      if (other.edge == end.edge) continue;
      const std::vector<Eigen::Vector3d> points = from(other);
      const double cosine = (own[0] - own[1]).normalized().dot((points[1] - points[0]).normalized());
      if (!(cosine > least) || !is_freeform(wires_.edges[other.edge])) continue;
      least = cosine;
      best.assign(points.begin() + 1,
                  points.begin() + static_cast<std::ptrdiff_t>(std::min(points.size(), points_beyond + 1)));
    }
    return best;
  }
  bool is_freeform(const WireEdge& edge) const {
    return std::any_of(edge.regions.begin(), edge.regions.end(),
                       [&](int r) { return !regions_.regions[static_cast<std::size_t>(r)].carrier; });
  }

  const Wireframe& wires_;
  const Regions& regions_;
  std::vector<std::vector<End>> at_vertex_;
};

}  // namespace

void add_freeform_edges(Wireframe& wires, const Regions& regions, double tolerance, double size) {
  const SmoothEdges smooth(wires, regions);
  for (std::size_t e = 0; e < wires.edges.size(); ++e) {
    WireEdge& edge = wires.edges[e];
    if (edge.curve || edge.points.size() < 2) continue;
    const auto& left = regions.regions[static_cast<std::size_t>(edge.regions[0])].carrier;
    const auto& right = regions.regions[static_cast<std::size_t>(edge.regions[1])].carrier;
    if (left && right) continue;
    const geometry::NurbsCurve curve = smooth.curve(e, tolerance);
    edge.curve = curve;
    const auto& carrier = left ? left : right;
    if (!carrier || carrier->kind == geometry::SurfaceKind::plane) continue;
    const int pieces = std::clamp(static_cast<int>(edge.points.size()) / 8, 1, most_sampled_pieces);
    Eigen::Matrix3Xd on_carrier = sampled(curve, pieces * intervals_of_edge);
    for (Eigen::Index i = 1; i + 1 < on_carrier.cols(); ++i)
      on_carrier.col(i) = meeting_point({*carrier}, on_carrier.col(i), size);
    edge.curve.reset();
    edge.on_carrier = std::move(on_carrier);
  }
}

Eigen::Matrix3Xd points_along(const WireEdge& edge) {
  if (!edge.curve) return edge.on_carrier;
  const int spans = edge.curve->knots(0).element_count();
  return sampled(*edge.curve, std::max(intervals_of_edge, 4 * spans));
}

}  // namespace isopatch::segmentation
