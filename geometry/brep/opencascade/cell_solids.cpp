#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

/// The curve of an edge in space or in a domain, with its parameters at t = 0 and t = 1.
template <class Curve>
struct Ranged {
  Curve curve;
  double first = 0, last = 1;
  double at(double t) const { return first + t * (last - first); }
};
using SpaceRange = Ranged<Handle(Geom_Curve)>;
using DomainRange = Ranged<Handle(Geom2d_Curve)>;

/// Makes each vertex, edge and face of a complex once, when a cell needs it; units of the source's shape.
class CellMaker {
 public:
  CellMaker(const ShapeKernel& source, const CellComplex& complex)
      : source_(source), complex_(complex), metres_(source.input().metres) {}

  KernelSolid make(CellId id) {
    std::vector<TopoDS_Face> faces;
    std::vector<std::string> names;
    std::vector<std::optional<Colour>> colours;
    std::set<VertexId> used;
    for (const CellFaceUse& use : complex_.cell(id).faces) {
      faces.push_back(face(use.face));
      const std::optional<FaceId> origin = complex_.face(use.face).origin;
      const BrepFace* named =
          origin ? &source_.tables().faces[static_cast<std::size_t>(origin->value)] : nullptr;
      names.push_back(!named                ? ""
                      : named->name.empty() ? fmt::format("face {}", origin->value)
                                            : named->name);
      colours.push_back(named ? named->colour : std::nullopt);
      for (const EdgeUse& edge : complex_.face(use.face).loop) used.insert(complex_.from(edge));
    }
    ShapeInput input = oriented_solid(std::move(faces), metres_);
    for (const VertexId v : used) input.vertices.push_back(vertex(v));
    input.names = std::move(names);
    input.colours = std::move(colours);
    return {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
  }

 private:
  TopoDS_Vertex vertex(VertexId id) {
    TopoDS_Vertex& made = vertices_[id];
    if (made.IsNull()) builder_.MakeVertex(made, to_point(complex_.vertex(id) / metres_), 1e-7);
    return made;
  }

  SpaceRange space_range(const CellCurve& curve) const {
    if (const auto* source = std::get_if<EdgeId>(&curve.shape)) {
      const EdgeGeometry& edge = source_.of(*source);
      return {edge.curve, edge.first, edge.last};
    }
    return {to_shape(std::get<NurbsCurve>(curve.shape), 1 / metres_)};
  }

  /// Nothing on planes, whose domain curves the library makes itself.
  std::optional<DomainRange> domain_range(const CellCurve& curve, SurfaceId surface,
                                          const SpaceRange& space) const {
    for (const CellCurve::Trace& trace : curve.traces)
      if (trace.surface == surface)
        return DomainRange{to_domain_curve(over(trace.domain, space.first, space.last)), space.first,
                           space.last};
    const auto* edge = std::get_if<EdgeId>(&curve.shape);
    const auto* face = std::get_if<FaceId>(&complex_.surface(surface));
    if (edge != nullptr && face != nullptr)
      for (const auto& [use, found] : source_.of(*face).uses)
        if (use.edge == *edge) return DomainRange{found.curve, found.first, found.last};
    return std::nullopt;
  }

  static NurbsCurve over(const NurbsCurve& curve, double first, double last) {
    return NurbsCurve({rescaled(curve.knots(0), first, last)}, curve.control_points(), curve.weights());
  }

  Handle(Geom_Surface) surface(SurfaceId id) {
    Handle(Geom_Surface)& made = surfaces_[id];
    if (!made.IsNull()) return made;
    const CellSurface& given = complex_.surface(id);
    if (const auto* face = std::get_if<FaceId>(&given)) {
      made = source_.of(*face).surface;
    } else if (const auto* plane = std::get_if<PlaneSurface>(&given)) {
      const Eigen::Vector3d normal = plane->normal();
      made =
          new Geom_Plane(gp_Ax3(to_point(plane->origin / metres_), direction(normal), direction(plane->x)));
    } else {
      made = to_shape(std::get<NurbsSurface>(given), 1 / metres_);
    }
    return made;
  }

  static gp_Dir direction(const Eigen::Vector3d& d) { return {d.x(), d.y(), d.z()}; }

  TopoDS_Edge edge(EdgeId id) {
    TopoDS_Edge& made = edges_[id];
    if (!made.IsNull()) return made;
    const CellEdge& edge = complex_.edge(id);
    const SpaceRange range = space_range(complex_.curve(edge.curve));
    builder_.MakeEdge(made, range.curve, 1e-7);
    builder_.Add(made, vertex(edge.start).Oriented(TopAbs_FORWARD));
    builder_.Add(made, vertex(edge.end).Oriented(TopAbs_REVERSED));
    builder_.Range(made, range.at(edge.low), range.at(edge.high));
    allow(made, edge.start, range.curve->Value(range.at(edge.low)));
    allow(made, edge.end, range.curve->Value(range.at(edge.high)));
    return made;
  }

  /// A vertex' ball holds the end of the edge.
  void allow(const TopoDS_Edge& edge, VertexId at, const gp_Pnt& end) {
    const TopoDS_Vertex known = vertex(at);
    builder_.UpdateVertex(known,
                          std::max(1.01 * end.Distance(BRep_Tool::Pnt(known)), BRep_Tool::Tolerance(edge)));
  }

  /// Gives an edge its curve in the domain of a surface, and the tolerance that it then needs.
  void trace(const TopoDS_Edge& made, const CellEdge& edge, SurfaceId on) {
    const CellCurve& curve = complex_.curve(edge.curve);
    const Handle(Geom_Surface) carrier = surface(on);
    const SpaceRange space = space_range(curve);
    const std::optional<DomainRange> domain = domain_range(curve, on, space);
    double off = 0;
    if (domain) {
      if (std::abs(domain->first - space.first) + std::abs(domain->last - space.last) >
          1e-9 * (1 + std::abs(space.last - space.first)))
        throw Error(ErrorCode::unsupported,
                    fmt::format("a curve in the domain of a surface runs at another pace than "
                                "the edge in space; let the CAD program repair the solid"));
      constexpr int samples = 16;
      for (int i = 0; i <= samples; ++i) {
        const double t = edge.low + (edge.high - edge.low) * i / samples;
        const gp_Pnt2d uv = domain->curve->Value(domain->at(t));
        off = std::max(off, carrier->Value(uv.X(), uv.Y()).Distance(space.curve->Value(space.at(t))));
      }
      const double tolerance = std::max(1e-7, 1.1 * off);
      builder_.UpdateEdge(made, domain->curve, carrier, TopLoc_Location(), tolerance);
      builder_.Range(made, space.at(edge.low), space.at(edge.high));
    } else if (Handle(Geom_Plane)::DownCast(carrier).IsNull()) {
      throw Error(ErrorCode::internal, "an edge has no curve in the domain of its face");
    }
    for (const VertexId end : {edge.start, edge.end})
      builder_.UpdateVertex(vertex(end), BRep_Tool::Tolerance(made));
  }

  /// Its normal as the surface has it.
  TopoDS_Face face(FaceId id) {
    TopoDS_Face& made = faces_[id];
    if (!made.IsNull()) return made;
    const CellFace& face = complex_.face(id);
    builder_.MakeFace(made, surface(face.surface), 1e-7);
    const auto* origin = std::get_if<FaceId>(&complex_.surface(face.surface));
    const bool turned =
        origin != nullptr && source_.tables().faces[static_cast<std::size_t>(origin->value)].reversed;
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    std::vector<EdgeUse> loop = face.loop;
    if (turned) std::reverse(loop.begin(), loop.end());
    for (const EdgeUse& use : loop) {
      const TopoDS_Edge side = edge(use.edge);
      trace(side, complex_.edge(use.edge), face.surface);
      builder_.Add(wire, side.Oriented(use.reversed == turned ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
    wire.Closed(true);
    builder_.Add(made, wire);
    return made;
  }

  const ShapeKernel& source_;
  const CellComplex& complex_;
  double metres_;
  BRep_Builder builder_;
  std::map<VertexId, TopoDS_Vertex> vertices_;
  std::map<EdgeId, TopoDS_Edge> edges_;
  std::map<FaceId, TopoDS_Face> faces_;
  std::map<SurfaceId, Handle(Geom_Surface)> surfaces_;
};

}  // namespace

std::vector<KernelSolid> solids_of_cells(const ShapeKernel& source, const CellComplex& complex,
                                         const std::vector<CellId>& cells) {
  CellMaker maker(source, complex);
  std::vector<KernelSolid> result;
  result.reserve(cells.size());
  for (const CellId cell : cells) result.push_back(maker.make(cell));
  return result;
}

}  // namespace isopatch::geometry
