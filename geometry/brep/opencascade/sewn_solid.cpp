#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>

#include <fmt/format.h>

#include "geometry/base/union_find.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/loop_curve.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"
#include "geometry/brep/solid_error.hpp"

namespace isopatch::geometry {
namespace {

// A curve of a loop, with the numbers of the vertices at its ends and of the edge it has become.
struct Piece {
  std::size_t face, loop, index;
  LoopCurve curve;
  std::size_t start = 0, end = 0;
  std::size_t edge = 0;
  bool reversed = false;  // against the edge
  bool taken = false;
};

struct Pair {
  std::size_t first, second;
  CurveMatch match;
};

class Sewer {
 public:
  Sewer(const std::vector<TrimmedSurface>& faces, const SewOptions& options)
      : input_(faces), accept_open_(options.accept_open) {
    const double size = size_of(faces);
    scale_ = kernel_scale(size);
    size_ = scale_ * size;
    tolerance_ = options.same_point * size_;
    curve_tolerance_ = options.same_curve * size_;
    add_pieces();
  }

  KernelSolid make() {
    require_closed_loops();
    make_vertices();
    pair_pieces();
    for (Piece& piece : pieces_)
      if (!piece.taken) add_free(piece);
    std::vector<TopoDS_Face> faces;
    for (std::size_t i = 0; i < input_.size(); ++i) faces.push_back(face(i));
    finish_tolerances();
    ShapeInput input = oriented_solid(std::move(faces), 1 / scale_);
    for (const TrimmedSurface& surface : input_) input.names.push_back(surface.name);
    input.colours.resize(input_.size());
    return {std::make_shared<ShapeKernel>(std::move(input)), "", correction_ / scale_};
  }

 private:
  static double size_of(const std::vector<TrimmedSurface>& faces) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
    for (const TrimmedSurface& face : faces)
      for (const auto& loop : face.loops)
        for (const NurbsCurve& curve : loop)
          for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const double at = curve.low()(0) + t * (curve.high() - curve.low())(0);
            const Eigen::Vector3d p = face.surface.point(curve.point(Parameter<1>(at)).head<2>());
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
          }
    return (high - low).norm();
  }

  void add_pieces() {
    for (std::size_t f = 0; f < input_.size(); ++f) {
      surfaces_.push_back(to_shape(input_[f].surface, scale_));
      for (std::size_t l = 0; l < input_[f].loops.size(); ++l)
        for (std::size_t i = 0; i < input_[f].loops[l].size(); ++i)
          pieces_.push_back({f, l, i, LoopCurve(surfaces_[f], to_domain_curve(input_[f].loops[l][i]))});
    }
  }

  std::string place(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d m = p / scale_;
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", m.x(), m.y(), m.z());
  }
  std::string name(const Piece& piece) const {
    return fmt::format("curve {} of loop {} of face {}, from {} to {} m,", piece.index, piece.loop,
                       piece.face, place(piece.curve.point(0)), place(piece.curve.point(1)));
  }

  // The curve with its face and its ends, and another face if there is one.
  SolidFault fault(const Piece& piece, int other_face = -1) const {
    constexpr int pieces = 24;
    SolidFault::Edge edge{fmt::format("curve {} of loop {} of face {}", piece.index, piece.loop, piece.face),
                          Eigen::Matrix3Xd(3, pieces + 1)};
    for (int i = 0; i <= pieces; ++i) edge.points.col(i) = piece.curve.point(double(i) / pieces) / scale_;
    SolidFault result;
    result.faces.push_back({static_cast<int>(piece.face)});
    if (other_face >= 0) result.faces.push_back({other_face});
    result.points.push_back({"its start", edge.points.col(0)});
    result.points.push_back({"its end", edge.points.col(pieces)});
    result.edges.push_back(std::move(edge));
    return result;
  }

