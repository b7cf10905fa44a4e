#include "geometry/brep/carrier_solid.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/brep/opencascade/internal/carrier_forms.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/domain_curve.hpp"
#include "geometry/brep/opencascade/internal/face_surface.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double least_edge_tolerance = 1e-7;
constexpr int least_trace_samples = 65;
constexpr int trace_samples_of_span = 12;

/// A curve through points at evenly spaced parameters, or what it really is.
CurveForm form_of_points(const Eigen::Matrix3Xd& points, double tolerance) {
  const int count = static_cast<int>(points.cols()), step = (count - 1) / (CarrierSolid::points_of_edge - 1);
  TColgp_Array1OfPnt poles(1, CarrierSolid::points_of_edge);
  TColStd_Array1OfReal knots(1, CarrierSolid::points_of_edge);
  TColStd_Array1OfInteger multiplicities(1, CarrierSolid::points_of_edge);
  multiplicities.Init(1);
  multiplicities(1) = multiplicities(CarrierSolid::points_of_edge) = 2;
  for (int i = 0; i < CarrierSolid::points_of_edge; ++i) {
    poles(i + 1) = to_point(points.col(Eigen::Index{i} * step));
    knots(i + 1) = i;
  }
  // Forms are looked for at 33 even places: those of the points.
  const Handle(Geom_Curve) polygon = new Geom_BSplineCurve(poles, knots, multiplicities, 1);
  for (const double near : {1e-3 * tolerance, tolerance})
    if (auto form = curve_form(polygon, 0, CarrierSolid::points_of_edge - 1, near)) return *form;
  const Handle(TColgp_HArray1OfPnt) all = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) all->SetValue(i + 1, to_point(points.col(i)));
  GeomAPI_Interpolate through(all, false, 1e-12);
  through.Perform();
  const Handle(Geom_BSplineCurve) curve = through.Curve();
  return {Handle(Geom_Curve)(curve), curve->FirstParameter(), curve->LastParameter(),
          [](double t) { return t; }};
}

class OnCarriers {
 public:
  OnCarriers(const CarrierSolid& solid, double tolerance) : solid_(solid) {
    const Eigen::Vector3d box = solid.vertices.rowwise().maxCoeff() - solid.vertices.rowwise().minCoeff();
    double size = box.norm();
    for (const CarrierSolid::Edge& edge : solid.edges)
      if (edge.points.cols() > 0)
        size = std::max(size, (edge.points.rowwise().maxCoeff() - edge.points.rowwise().minCoeff()).norm());
    scale_ = kernel_scale(size);
    tolerance_ = scale_ * tolerance;
  }

  KernelSolid make() {
    for (const auto& p : solid_.vertices.colwise()) {
      TopoDS_Vertex vertex;
      builder_.MakeVertex(vertex, to_point(scale_ * Eigen::Vector3d(p)), least_edge_tolerance);
      vertices_.push_back(vertex);
    }
    for (const CarrierSolid::Edge& edge : solid_.edges)
      edges_.push_back(or_refused([&] { return edge_of(edge); }, "an edge", edge.start));
    std::vector<TopoDS_Face> faces;
    for (const CarrierSolid::Face& face : solid_.faces)
      faces.push_back(or_refused([&] { return face_of(face); }, fmt::format("face '{}'", face.name),
                                 face.loops.empty() || face.loops.front().empty()
                                     ? VertexId(0)
                                     : start_of(face.loops.front().front().edge)));
    ShapeInput input;
    input.metres = 1 / scale_;
    input.shape = whole(faces);
    input.faces = std::move(faces);
    input.vertices = vertices_;
    for (const TopoDS_Edge& edge : edges_)
      if (!BRep_Tool::Degenerated(edge)) input.edges.push_back(edge);
    for (const CarrierSolid::Face& face : solid_.faces) input.names.push_back(face.name);
    input.colours.resize(solid_.faces.size());
    return {std::make_shared<ShapeKernel>(std::move(input)), "", 0};
  }

 private:
  TopoDS_Vertex& vertex(VertexId id) { return vertices_[static_cast<std::size_t>(id.value)]; }
  TopoDS_Edge& edge(EdgeId id) { return edges_[static_cast<std::size_t>(id.value)]; }

  VertexId start_of(EdgeId id) const { return solid_.edges[static_cast<std::size_t>(id.value)].start; }

