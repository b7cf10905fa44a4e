#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/brep/opencascade/internal/carrier_forms.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/domain_curve.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

constexpr double least_tolerance = 1e-7;

bool is_disguise(SurfaceKind kind) {
  return kind == SurfaceKind::spline || kind == SurfaceKind::other;
}

/// Makes a solid anew, edge by edge and face by face, with the forms that were found.
class CarrierMaker {
 public:
  CarrierMaker(const ShapeKernel& source, double tolerance)
      : source_(source), tolerance_(tolerance / source.input().metres) {}

  KernelSolid make() {
    const std::size_t count = source_.tables().faces.size();
    forms_.resize(count);
    bool any = false;
    for (std::size_t f = 0; f < count; ++f) {
      if (!is_disguise(source_.tables().faces[f].kind)) continue;
      const FaceGeometry& face = source_.of(FaceId(static_cast<int>(f)));
      forms_[f] = surface_form(face.surface, within(*face.surface, face.domain), tolerance_);
      any = any || forms_[f];
    }
    if (!any) return {};
    make_edges();
    ShapeInput input;
    for (std::size_t f = 0; f < count; ++f) {
      input.faces.push_back(face(f));
      faces_.Bind(source_.input().faces[f], input.faces.back());
    }
    finish(input);
    return {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
  }

 private:
  static DomainBox within(const Geom_Surface& surface, DomainBox box) {
    Eigen::Vector2d low, high;
    surface.Bounds(low.x(), high.x(), low.y(), high.y());
    if (!surface.IsUPeriodic()) {
      box.low.x() = std::max(box.low.x(), low.x());
      box.high.x() = std::min(box.high.x(), high.x());
    }
    if (!surface.IsVPeriodic()) {
      box.low.y() = std::max(box.low.y(), low.y());
      box.high.y() = std::min(box.high.y(), high.y());
    }
    return box;
  }

  /// Edges between faces of known surfaces may be lines and conics; the others keep their curves, which are
  /// those of their splines.
  void make_edges() {
    const BrepTables& tables = source_.tables();
    for (std::size_t e = 0; e < tables.edges.size(); ++e) {
      const EdgeGeometry& geometry = source_.of(EdgeId(static_cast<int>(e)));
      CurveForm form{geometry.curve, geometry.first, geometry.last, [](double t) { return t; }};
      const CurveKind kind = tables.edges[e].kind;
      const auto& faces = tables.edges[e].faces;
      const bool known = std::all_of(faces.begin(), faces.end(), [&](FaceId f) {
        const auto at = static_cast<std::size_t>(f.value);
        return forms_[at] || !is_disguise(tables.faces[at].kind);
      });
      if (known && (kind == CurveKind::spline || kind == CurveKind::other))
        if (auto found = curve_form(geometry.curve, geometry.first, geometry.last, tolerance_))
          form = std::move(*found);
      TopoDS_Edge made;
      builder_.MakeEdge(made, form.curve, std::max(least_tolerance, BRep_Tool::Tolerance(geometry.edge)));
      builder_.Range(made, form.first, form.last);
      add_vertices(made, geometry.edge);
      edges_.Bind(geometry.edge, made);
      edge_forms_.push_back(std::move(form));
    }
  }

  void add_vertices(TopoDS_Edge& made, const TopoDS_Edge& edge) {
    builder_.Add(made, copy_of(TopExp::FirstVertex(edge)).Oriented(TopAbs_FORWARD));
    builder_.Add(made, copy_of(TopExp::LastVertex(edge)).Oriented(TopAbs_REVERSED));
  }

  TopoDS_Vertex copy_of(const TopoDS_Vertex& vertex) {
    if (!vertices_.IsBound(vertex)) {
      TopoDS_Vertex made;
      builder_.MakeVertex(made, BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex));
      vertices_.Bind(vertex, made);
    }
    return TopoDS::Vertex(vertices_.Find(vertex));
  }