  void require_closed_loops() const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      const Piece& next = following(i);
      if (piece.curve.length() <= tolerance_)
        throw SolidError(ErrorCode::not_manifold, fmt::format("{} has no length; remove it", name(piece)),
                         fault(piece));
      const double gap = (piece.curve.point(1) - next.curve.point(0)).norm();
      if (gap > tolerance_)
        throw SolidError(ErrorCode::invalid_argument,
                         fmt::format("{} ends {:.3g} m away from the start of the next one; loops must close",
                                     name(piece), gap / scale_),
                         fault(piece));
    }
  }

  // The next one of the same loop.
  const Piece& following(std::size_t i) const {
    const Piece& piece = pieces_[i];
    const std::size_t count = input_[piece.face].loops[piece.loop].size();
    return pieces_[i - piece.index + (piece.index + 1) % count];
  }

  // Ends that lie together become one vertex, in their middle.
  void make_vertices() {
    const std::size_t count = 2 * pieces_.size();
    std::vector<Eigen::Vector3d> ends(count);
    for (std::size_t i = 0; i < count; ++i) ends[i] = pieces_[i / 2].curve.point(i % 2 == 0 ? 0 : 1);
    UnionFind together(static_cast<int>(count));
    const auto root = [&](std::size_t i) {
      return static_cast<std::size_t>(together.find(static_cast<int>(i)));
    };
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if ((ends[i] - ends[j]).norm() <= tolerance_)
          together.unite(static_cast<int>(i), static_cast<int>(j));
    std::vector<std::size_t> number(count, 0), members(count, 0);
    std::vector<Eigen::Vector3d> middle(count, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < count; ++i) {
      middle[root(i)] += ends[i];
      ++members[root(i)];
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (root(i) == i) {
        number[i] = vertices_.size();
        TopoDS_Vertex vertex;
        builder_.MakeVertex(vertex, to_point(middle[i] / double(members[i])), 1e-7);
        vertices_.push_back(vertex);
        vertex_tolerance_.push_back(1e-7);
      }
      const std::size_t vertex = number[root(i)];
      (i % 2 == 0 ? pieces_[i / 2].start : pieces_[i / 2].end) = vertex;
      const double moved = (ends[i] - to_eigen(BRep_Tool::Pnt(vertices_[vertex]))).norm();
      vertex_tolerance_[vertex] = std::max(vertex_tolerance_[vertex], 1.01 * moved);
      correction_ = std::max(correction_, moved);
    }
  }

  // Two pieces that agree in space, nearest pairs first.
  void pair_pieces() {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Piece &a = pieces_[j], &b = pieces_[i];
        if (std::minmax(a.start, a.end) != std::minmax(b.start, b.end)) continue;
        const CurveMatch found = match(a.curve, b.curve);
        if (std::max(found.distance, match(b.curve, a.curve).distance) <= curve_tolerance_)
          pairs.push_back({j, i, found});
      }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.match.distance < b.match.distance; });
    for (const Pair& pair : pairs) {
      Piece &a = pieces_[pair.first], &b = pieces_[pair.second];
      if (!a.taken && !b.taken)
        join(a, b, pair.match);
      else if (pair.match.distance <= tolerance_ && !(a.taken && b.taken && a.edge == b.edge) &&
               !accept_open_)
        throw SolidError(
            ErrorCode::not_manifold,
            fmt::format("{} is shared by more than two faces; face {} is one of them", name(a), b.face),
            fault(a, static_cast<int>(b.face)));
    }
  }

  // The edge takes its curve in space from the first piece.
  TopoDS_Edge leading_edge(Piece& piece) {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    const Straightened domain = straightened(piece.curve.curve());
    builder_.UpdateEdge(edge, domain.curve, surfaces_[piece.face], TopLoc_Location(), 1e-7);
    builder_.Range(edge, domain.first, domain.last);
    builder_.Add(edge, vertices_[piece.start].Oriented(TopAbs_FORWARD));
    builder_.Add(edge, vertices_[piece.end].Oriented(TopAbs_REVERSED));
    if (!BRepLib::BuildCurve3d(edge, 1e-8 * size_, GeomAbs_C1, 14, 200))
      throw Error(ErrorCode::unsupported, fmt::format("{} has no curve in space", name(piece)));
    builder_.SameParameter(edge, true);
    builder_.SameRange(edge, true);
    piece.taken = true;
    piece.edge = edges_.size();
    edges_.push_back(edge);
    edge_tolerance_.push_back(std::max(1e-7, BRep_Tool::Tolerance(edge)));
    return edge;
  }

  struct Straightened {
    Handle(Geom2d_Curve) curve;
    double first, last;
  };
  // Lines as lines, by their length, so that they become exact curves of constant parameter.
  static Straightened straightened(const Handle(Geom2d_BSplineCurve) & curve) {
    if (curve->Degree() == 1 && curve->NbPoles() == 2 && !curve->IsRational()) {
      const gp_Vec2d along(curve->Pole(1), curve->Pole(2));
      if (along.Magnitude() > 0)
        return {Handle(Geom2d_Curve)(new Geom2d_Line(curve->Pole(1), gp_Dir2d(along))), 0, along.Magnitude()};
    }
    return {Handle(Geom2d_Curve)(curve), curve->FirstParameter(), curve->LastParameter()};
  }

  void join(Piece& a, Piece& b, const CurveMatch& match) {
    const TopoDS_Edge edge = leading_edge(a);
    double first = 0, last = 0;
    BRep_Tool::Range(edge, first, last);
    const FollowingCurve other = follow(a.curve, b.curve, match, first, last, 1e-8 * size_);
    if (a.face == b.face) {
      // A seam: both curves at once, the second for the reversed edge.
      const auto leading = straightened(a.curve.curve()).curve;
      builder_.UpdateEdge(edge, leading, other.curve, surfaces_[a.face], TopLoc_Location(), 1e-7);
    } else {
      builder_.UpdateEdge(edge, other.curve, surfaces_[b.face], TopLoc_Location(), 1e-7);
    }
    builder_.Range(edge, first, last);
    b.taken = true;
    b.edge = a.edge;
    b.reversed = match.reversed;
    correction_ = std::max(correction_, other.distance);
    edge_tolerance_[a.edge] = std::max(edge_tolerance_[a.edge], 1.1 * other.distance);
  }

  void add_free(Piece& piece) {
    if (!accept_open_)
      throw SolidError(
          ErrorCode::not_manifold,
          fmt::format("{} belongs to one face only{}; the faces must close up to {:.3g} m at "
                      "corners and {:.3g} m along edges",
                      name(piece), nearest_text(piece), tolerance_ / scale_, curve_tolerance_ / scale_),
          fault(piece));
    leading_edge(piece);
  }

  std::string nearest_text(const Piece& piece) const {
    const Piece* nearest = nullptr;
    double best = 0;
    for (const Piece& other : pieces_) {
      if (&other == &piece || other.face == piece.face) continue;
      const double distance = match(piece.curve, other.curve).distance;
      if (nearest == nullptr || distance < best) nearest = &other, best = distance;
    }
    if (nearest == nullptr) return "";
    return fmt::format(" (the nearest is curve {} of face {}, {:.3g} m away)", nearest->index, nearest->face,
                       best / scale_);
  }

  static double signed_area(const std::vector<const Piece*>& loop) {
    double sum = 0;
    Eigen::Vector2d before = loop.back()->curve.domain_point(1);
    for (const Piece* piece : loop)
      for (int i = 0; i <= 16; ++i) {
        const Eigen::Vector2d at = piece->curve.domain_point(i / 16.0);
        sum += before.x() * at.y() - before.y() * at.x();
        before = at;
      }
    return sum / 2;
  }

  TopoDS_Face face(std::size_t index) {
    std::vector<std::vector<const Piece*>> loops(input_[index].loops.size());
    for (const Piece& piece : pieces_)
      if (piece.face == index) loops[piece.loop].push_back(&piece);
    std::erase_if(loops, [](const auto& loop) { return loop.empty(); });
    if (loops.empty()) throw Error(ErrorCode::invalid_argument, fmt::format("face {} has no loop", index));
    std::vector<double> areas;
    for (const auto& loop : loops) areas.push_back(signed_area(loop));
    const auto outer = static_cast<std::size_t>(
        std::max_element(areas.begin(), areas.end(),
                         [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        areas.begin());
    TopoDS_Face result;
    builder_.MakeFace(result, surfaces_[index], 1e-7);
    builder_.Add(result, wire(loops[outer], areas[outer] > 0));
    for (std::size_t l = 0; l < loops.size(); ++l)
      if (l != outer) builder_.Add(result, wire(loops[l], areas[l] < 0));
    return result;
  }

  TopoDS_Wire wire(std::vector<const Piece*> loop, bool as_it_is) const {
    if (!as_it_is) std::reverse(loop.begin(), loop.end());
    TopoDS_Wire result;
    builder_.MakeWire(result);
    for (const Piece* piece : loop)
      builder_.Add(result, edges_[piece->edge].Oriented(piece->reversed == as_it_is ? TopAbs_REVERSED
                                                                                    : TopAbs_FORWARD));
    return result;
  }

  // A vertex's ball holds those of its edges' ends.
  void finish_tolerances() {
    for (const Piece& piece : pieces_)
      for (const std::size_t vertex : {piece.start, piece.end})
        vertex_tolerance_[vertex] = std::max(vertex_tolerance_[vertex], edge_tolerance_[piece.edge]);
    for (std::size_t i = 0; i < edges_.size(); ++i) builder_.UpdateEdge(edges_[i], edge_tolerance_[i]);
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      builder_.UpdateVertex(vertices_[i], vertex_tolerance_[i]);
  }

  const std::vector<TrimmedSurface>& input_;
  const bool accept_open_;
  BRep_Builder builder_;
  double scale_ = 1, size_ = 0, tolerance_ = 0, curve_tolerance_ = 0, correction_ = 0;  // units of the shape
  std::vector<Handle(Geom_BSplineSurface)> surfaces_;
  std::vector<Piece> pieces_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<double> vertex_tolerance_;
  std::vector<TopoDS_Edge> edges_;
  std::vector<double> edge_tolerance_;
};

}  // namespace

KernelSolid sewn_solid(const std::vector<TrimmedSurface>& faces, const SewOptions& options) {
  return Sewer(faces, options).make();
}

}  // namespace isopatch::geometry