  /// What the library cannot draw is refused with its place.
  auto or_refused(const auto& make, const std::string& what, VertexId id) const -> decltype(make()) {
    try {
      return make();
    } catch (const Standard_Failure&) {
      const Eigen::Vector3d p = solid_.vertices.col(id.value);
      throw Error(
          ErrorCode::unsupported,
          fmt::format("{} that begins at ({:.6g}, {:.6g}, {:.6g}) m cannot be drawn on the surfaces beside "
                      "it, which do not meet along it",
                      what, p.x(), p.y(), p.z()));
    }
  }

  CurveForm form_of(const CarrierSolid::Edge& given) const {
    if (!given.curve) return form_of_points(scale_ * given.points, tolerance_);
    const Handle(Geom_BSplineCurve) curve = to_shape(*given.curve, scale_);
    return {Handle(Geom_Curve)(curve), curve->FirstParameter(), curve->LastParameter(),
            [](double t) { return t; }};
  }

  TopoDS_Edge edge_of(const CarrierSolid::Edge& given) {
    TopoDS_Edge made;
    if (given.points.cols() == 0) {
      builder_.MakeEdge(made);
      builder_.Degenerated(made, true);
      builder_.Range(made, 0, 1);
    } else {
      const CurveForm form = form_of(given);
      builder_.MakeEdge(made, form.curve, least_edge_tolerance);
      builder_.Range(made, form.first, form.last);
      const auto ends = {std::pair(given.start, form.first), std::pair(given.end, form.last)};
      for (const auto& [id, at] : ends)
        builder_.UpdateVertex(
            vertex(id),
            std::max(least_edge_tolerance, 1.1 * BRep_Tool::Pnt(vertex(id)).Distance(form.curve->Value(at))));
    }
    builder_.Add(made, vertex(given.start).Oriented(TopAbs_FORWARD));
    builder_.Add(made, vertex(given.end).Oriented(TopAbs_REVERSED));
    return made;
  }

  /// A point of the edge that the face walks twice, else of its first one.
  Eigen::Vector3d start_of_turn(const CarrierSolid::Face& face) const {
    const auto middle = [&](const EdgeUse& use) -> Eigen::Vector3d {
      const Eigen::Matrix3Xd& points = solid_.edges[static_cast<std::size_t>(use.edge.value)].points;
      return points.col(points.cols() / 2);
    };
    std::optional<Eigen::Vector3d> circling;
    for (const auto& loop : face.loops)
      for (const EdgeUse& use : loop) {
        if (use.reversed || std::find(loop.begin(), loop.end(), EdgeUse{use.edge, true}) == loop.end())
          continue;
        // A seam around a torus says nothing of where the turn begins.
        if (goes_around(face.carrier, use.edge))
          circling = solid_.vertices.col(solid_.edges[static_cast<std::size_t>(use.edge.value)].start.value);
        else
          return middle(use);
      }
    if (circling) return *circling;
    return solid_.vertices.col(
        solid_.edges[static_cast<std::size_t>(face.loops.front().front().edge.value)].start.value);
  }

  bool goes_around(const Carrier& carrier, EdgeId id) const {
    const Eigen::Matrix3Xd& points = solid_.edges[static_cast<std::size_t>(id.value)].points;
    const Eigen::Vector3d a = points.col(0) - carrier.origin,
                          b = points.col(points.cols() / 2) - carrier.origin;
    const Eigen::Vector3d across = a - carrier.axis * carrier.axis.dot(a);
    return across.dot(b) < 0;
  }

  static int trace_samples(const Handle(Geom_Curve) & curve) {
    const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    if (spline.IsNull()) return least_trace_samples;
    return std::max(least_trace_samples, trace_samples_of_span * (spline->NbKnots() - 1) + 1);
  }

  struct Trace {
    Eigen::VectorXd t;        ///< along the edge, increasing
    Eigen::Matrix2Xd points;  ///< in the domain
  };

