#include <BOPAlgo_Builder.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

// Of the size: narrow sides are longer.
constexpr double farthest_end = 1e-6;

class Overlayer {
 public:
  Overlayer(const ShapeKernel& source, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
            const Redrawn& redrawn, const std::vector<std::array<Eigen::Vector3d, 2>>& lines)
      : source_(source),
        metres_(source.input().metres),
        origin_(origin / metres_),
        direction_(direction),
        redrawn_(redrawn),
        lines_(lines),
        plane_(to_point(origin_), gp_Dir(direction.x(), direction.y(), direction.z())) {}

  KernelOverlay make(const std::vector<FaceId>& faces) {
    std::vector<TopoDS_Shape> flat;
    flat.reserve(faces.size());
    for (const FaceId face : faces) flat.push_back(pushed(face));
    if (flat.size() == 1 && lines_.empty())  // nothing to be laid over it, which the builder refuses
      return sheet_of(flat.front(), flat, [](const TopoDS_Shape&) { return TopTools_ListOfShape(); });
    BOPAlgo_Builder builder;
    for (const TopoDS_Shape& face : flat) builder.AddArgument(face);
    for (const auto& ends : lines_) builder.AddArgument(line(ends));
    const auto& box = source_.tables().box;
    builder.SetFuzzyValue(1e-7 * (box[1] - box[0]).norm() / metres_);
    builder.SetRunParallel(false);
    builder.Perform();
    if (builder.HasErrors()) fail();
    return sheet_of(builder.Shape(), flat, [&](const TopoDS_Shape& face) { return builder.Modified(face); });
  }

 private:
  [[noreturn]] static void fail() {
    throw Error(ErrorCode::unsupported, "outlines cannot be laid over each other by the CAD library");
  }

  TopoDS_Edge edge(EdgeId id) {
    if (const auto known = edges_.find(id); known != edges_.end()) return known->second;
    const auto other = redrawn_.find(id);
    return edges_[id] = other == redrawn_.end() ? pushed_edge(id, {Eigen::Vector3d::Zero(), 1})
                                                : redrawn(id, other->second);
  }

  TopoDS_Edge pushed_edge(EdgeId id, const Scaled& scaled) const {
    const EdgeGeometry& source = source_.of(id);
    const Eigen::Vector3d at = to_eigen(source.curve->Value(source.first));
    const Eigen::Vector3d by = (origin_ - at).dot(direction_) * direction_;
    Handle(Geom_Curve) curve =
        Handle(Geom_Curve)::DownCast(source.curve->Translated(gp_Vec(by.x(), by.y(), by.z())));
    if (scaled.factor != 1) curve->Scale(to_point(scaled.centre / metres_), scaled.factor);
    if (const Handle(Geom_Circle) circle = Handle(Geom_Circle)::DownCast(curve);
        !circle.IsNull() && std::abs(std::abs(source.last - source.first) - 2 * M_PI) < 1e-9)
      begin_at_a_line(circle);
    BRepBuilderAPI_MakeEdge maker(curve, std::min(source.first, source.last),
                                  std::max(source.first, source.last));
    if (!maker.IsDone()) fail();
    const BRep_Builder shapes;
    const double near = joined(source.edge);
    for (const TopoDS_Vertex& end : {maker.Vertex1(), maker.Vertex2()}) shapes.UpdateVertex(end, near);
    return TopoDS::Edge(source.first < source.last ? maker.Shape() : maker.Shape().Reversed());
  }

  /// Ends of neighbouring edges are one vertex within this: a wire leaves out what does not begin where the
  /// last one ended, and reports success.
  double joined() const { return share_of_size(2e-7); }
  /// Where edges of the solid end farther from their vertices, as lines and arcs that touch within the
  /// tolerance of a reconstruction do.
  double joined(const TopoDS_Edge& source) const {
    double farthest = 0;
    for (TopExp_Explorer vertex(source, TopAbs_VERTEX); vertex.More(); vertex.Next())
      farthest = std::max(farthest, BRep_Tool::Tolerance(TopoDS::Vertex(vertex.Current())));
    return std::clamp(farthest, joined(), share_of_size(farthest_end));
  }
  double share_of_size(double share) const {
    const auto& box = source_.tables().box;
    return share * (box[1] - box[0]).norm() / metres_;
  }

  /// A whole circle has a vertex where it begins, which must be none but where a line ends or crosses it.
  void begin_at_a_line(const Handle(Geom_Circle) & circle) const {
    const gp_Ax2 frame = circle->Position();
    const Eigen::Vector3d centre = to_eigen(frame.Location());
    const double radius = circle->Radius();
    for (const auto& line : lines_) {
      const Eigen::Vector3d start = line[0] / metres_, way = line[1] / metres_ - start;
      const double length = way.norm(), middle = (centre - start).dot(way) / length;
      const double half = radius * radius - (start + middle / length * way - centre).squaredNorm();
      for (const double side : {-1.0, 1.0}) {
        const double at = middle + side * std::sqrt(std::max(0.0, half));
        const Eigen::Vector3d point = start + std::clamp(at, 0.0, length) / length * way;
        if (std::abs((point - centre).norm() - radius) > 1e-7 * radius) continue;
        circle->SetPosition(
            gp_Ax2(frame.Location(), frame.Direction(), gp_Vec(frame.Location(), to_point(point))));
        return;
      }
    }
  }

