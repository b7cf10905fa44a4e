#include "geometry/brep/opencascade/internal/shape_tables.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <ShapeAnalysis.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "geometry/brep/opencascade/internal/conversions.hpp"
#include "geometry/brep/opencascade/internal/curve_length.hpp"
#include "geometry/brep/solid_error.hpp"

namespace isopatch::geometry {
namespace {

SurfaceKind kind_of(const Handle(Geom_Surface) & surface) {
  switch (GeomAdaptor_Surface(surface).GetType()) {
    case GeomAbs_Plane:
      return SurfaceKind::plane;
    case GeomAbs_Cylinder:
      return SurfaceKind::cylinder;
    case GeomAbs_Cone:
      return SurfaceKind::cone;
    case GeomAbs_Sphere:
      return SurfaceKind::sphere;
    case GeomAbs_Torus:
      return SurfaceKind::torus;
    case GeomAbs_BSplineSurface:
    case GeomAbs_BezierSurface:
      return SurfaceKind::spline;
    default:
      return SurfaceKind::other;
  }
}

CurveKind kind_of(const Handle(Geom_Curve) & curve) {
  switch (GeomAdaptor_Curve(curve).GetType()) {
    case GeomAbs_Line:
      return CurveKind::line;
    case GeomAbs_Circle:
      return CurveKind::circle;
    case GeomAbs_Ellipse:
      return CurveKind::ellipse;
    case GeomAbs_BSplineCurve:
    case GeomAbs_BezierCurve:
      return CurveKind::spline;
    default:
      return CurveKind::other;
  }
}

DomainBox domain_of(const TopoDS_Face& face) {
  DomainBox box;
  BRepTools::UVBounds(face, box.low.x(), box.high.x(), box.low.y(), box.high.y());
  return box;
}

class TableMaker {
 public:
  explicit TableMaker(const ShapeInput& input) : input_(input) {
    for (const TopoDS_Vertex& vertex : input.vertices) vertices_.Add(vertex);
    for (const TopoDS_Edge& edge : input.edges) edge_id(edge, FaceId(0));
  }

  ShapeTables make() {
    for (std::size_t i = 0; i < input_.faces.size(); ++i) add_face(i);
    BrepTables& tables = result_.tables;
    tables.vertices.resize(3, vertices_.Extent());
    for (int i = 0; i < vertices_.Extent(); ++i)
      tables.vertices.col(i) = input_.metres * to_eigen(BRep_Tool::Pnt(TopoDS::Vertex(vertices_(i + 1))));
    set_box();
    require_lengths();
    return std::move(result_);
  }

 private:
  void add_face(std::size_t index) {
    const TopoDS_Face& oriented = input_.faces[index];
    FaceGeometry geometry;
    geometry.face = TopoDS::Face(oriented.Oriented(TopAbs_FORWARD));
    geometry.surface = BRep_Tool::Surface(geometry.face);
    geometry.domain = domain_of(geometry.face);
    BrepFace face;
    face.kind = kind_of(geometry.surface);
    face.reversed = oriented.Orientation() == TopAbs_REVERSED;
    if (!input_.names.empty()) face.name = input_.names[index];
    if (!input_.colours.empty()) face.colour = input_.colours[index];
    add_loops(geometry, face, FaceId(static_cast<int>(index)));
    result_.faces.push_back(std::move(geometry));
    result_.tables.faces.push_back(std::move(face));
  }

  void add_loops(FaceGeometry& geometry, BrepFace& face, FaceId id) {
    const TopoDS_Wire outer = ShapeAnalysis::OuterWire(geometry.face);
    for (TopoDS_Iterator it(geometry.face); it.More(); it.Next()) {
      if (it.Value().ShapeType() != TopAbs_WIRE) continue;
      const TopoDS_Wire wire = TopoDS::Wire(it.Value());
      std::vector<EdgeUse> loop = uses(geometry, wire, id, face.reversed);
      if (loop.empty()) continue;
      face.loops.insert(wire.IsSame(outer) ? face.loops.begin() : face.loops.end(), std::move(loop));
    }
  }

  std::vector<EdgeUse> uses(FaceGeometry& geometry, const TopoDS_Wire& wire, FaceId id, bool face_reversed) {
    std::vector<EdgeUse> loop;
    for (const TopoDS_Edge& edge : walk(geometry, wire)) {
      if (BRep_Tool::Degenerated(edge)) continue;
      // Along the surface's own normal first; turned around below if the face looks the other way.
      EdgeUse use{edge_id(edge, id), edge.Orientation() == TopAbs_REVERSED};
      UseCurve curve;
      curve.curve = BRep_Tool::CurveOnSurface(edge, geometry.face, curve.first, curve.last);
      if (curve.curve.IsNull())
        throw Error(ErrorCode::unsupported,
                    fmt::format("edge {} has no curve in the domain of face {}", use.edge.value, id.value));
      if (face_reversed) use.reversed = !use.reversed;
      geometry.uses.emplace(use, curve);
      result_.tables.edges[static_cast<std::size_t>(use.edge.value)].faces.push_back(id);
      loop.push_back(use);
    }
    if (face_reversed) std::reverse(loop.begin(), loop.end());
    return loop;
  }