  /// The loop's curves in the domain, one after the other.
  std::vector<Trace> traces(const std::vector<EdgeUse>& loop, const FaceSurface& surface, bool reversed) {
    std::vector<Trace> result(loop.size());
    // A pole's own turn is what the others leave open, so it comes last.
    std::size_t first = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (BRep_Tool::Degenerated(edge(loop[i].edge))) first = (i + 1) % loop.size();
    Eigen::Vector2d at(0, 0), begin(0, 0);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t i = (first + k) % loop.size();
      const TopoDS_Edge& made = edge(loop[i].edge);
      Trace& trace = result[i];
      if (BRep_Tool::Degenerated(made)) {
        // Several poles: each takes the way to the next edge's start.
        const bool last = k + 1 == loop.size();
        Eigen::Vector2d end = last ? begin : at;
        if (!last) end.x() = at.x() + (reversed ? turn : -turn);
        trace.t = Eigen::Vector2d(0, 1);
        trace.points.resize(2, 2);
        end.y() = at.y();
        trace.points.col(loop[i].reversed ? 1 : 0) = at;
        trace.points.col(loop[i].reversed ? 0 : 1) = end;
        at = end;
        continue;
      }
      double from = 0, to = 0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(made, from, to);
      const int samples = trace_samples(curve);
      trace.t.resize(samples);
      trace.points.resize(2, samples);
      // At a pole the first point's turn is that of the second.
      const auto sample = [&](int s) {
        const double share = double(s) / (samples - 1);
        return from + (to - from) * (loop[i].reversed ? 1 - share : share);
      };
      if (k == 0) at = surface.parameters(to_eigen(curve->Value(sample(1))), std::nullopt);
      for (int s = 0; s < samples; ++s) {
        const Eigen::Vector3d point = to_eigen(curve->Value(sample(s)));
        at = surface.parameters(point, at);
        if (s == 0 && k == 0) begin = at;
        const int place = loop[i].reversed ? samples - 1 - s : s;
        trace.t[place] = sample(s);
        trace.points.col(place) = at;
      }
    }
    return result;
  }

  static double middle(const std::vector<Trace>& traces, Eigen::Index row, bool lowest) {
    double low = 1e300, high = -1e300;
    for (const Trace& trace : traces) {
      low = std::min(low, trace.points.row(row).minCoeff());
      high = std::max(high, trace.points.row(row).maxCoeff());
    }
    return lowest ? low : (low + high) / 2;
  }

  static double signed_domain_area(const std::vector<EdgeUse>& loop, const std::vector<Trace>& traces) {
    double sum = 0;
    for (std::size_t i = 0; i < traces.size(); ++i) {
      const Eigen::Matrix2Xd& p = traces[i].points;
      for (Eigen::Index s = 0; s + 1 < p.cols(); ++s) {
        const double cross = p(0, s) * p(1, s + 1) - p(1, s) * p(0, s + 1);
        sum += loop[i].reversed ? -cross : cross;
      }
    }
    return sum / 2;
  }

  /// Moves all loops by whole turns: the outer one to the first turn, the others into it.
  static void align(std::vector<std::vector<Trace>>& loops, std::size_t outer, const FaceSurface& surface) {
    const std::array<double, 2> periods{surface.u_period(), surface.v_period()};
    for (Eigen::Index row = 0; row < 2; ++row) {
      const double period = periods[static_cast<std::size_t>(row)];
      if (!(period > 0)) continue;
      const auto shift = [&](std::vector<Trace>& traces, double by) {
        for (Trace& trace : traces) trace.points.row(row).array() += by;
      };
      shift(loops[outer], -period * std::floor((middle(loops[outer], row, true) + 1e-6) / period));
      const double wanted = middle(loops[outer], row, false);
      for (std::size_t l = 0; l < loops.size(); ++l)
        if (l != outer)
          shift(loops[l], period * std::round((wanted - middle(loops[l], row, false)) / period));
    }
  }

  TopoDS_Face face_of(const CarrierSolid::Face& given) {
    if (given.loops.empty())
      throw Error(ErrorCode::invalid_argument, fmt::format("face '{}' has no loop", given.name));
    const std::unique_ptr<FaceSurface> made =
        given.spline ? spline_surface(*given.spline, scale_)
                     : carrier_surface(given.carrier, start_of_turn(given), scale_);
    const FaceSurface& surface = *made;
    std::vector<std::vector<Trace>> loops;
    std::vector<double> areas;
    for (const auto& loop : given.loops) {
      loops.push_back(traces(loop, surface, given.reversed));
      areas.push_back(std::abs(signed_domain_area(loop, loops.back())));
    }
    const auto outer = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    align(loops, outer, surface);
    TopoDS_Face face;
    builder_.MakeFace(face, surface.surface(), least_edge_tolerance);
    builder_.Add(face, wire(given.loops[outer], loops[outer], surface.surface(), given.reversed));
    for (std::size_t l = 0; l < loops.size(); ++l)
      if (l != outer) builder_.Add(face, wire(given.loops[l], loops[l], surface.surface(), given.reversed));
    return TopoDS::Face(face.Oriented(given.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
  }

  TopoDS_Wire wire(std::vector<EdgeUse> loop, const std::vector<Trace>& traces,
                   const Handle(Geom_Surface) & surface, bool reversed) {
    for (std::size_t i = 0; i < loop.size(); ++i) add_trace(loop, traces, i, surface, reversed);
    if (reversed) std::reverse(loop.begin(), loop.end());
    TopoDS_Wire result;
    builder_.MakeWire(result);
    for (const EdgeUse& use : loop)
      builder_.Add(result,
                   edge(use.edge).Oriented(use.reversed == reversed ? TopAbs_FORWARD : TopAbs_REVERSED));
    result.Closed(true);
    return result;
  }

  /// Gives the edge its curve in the domain; a seam both at once.
  void add_trace(const std::vector<EdgeUse>& loop, const std::vector<Trace>& traces, std::size_t i,
                 const Handle(Geom_Surface) & surface, bool reversed) {
    const auto other =
        std::find(loop.begin(), loop.end(), EdgeUse{loop[i].edge, !loop[i].reversed}) - loop.begin();
    const bool seam = other < static_cast<std::ptrdiff_t>(loop.size());
    if (seam && other < static_cast<std::ptrdiff_t>(i)) return;
    TopoDS_Edge& made = edge(loop[i].edge);
    // A pole has no range before it has a curve.
    double first = traces[i].t[0], last = traces[i].t[traces[i].t.size() - 1];
    if (!BRep_Tool::Degenerated(made)) BRep_Tool::Range(made, first, last);
    const auto curve = [&](const Trace& trace) {
      const double size = (trace.points.rowwise().maxCoeff() - trace.points.rowwise().minCoeff()).norm();
      return domain_curve(trace.t, trace.points, 1e-9 * size);
    };
    const Handle(Geom2d_Curve) own = curve(traces[i]);
    double off = off_surface(made, surface, own);
    const TopLoc_Location none;
    if (!Handle(Geom_Plane)::DownCast(surface).IsNull()) {
      // The library draws curves in planes itself, exactly.
    } else if (seam) {
      const Handle(Geom2d_Curve) second = curve(traces[static_cast<std::size_t>(other)]);
      off = std::max(off, off_surface(made, surface, second));
      // The first is that of the edge as it runs forward along the surface's normal.
      const bool forward = loop[i].reversed == reversed;
      builder_.UpdateEdge(made, forward ? own : second, forward ? second : own, surface, none,
                          BRep_Tool::Tolerance(made));
      builder_.Continuity(made, surface, surface, none, none, GeomAbs_CN);
    } else {
      builder_.UpdateEdge(made, own, surface, none, BRep_Tool::Tolerance(made));
    }
    builder_.UpdateEdge(made, std::max(least_edge_tolerance, 1.1 * off));
    builder_.Range(made, first, last);
    const CarrierSolid::Edge& given = solid_.edges[static_cast<std::size_t>(loop[i].edge.value)];
    for (const VertexId id : {given.start, given.end})
      builder_.UpdateVertex(vertex(id), std::max(least_edge_tolerance, 1.2 * off));
  }

  static double off_surface(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface,
                            const Handle(Geom2d_Curve) & trace) {
    if (BRep_Tool::Degenerated(edge)) return 0;
    double first = 0, last = 0, result = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    constexpr int places = 41;
    for (int i = 0; i <= places; ++i) {
      const double t = first + (last - first) * i / places;
      const gp_Pnt2d uv = trace->Value(t);
      result = std::max(result, surface->Value(uv.X(), uv.Y()).Distance(curve->Value(t)));
    }
    return result;
  }

  /// One shell for each set of faces that share edges.
  TopoDS_Shape whole(const std::vector<TopoDS_Face>& faces) {
    UnionFind shells(static_cast<int>(faces.size()));
    std::vector<int> user(edges_.size(), -1);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const auto& loop : solid_.faces[f].loops)
        for (const EdgeUse& use : loop) {
          int& first = user[static_cast<std::size_t>(use.edge.value)];
          if (first < 0) first = static_cast<int>(f);
          shells.unite(first, static_cast<int>(f));
        }
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    for (std::size_t s = 0; s < faces.size(); ++s) {
      if (shells.find(static_cast<int>(s)) != static_cast<int>(s)) continue;
      TopoDS_Shell shell;
      builder_.MakeShell(shell);
      for (std::size_t f = 0; f < faces.size(); ++f)
        if (shells.find(static_cast<int>(f)) == static_cast<int>(s)) builder_.Add(shell, faces[f]);
      shell.Closed(true);
      builder_.Add(solid, shell);
    }
    return solid;
  }

  const CarrierSolid& solid_;
  BRep_Builder builder_;
  double scale_ = 1, tolerance_ = 0;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
};

}  // namespace

KernelSolid solid_on_carriers(const CarrierSolid& solid, double tolerance) {
  return OnCarriers(solid, tolerance).make();
}

}  // namespace isopatch::geometry