  TopoDS_Edge redrawn(EdgeId id, const Redrawn::mapped_type& as) {
    if (const auto* scaled = std::get_if<Scaled>(&as)) return pushed_edge(id, *scaled);
    if (const auto* use = std::get_if<EdgeUse>(&as)) {
      const TopoDS_Edge other = edge(use->edge);
      return use->reversed ? TopoDS::Edge(other.Reversed()) : other;
    }
    return line(std::get<std::array<Eigen::Vector3d, 2>>(as));
  }

  TopoDS_Edge line(const std::array<Eigen::Vector3d, 2>& ends) const {
    BRepBuilderAPI_MakeEdge maker(to_point(ends[0] / metres_), to_point(ends[1] / metres_));
    if (!maker.IsDone()) fail();
    return maker.Edge();
  }

  TopoDS_Wire wire(std::vector<EdgeUse> loop, bool turned) {
    if (turned) std::reverse(loop.begin(), loop.end());
    for (EdgeUse& use : loop) use.reversed = use.reversed != turned;
    BRepBuilderAPI_MakeWire maker;
    for (const std::vector<EdgeUse>& group : without_ends_of_seams(std::move(loop))) {
      const TopoDS_Edge made = group.size() > 1 ? arc_over(group) : edge(group.front().edge);
      maker.Add(group.size() > 1 || !group.front().reversed ? made : TopoDS::Edge(made.Reversed()));
      // The next edge that can be added takes an error back (findings/occt_make_wire_loses_edge.sh).
      if (maker.Error() != BRepBuilderAPI_WireDone) fail();
    }
    if (!maker.IsDone()) fail();
    return maker.Wire();
  }

  VertexId from(const EdgeUse& use) const {
    const BrepEdge& edge = source_.tables().edges[static_cast<std::size_t>(use.edge.value)];
    return use.reversed ? edge.end : edge.start;
  }
  VertexId to(const EdgeUse& use) const { return from({use.edge, !use.reversed}); }

