#include "segmentation/pieces/joined_complex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CurveId;
using geometry::EdgeUse;
using geometry::NurbsCurve;
using geometry::SurfaceId;

class Joiner {
 public:
  explicit Joiner(double tolerance) : tolerance_(tolerance) {}

  void add(const ComplexOfPiece& piece) {
    const CellComplex& part = piece.complex;
    const auto first_surface = static_cast<int>(result_.surfaces.size());
    result_.surfaces.insert(result_.surfaces.end(), part.surfaces.begin(), part.surfaces.end());
    const auto surface = [&](SurfaceId id) { return SurfaceId(first_surface + id.value); };
    std::vector<VertexId> vertices;
    for (const Eigen::Vector3d& place : part.vertices) vertices.push_back(vertex(place));
    std::vector<EdgeUse> edges;
    for (const geometry::CellEdge& edge : part.edges) {
      geometry::CellCurve curve = part.curve(edge.curve);
      for (geometry::CellCurve::Trace& trace : curve.traces) trace.surface = surface(trace.surface);
      edges.push_back(this->edge(std::move(curve), vertices[static_cast<std::size_t>(edge.start.value)],
                                 vertices[static_cast<std::size_t>(edge.end.value)]));
    }
    std::vector<geometry::CellFaceUse> faces;
    for (const geometry::CellFace& face : part.faces) {
      geometry::CellFace made{surface(face.surface), {}, {}};
      if (face.origin) made.origin = piece.origin[static_cast<std::size_t>(face.origin->value)];
      for (const EdgeUse& use : face.loop) {
        const EdgeUse& joined = edges[static_cast<std::size_t>(use.edge.value)];
        made.loop.push_back({joined.edge, joined.reversed != use.reversed});
      }
      faces.push_back(this->face(std::move(made), face.origin.has_value()));
    }
    for (geometry::Cell cell : part.cells) {
      for (geometry::CellFaceUse& use : cell.faces) {
        const geometry::CellFaceUse& joined = faces[static_cast<std::size_t>(use.face.value)];
        use.face = joined.face;
        use.reversed = use.reversed != joined.reversed;
      }
      result_.cells.push_back(std::move(cell));
    }
  }

  CellComplex make(CutSides sides) {
    if (sides == CutSides::in_parts) open_.clear();
    for (const auto& [edges, face] : open_) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const EdgeUse& use : result_.face(face).loop)
        middle += result_.vertex(result_.from(use)) / static_cast<double>(result_.face(face).loop.size());
      throw Error(ErrorCode::unsupported,
                  fmt::format("its pieces do not meet side to side at ({:.6g}, {:.6g}, {:.6g}) m", middle.x(),
                              middle.y(), middle.z()));
    }
    return std::move(result_);
  }

 private:
  VertexId vertex(const Eigen::Vector3d& place) {
    for (std::size_t v = 0; v < result_.vertices.size(); ++v)
      if ((result_.vertices[v] - place).norm() < tolerance_) return VertexId(static_cast<int>(v));
    return result_.add_vertex(place);
  }

  static Eigen::Vector3d middle(const geometry::CellCurve& curve) {
    return std::get<NurbsCurve>(curve.shape).point(Eigen::Matrix<double, 1, 1>(0.5));
  }

  /// The one with these ends and that middle, used as the given curve runs.
  EdgeUse edge(geometry::CellCurve curve, VertexId start, VertexId end) {
    std::vector<EdgeId>& known = edges_[std::minmax(start.value, end.value)];
    for (const EdgeId id : known) {
      geometry::CellCurve& other = result_.curves[static_cast<std::size_t>(result_.edge(id).curve.value)];
      if ((middle(other) - middle(curve)).norm() > tolerance_) continue;
      const bool reversed = result_.edge(id).start != start;
      for (geometry::CellCurve::Trace& trace : curve.traces) {
        if (reversed) trace.domain = geometry::reversed(trace.domain, 0);
        other.traces.push_back(std::move(trace));
      }
      return {id, reversed};
    }
    known.push_back(result_.add_edge(std::move(curve), start, end));
    return {known.back(), false};
  }

  /// The one of the other side, if it is there; used as the given one looks.
  geometry::CellFaceUse face(geometry::CellFace made, bool outer) {
    std::vector<EdgeId> key;
    for (const EdgeUse& use : made.loop) key.push_back(use.edge);
    std::sort(key.begin(), key.end());
    if (const auto other = open_.find(key); other != open_.end()) {
      const FaceId face = other->second;
      open_.erase(other);
      return {face, true};
    }
    const bool open = outer && !made.origin;
    const FaceId fresh = result_.add_face(std::move(made));
    if (open) open_[key] = fresh;
    return {fresh, false};
  }

  double tolerance_;
  CellComplex result_;
  std::map<std::pair<int, int>, std::vector<EdgeId>> edges_;  // by vertices
  std::map<std::vector<EdgeId>, FaceId> open_;                // sides of cuts that wait for another piece
};

}  // namespace

CellComplex joined_complex(const std::vector<ComplexOfPiece>& pieces, double tolerance, CutSides sides) {
  Joiner joiner(tolerance);
  for (const ComplexOfPiece& piece : pieces) joiner.add(piece);
  return joiner.make(sides);
}

}  // namespace isopatch::segmentation
