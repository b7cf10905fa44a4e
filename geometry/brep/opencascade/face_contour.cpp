#include "geometry/brep/opencascade/internal/face_contour.hpp"

#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {
namespace {

// Shares of the contour's extent: ends that are one for our quadrature, and such that obviously belong
// together.
constexpr double identical = 1e-12, adjacent = 1e-6;

class ContourMaker {
 public:
  ContourMaker(const TopoDS_Face& face, const GeomAdaptor_Surface& surface)
      : face_(face), surface_(surface) {}

  FaceContour make() {
    add_edges();
    if (result_.curves.empty()) add_bounds();
    set_extent();
    pair_adjacent();
    pair_the_rest();
    return std::move(result_);
  }

 private:
  void add_edges() {
    for (TopExp_Explorer it(face_, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
      ContourCurve walked;
      walked.curve = BRep_Tool::CurveOnSurface(edge, face_, walked.first, walked.last);
      if (walked.curve.IsNull()) continue;
      if (BRep_Tool::SameParameter(edge) && BRep_Tool::SameRange(edge) && !BRep_Tool::Degenerated(edge)) {
        double first = 0, last = 0;
        walked.edge = BRep_Tool::Curve(edge, first, last);
      }
      if (edge.Orientation() == TopAbs_REVERSED) std::swap(walked.first, walked.last);
      add(walked);
    }
  }

  void add_bounds() {
    const double u0 = surface_.FirstUParameter(), u1 = surface_.LastUParameter();
    const double v0 = surface_.FirstVParameter(), v1 = surface_.LastVParameter();
    for (const double bound : {u0, u1, v0, v1})
      if (Precision::IsInfinite(bound)) return;
    const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(u0, v0), Eigen::Vector2d(u1, v0),
                                                    Eigen::Vector2d(u1, v1), Eigen::Vector2d(u0, v1)};
    for (std::size_t i = 0; i < 4; ++i) add(line(corners[i], corners[(i + 1) % 4]));
  }

  static ContourCurve line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const Eigen::Vector2d along = to - from;
    return {new Geom2d_Line(gp_Pnt2d(from.x(), from.y()), gp_Dir2d(along.x(), along.y())), 0, along.norm()};
  }

  void add(const ContourCurve& walked) {
    result_.curves.push_back(walked);
    starts_.push_back(to_eigen(walked.curve->Value(walked.first)));
    ends_.push_back(to_eigen(walked.curve->Value(walked.last)));
  }

  void set_extent() {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
    const std::size_t count = result_.curves.size();
    for (const ContourCurve& walked : result_.curves)
      for (int i = 0; i <= 4; ++i) {
        const double t = walked.first + (walked.last - walked.first) * i / 4;
        const Eigen::Vector2d at = to_eigen(walked.curve->Value(t));
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
      }
    extent_ = (high - low).cwiseMax(1e-300);
    next_.assign(count, -1);
    taken_.assign(count, false);
  }

  double distance(std::size_t end, std::size_t start) const {
    return (starts_[start] - ends_[end]).cwiseQuotient(extent_).norm();
  }

  // The next one in the list first, which it mostly is.
  void pair_adjacent() {
    const std::size_t count = next_.size();
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 1; k <= count; ++k) {
        const std::size_t j = (i + k) % count;
        if (taken_[j] || distance(i, j) > adjacent) continue;
        join(i, j);
        break;
      }
  }

  struct Candidate {
    std::size_t end, start;
    double cost;
  };

  // By the shortest lines on the surface, those that lead once around it last.
  void pair_the_rest() {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < next_.size(); ++i)
      for (std::size_t j = 0; j < next_.size(); ++j)
        if (next_[i] < 0 && !taken_[j]) candidates.push_back({i, j, cost(ends_[i], starts_[j])});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    for (const Candidate& pair : candidates)
      if (next_[pair.end] < 0 && !taken_[pair.start]) join(pair.end, pair.start);
  }

  double cost(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    const double length = length_between(from, to), chord = (point(to) - point(from)).norm();
    return chord < 0.01 * length ? 1e6 * length : length;
  }

  Eigen::Vector3d point(const Eigen::Vector2d& uv) const { return to_eigen(surface_.Value(uv.x(), uv.y())); }

  double length_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    constexpr int chords = 8;
    double length = 0;
    Eigen::Vector3d before = point(from);
    for (int i = 1; i <= chords; ++i) {
      const Eigen::Vector3d at = point(from + (to - from) * (double(i) / chords));
      length += (at - before).norm();
      before = at;
    }
    return length;
  }

  void join(std::size_t end, std::size_t start) {
    next_[end] = static_cast<int>(start);
    taken_[start] = true;
    if (distance(end, start) <= identical) return;
    result_.curves.push_back(line(ends_[end], starts_[start]));
    result_.longest_bridge = std::max(result_.longest_bridge, length_between(ends_[end], starts_[start]));
  }

  const TopoDS_Face& face_;
  const GeomAdaptor_Surface& surface_;
  FaceContour result_;
  std::vector<Eigen::Vector2d> starts_, ends_;
  std::vector<int> next_;
  std::vector<bool> taken_;
  Eigen::Vector2d extent_;
};

}  // namespace

FaceContour face_contour(const TopoDS_Face& face, const GeomAdaptor_Surface& surface) {
  return ContourMaker(face, surface).make();
}

}  // namespace isopatch::geometry