  /// Whether two arcs are one but for the seam of the wall that they bound, which is no edge to be seen.
  bool goes_on(const EdgeUse& one, const EdgeUse& next) const {
    const auto& edges = source_.tables().edges;
    const BrepEdge &a = edges[static_cast<std::size_t>(one.edge.value)],
                   &b = edges[static_cast<std::size_t>(next.edge.value)];
    const VertexId between = to(one);
    if (one.edge == next.edge || between != from(next) || a.kind != CurveKind::circle ||
        b.kind != CurveKind::circle || redrawn_.contains(one.edge) || redrawn_.contains(next.edge) ||
        !std::is_permutation(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end()))
      return false;
    bool any = false;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const BrepEdge& edge = edges[static_cast<std::size_t>(e)];
      if (EdgeId(e) == one.edge || EdgeId(e) == next.edge || (edge.start != between && edge.end != between))
        continue;
      if (edge.faces.size() != 2 || edge.faces[0] != edge.faces[1]) return false;
      any = true;
    }
    const Handle(Geom_Circle) first = Handle(Geom_Circle)::DownCast(source_.of(one.edge).curve);
    const Handle(Geom_Circle) second = Handle(Geom_Circle)::DownCast(source_.of(next.edge).curve);
    return any && !first.IsNull() && !second.IsNull() &&
           first->Location().Distance(second->Location()) < 1e-7 * first->Radius() &&
           std::abs(first->Radius() - second->Radius()) < 1e-7 * first->Radius();
  }

  /// Arcs that go on in one another together; all others alone.
  std::vector<std::vector<EdgeUse>> without_ends_of_seams(std::vector<EdgeUse> loop) const {
    for (std::size_t i = 0; i < loop.size() && goes_on(loop.back(), loop.front()); ++i)
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    std::vector<std::vector<EdgeUse>> result;
    for (const EdgeUse& use : loop) {
      if (!result.empty() && goes_on(result.back().back(), use) && from(result.back().front()) != to(use))
        result.back().push_back(use);
      else
        result.push_back({use});
    }
    return result;
  }

  /// As the arcs run.
  TopoDS_Edge arc_over(const std::vector<EdgeUse>& arcs) {
    const EdgeGeometry& source = source_.of(arcs.front().edge);
    const bool forwards = (source.first < source.last) != arcs.front().reversed;
    const Eigen::Vector3d by =
        (origin_ - to_eigen(source.curve->Value(source.first))).dot(direction_) * direction_;
    const Handle(Geom_Circle) circle =
        Handle(Geom_Circle)::DownCast(source.curve->Translated(gp_Vec(by.x(), by.y(), by.z())));
    const auto place = [&](VertexId vertex) {
      return to_point(source_.tables().vertices.col(vertex.value) / metres_ + by);
    };
    const gp_Pnt start = place(from(arcs.front())), end = place(to(arcs.back()));
    BRepBuilderAPI_MakeEdge maker(circle, forwards ? start : end, forwards ? end : start);
    if (!maker.IsDone()) fail();
    const BRep_Builder shapes;
    const double near = joined(source.edge);
    for (const TopoDS_Vertex& vertex : {maker.Vertex1(), maker.Vertex2()}) shapes.UpdateVertex(vertex, near);
    return forwards ? maker.Edge() : TopoDS::Edge(maker.Edge().Reversed());
  }

  /// A loop that runs through an edge twice is as many as are left without it; the longest comes first.
  std::vector<std::vector<EdgeUse>> without_seams(const std::vector<std::vector<EdgeUse>>& loops) const {
    const auto& edges = source_.tables().edges;
    std::vector<std::vector<EdgeUse>> result;
    for (const auto& loop : loops) {
      std::vector<EdgeUse> left;
      for (const EdgeUse& use : loop)
        if (std::count_if(loop.begin(), loop.end(),
                          [&](const EdgeUse& other) { return other.edge == use.edge; }) == 1)
          left.push_back(use);
      if (left.size() == loop.size()) {
        result.push_back(loop);
        continue;
      }
      while (!left.empty()) {
        std::vector<EdgeUse> chain = {left.front()};
        left.erase(left.begin());
        for (auto next = left.begin(); to(chain.back()) != from(chain.front()) && next != left.end();) {
          next = std::find_if(left.begin(), left.end(),
                              [&](const EdgeUse& use) { return from(use) == to(chain.back()); });
          if (next == left.end()) fail();
          chain.push_back(*next);
          left.erase(next);
          next = left.begin();
        }
        result.push_back(std::move(chain));
      }
    }
    const auto length = [&](const std::vector<EdgeUse>& loop) {
      double sum = 0;
      for (const EdgeUse& use : loop) sum += edges[static_cast<std::size_t>(use.edge.value)].length;
      return sum;
    };
    if (result.size() != loops.size())
      std::stable_sort(result.begin(), result.end(),
                       [&](const auto& a, const auto& b) { return length(a) > length(b); });
    return result;
  }

  /// Into the plane, looking along the direction.
  TopoDS_Face pushed(FaceId id) {
    const BrepFace& face = source_.tables().faces[static_cast<std::size_t>(id.value)];
    const DomainBox domain = source_.domain(id);
    const Eigen::Matrix<double, 3, 2> tangents = source_.derivatives(id, domain.low);
    const bool along = tangents.col(0).cross(tangents.col(1)).dot(direction_) > 0;
    const bool turned = along == face.reversed;  // its outside looks against the direction
    const std::vector<std::vector<EdgeUse>> loops = without_seams(face.loops);
    BRepBuilderAPI_MakeFace maker(plane_, wire(loops.front(), turned));
    for (std::size_t i = 1; i < loops.size(); ++i) maker.Add(wire(loops[i], turned));
    if (!maker.IsDone()) fail();
    return maker.Face();
  }

  /// @param images  of a face of `flat`; none where it is as it was
  template <class Images>
  KernelOverlay sheet_of(const TopoDS_Shape& made, const std::vector<TopoDS_Shape>& flat,
                         const Images& images_of) const {
    TopTools_IndexedMapOfShape found;
    ShapeInput input;
    input.metres = metres_;
    const BRep_Builder shapes;
    TopoDS_Shell shell;
    shapes.MakeShell(shell);
    for (TopExp_Explorer it(made, TopAbs_FACE); it.More(); it.Next()) {
      if (found.Contains(it.Current())) continue;
      found.Add(it.Current());
      const TopoDS_Face face = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
      shapes.Add(shell, face);
      input.faces.push_back(face);
    }
    input.shape = shell;
    KernelOverlay result{nullptr, std::vector<std::vector<int>>(input.faces.size())};
    for (std::size_t i = 0; i < flat.size(); ++i) {
      TopTools_ListOfShape images = images_of(flat[i]);
      if (images.IsEmpty()) images.Append(flat[i]);
      for (const TopoDS_Shape& image : images)
        if (const int number = found.FindIndex(image); number > 0)
          result.covered_by[static_cast<std::size_t>(number - 1)].push_back(static_cast<int>(i));
    }
    result.sheet = std::make_shared<ShapeKernel>(std::move(input));
    return result;
  }

  const ShapeKernel& source_;
  double metres_;
  Eigen::Vector3d origin_, direction_;
  const Redrawn& redrawn_;
  const std::vector<std::array<Eigen::Vector3d, 2>>& lines_;
  gp_Pln plane_;
  std::map<EdgeId, TopoDS_Edge> edges_;
};

}  // namespace

KernelOverlay overlay_of(const ShapeKernel& source, const std::vector<FaceId>& faces,
                         const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                         const Redrawn& redrawn, const std::vector<std::array<Eigen::Vector3d, 2>>& lines) {
  return Overlayer(source, origin, direction, redrawn, lines).make(faces);
}

}  // namespace isopatch::geometry