  TopoDS_Face face(std::size_t index) {
    const TopoDS_Face& given = source_.input().faces[index];
    const FaceGeometry& geometry = source_.of(FaceId(static_cast<int>(index)));
    const std::optional<SurfaceForm>& form = forms_[index];
    const bool turned = form && form->turned;
    TopoDS_Face made;
    builder_.MakeFace(made, form ? form->surface : geometry.surface, BRep_Tool::Tolerance(given));
    for (TopoDS_Iterator it(geometry.face); it.More(); it.Next()) {
      if (it.Value().ShapeType() != TopAbs_WIRE) continue;
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      std::vector<TopoDS_Edge> walked;
      for (TopoDS_Iterator edge(it.Value()); edge.More(); edge.Next())
        if (edge.Value().ShapeType() == TopAbs_EDGE) walked.push_back(TopoDS::Edge(edge.Value()));
      if (turned) std::reverse(walked.begin(), walked.end());
      for (const TopoDS_Edge& edge : walked) builder_.Add(wire, traced(edge, geometry, made, form));
      wire.Closed(true);
      builder_.Add(made, wire);
    }
    const bool reversed = (given.Orientation() == TopAbs_REVERSED) != turned;
    return TopoDS::Face(made.Oriented(reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
  }

  /// An edge of a face as the new face uses it, with its curve in the new domain.
  TopoDS_Edge traced(const TopoDS_Edge& edge, const FaceGeometry& geometry, const TopoDS_Face& face,
                     const std::optional<SurfaceForm>& form) {
    TopoDS_Edge made = BRep_Tool::Degenerated(edge) ? pole(edge) : TopoDS::Edge(edges_.Find(edge));
    const bool turned = form && form->turned;
    const TopAbs_Orientation orientation = turned ? TopAbs::Reverse(edge.Orientation()) : edge.Orientation();
    Handle(Geom2d_Curve) curve = curve_of(edge, geometry, form);
    if (!curve.IsNull()) add_trace(made, face, curve, orientation == TopAbs_REVERSED);
    return TopoDS::Edge(made.Oriented(orientation));
  }

  void add_trace(const TopoDS_Edge& made, const TopoDS_Face& face, const Handle(Geom2d_Curve) & curve,
                 bool reversed) {
    TopLoc_Location none;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    double first = 0, last = 0;
    BRep_Tool::Range(made, first, last);
    const double tolerance = std::max(BRep_Tool::Tolerance(made), 1.1 * distance(made, surface, curve));
    // A second curve of the same edge in the same face: a seam.
    const auto key = std::pair(made.TShape().get(), face.TShape().get());
    const auto known = traces_.find(key);
    if (known == traces_.end()) {
      traces_[key] = {curve, reversed};
      builder_.UpdateEdge(made, curve, surface, none, tolerance);
    } else if (known->second.second != reversed) {
      const Handle(Geom2d_Curve) other = known->second.first;
      builder_.UpdateEdge(made, reversed ? other : curve, reversed ? curve : other, surface, none, tolerance);
    }
    builder_.Range(made, first, last);
    for (TopoDS_Iterator it(made); it.More(); it.Next())
      builder_.UpdateVertex(TopoDS::Vertex(it.Value()), tolerance);
  }

  static double distance(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface,
                         const Handle(Geom2d_Curve) & trace) {
    double first = 0, last = 0, result = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) return 0;
    constexpr int samples = 23;
    for (int i = 0; i <= samples; ++i) {
      const double t = first + (last - first) * i / samples;
      const gp_Pnt2d uv = trace->Value(t);
      result = std::max(result, surface->Value(uv.X(), uv.Y()).Distance(curve->Value(t)));
    }
    return result;
  }

  /// An edge without length, which closes a domain.
  TopoDS_Edge pole(const TopoDS_Edge& edge) {
    if (edges_.IsBound(edge)) return TopoDS::Edge(edges_.Find(edge));
    TopoDS_Edge made;
    builder_.MakeEdge(made);
    builder_.Degenerated(made, true);
    double first = 0, last = 0;
    BRep_Tool::Range(edge, first, last);
    add_vertices(made, TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)));
    builder_.Range(made, first, last);
    edges_.Bind(edge, made);
    return made;
  }

  /// Nothing where a plane has none: the library makes it itself.
  Handle(Geom2d_Curve) curve_of(const TopoDS_Edge& edge, const FaceGeometry& geometry,
                                const std::optional<SurfaceForm>& form) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) given = BRep_Tool::CurveOnSurface(edge, geometry.face, first, last);
    if (given.IsNull()) return given;
    const Handle(Geom_Surface) surface = form ? form->surface : geometry.surface;
    if (!Handle(Geom_Plane)::DownCast(surface).IsNull()) return {};
    const CurveForm* space = form_of(edge);
    const bool same_pace = space == nullptr || space->curve == source_curve(edge);
    if (!form && same_pace) return given;
    constexpr int samples = 129;
    Eigen::VectorXd t(samples);
    Eigen::Matrix2Xd points(2, samples);
    for (int i = 0; i < samples; ++i) {
      const double at = first + (last - first) * i / (samples - 1);
      const gp_Pnt2d uv = given->Value(at);
      points.col(i) = form ? form->to_domain(to_eigen(uv)) : to_eigen(uv);
      t[i] = same_pace ? at : space->to_parameter(at);
    }
    if (space != nullptr && !same_pace) {
      t[0] = space->first;
      t[samples - 1] = space->last;
    }
    return domain_curve(t, points, 1e-9 * (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm());
  }

  const CurveForm* form_of(const TopoDS_Edge& edge) const {
    for (std::size_t e = 0; e < edge_forms_.size(); ++e)
      if (source_.of(EdgeId(static_cast<int>(e))).edge.IsSame(edge)) return &edge_forms_[e];
    return nullptr;
  }
  Handle(Geom_Curve) source_curve(const TopoDS_Edge& edge) const {
    for (std::size_t e = 0; e < edge_forms_.size(); ++e)
      if (source_.of(EdgeId(static_cast<int>(e))).edge.IsSame(edge))
        return source_.of(EdgeId(static_cast<int>(e))).curve;
    return {};
  }

  /// The shells as they were: the outer one and cavities, or an open one.
  TopoDS_Shape whole() {
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    TopoDS_Shell shell;
    for (TopExp_Explorer it(source_.input().shape, TopAbs_SHELL); it.More(); it.Next()) {
      builder_.MakeShell(shell);
      for (TopExp_Explorer face(it.Current(), TopAbs_FACE); face.More(); face.Next())
        builder_.Add(shell, faces_.Find(face.Current()));
      shell.Closed(it.Current().Closed());
      builder_.Add(solid, shell);
    }
    return source_.input().shape.ShapeType() == TopAbs_SHELL ? TopoDS_Shape(shell) : solid;
  }

  void finish(ShapeInput& input) {
    input.shape = whole();
    input.names = source_.input().names;
    input.colours = source_.input().colours;
    input.metres = source_.input().metres;
    for (std::size_t e = 0; e < source_.tables().edges.size(); ++e)
      input.edges.push_back(TopoDS::Edge(edges_.Find(source_.of(EdgeId(static_cast<int>(e))).edge)));
    input.vertices = ordered_vertices();
  }

  /// In the order of the source's.
  std::vector<TopoDS_Vertex> ordered_vertices() const {
    const BrepTables& tables = source_.tables();
    std::vector<TopoDS_Vertex> result(static_cast<std::size_t>(tables.vertices.cols()));
    for (std::size_t e = 0; e < tables.edges.size(); ++e) {
      const TopoDS_Edge& edge = source_.of(EdgeId(static_cast<int>(e))).edge;
      const auto put = [&](VertexId id, const TopoDS_Vertex& vertex) {
        result[static_cast<std::size_t>(id.value)] = TopoDS::Vertex(vertices_.Find(vertex));
      };
      put(tables.edges[e].start, TopExp::FirstVertex(edge));
      put(tables.edges[e].end, TopExp::LastVertex(edge));
    }
    result.erase(std::remove_if(result.begin(), result.end(), [](const auto& v) { return v.IsNull(); }),
                 result.end());
    return result;
  }

  const ShapeKernel& source_;
  double tolerance_;
  BRep_Builder builder_;
  std::vector<std::optional<SurfaceForm>> forms_;  ///< by face
  std::vector<CurveForm> edge_forms_;              ///< by edge
  TopTools_DataMapOfShapeShape faces_, edges_, vertices_;
  std::map<std::pair<const void*, const void*>, std::pair<Handle(Geom2d_Curve), bool>> traces_;
};

}  // namespace

KernelSolid solid_with_carriers(const ShapeKernel& kernel, double tolerance) {
  return CarrierMaker(kernel, tolerance).make();
}

}  // namespace isopatch::geometry