  // The edges of a wire one after the other; as the wire lists them where it is not connected.
  static std::vector<TopoDS_Edge> walk(const FaceGeometry& geometry, const TopoDS_Wire& wire) {
    std::vector<TopoDS_Edge> walked, listed;
    for (BRepTools_WireExplorer it(wire, geometry.face); it.More(); it.Next()) walked.push_back(it.Current());
    for (TopoDS_Iterator it(wire); it.More(); it.Next())
      if (it.Value().ShapeType() == TopAbs_EDGE &&
          (it.Value().Orientation() == TopAbs_FORWARD || it.Value().Orientation() == TopAbs_REVERSED))
        listed.push_back(TopoDS::Edge(it.Value()));
    return walked.size() == listed.size() ? walked : listed;
  }

  EdgeId edge_id(const TopoDS_Edge& edge, FaceId face) {
    const int known = edges_.FindIndex(edge);
    if (known > 0) return EdgeId(known - 1);
    const EdgeId id(edges_.Add(edge) - 1);
    EdgeGeometry geometry;
    geometry.edge = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    geometry.curve = BRep_Tool::Curve(geometry.edge, geometry.first, geometry.last);
    if (geometry.curve.IsNull())
      throw Error(ErrorCode::unsupported,
                  fmt::format("edge {} of face {} has no curve in space", id.value, face.value));
    BrepEdge shown;
    shown.start = vertex_id(TopExp::FirstVertex(geometry.edge), id);
    shown.end = vertex_id(TopExp::LastVertex(geometry.edge), id);
    shown.kind = kind_of(geometry.curve);
    const Measure length = curve_length(geometry.curve, geometry.first, geometry.last, 1e-10);
    shown.length = input_.metres * length.value;
    shown.length_error = input_.metres * length.error;
    result_.edges.push_back(geometry);
    result_.tables.edges.push_back(shown);
    return id;
  }

  VertexId vertex_id(const TopoDS_Vertex& vertex, EdgeId edge) {
    if (vertex.IsNull())
      throw Error(ErrorCode::unsupported, fmt::format("edge {} has no vertex at an end", edge.value));
    return VertexId(vertices_.Add(vertex) - 1);
  }

  // Optimal boxes of surfaces are slow, so only those faces get one that may reach beyond all edges.
  void set_box() {
    Bnd_Box box;
    for (const EdgeGeometry& edge : result_.edges) BRepBndLib::AddOptimal(edge.edge, box, false, false);
    if (box.IsVoid()) throw Error(ErrorCode::unsupported, "the solid has no edges");
    box.SetGap(0);
    for (const TopoDS_Face& face : input_.faces) {
      Bnd_Box generous;
      BRepBndLib::Add(face, generous, false);
      if (!contains(box, generous)) BRepBndLib::AddOptimal(face, box, false, false);
    }
    auto& corners = result_.tables.box;
    box.Get(corners[0].x(), corners[0].y(), corners[0].z(), corners[1].x(), corners[1].y(), corners[1].z());
    for (Eigen::Vector3d& corner : corners) corner *= input_.metres;
  }

  static bool contains(const Bnd_Box& outer, const Bnd_Box& inner) {
    const gp_Pnt low = outer.CornerMin(), high = outer.CornerMax();
    const gp_Pnt from = inner.CornerMin(), to = inner.CornerMax();
    return low.X() <= from.X() && low.Y() <= from.Y() && low.Z() <= from.Z() && to.X() <= high.X() &&
           to.Y() <= high.Y() && to.Z() <= high.Z();
  }

  void require_lengths() const {
    const BrepTables& tables = result_.tables;
    const double size = (tables.box[1] - tables.box[0]).norm();
    for (std::size_t i = 0; i < tables.edges.size(); ++i) {
      const BrepEdge& edge = tables.edges[i];
      if (edge.length > 1e-9 * size) continue;
      const Eigen::Vector3d at = tables.vertices.col(edge.start.value);
      SolidFault fault{.points = {{fmt::format("edge {}", i), at}}};
      for (const int face : face_numbers(edge)) fault.faces.push_back({face});
      throw SolidError(
          ErrorCode::not_manifold,
          fmt::format("edge {} of faces {} at ({:.6g}, {:.6g}, {:.6g}) m has no length; remove it in the CAD "
                      "program",
                      i, fmt::join(face_numbers(edge), " and "), at.x(), at.y(), at.z()),
          std::move(fault));
    }
  }

  static std::vector<int> face_numbers(const BrepEdge& edge) {
    std::vector<int> numbers;
    for (const FaceId face : edge.faces) numbers.push_back(face.value);
    return numbers;
  }

  const ShapeInput& input_;
  ShapeTables result_;
  TopTools_IndexedMapOfShape edges_, vertices_;
};

}  // namespace

ShapeTables shape_tables(const ShapeInput& input) {
  return TableMaker(input).make();
}

}  // namespace isopatch::geometry
