#include "geometry/brep/opencascade/internal/face_sides.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <ElSLib.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Precision.hxx>
#include <StepGeom_SphericalSurface.hxx>
#include <StepGeom_ToroidalSurface.hxx>
#include <StepShape_Edge.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <map>
#include <optional>

#include "geometry/brep/opencascade/internal/transfer_remarks.hpp"

namespace isopatch::geometry {
namespace {

/// How a file walks along an edge of a face.
struct Walk {
  Handle(StepShape_Edge) edge;
  bool forward = true;
};

/// The edges that a face has on one side only.
std::vector<Walk> walks_of(const StepShape_FaceSurface& face) {
  std::map<const Standard_Transient*, int> uses;
  std::vector<Walk> all, result;
  for (int b = 1; b <= face.NbBounds(); ++b) {
    const Handle(StepShape_FaceBound) bound = face.BoundsValue(b);
    if (bound.IsNull()) continue;
    const auto loop = Handle(StepShape_EdgeLoop)::DownCast(bound->Bound());
    for (int e = 1; !loop.IsNull() && e <= loop->NbEdgeList(); ++e) {
      const Handle(StepShape_OrientedEdge) use = loop->EdgeListValue(e);
      if (use.IsNull() || use->EdgeElement().IsNull()) continue;
      all.push_back({use->EdgeElement(), use->Orientation() == bound->Orientation()});
      ++uses[use->EdgeElement().get()];
    }
  }
  for (const Walk& walk : all)
    if (uses[walk.edge.get()] == 1) result.push_back(walk);
  return result;
}

/// Whether a face has the place beside an edge that lies in this direction from its middle.
class Side {
 public:
  explicit Side(const TopoDS_Face& face)
      : surface_(face, false), classifier_(face, Precision::PConfusion()) {}

  /// @param left  of the walk, seen from the surface's natural outside
  bool has(const TopoDS_Edge& edge, bool forward, bool left) {
    const BRepAdaptor_Curve curve(edge);
    gp_Pnt place, on_surface;
    gp_Vec along, du, dv;
    curve.D1(0.5 * (curve.FirstParameter() + curve.LastParameter()), place, along);
    const gp_Pnt2d uv = parameters(place);
    surface_.D1(uv.X(), uv.Y(), on_surface, du, dv);
    gp_Vec across = du.Crossed(dv).Crossed(along);
    if (across.Magnitude() < Precision::Confusion() * Precision::Confusion()) return false;
    const bool turned = (edge.Orientation() == TopAbs_REVERSED) == forward;
    across *= (turned == left ? -step : step) * radius() / across.Magnitude();
    return classifier_.Perform(parameters(place.Translated(across)), true) == TopAbs_IN;
  }

 private:
  // Of the radius: far beyond the library's tolerances, far within any face that matters.
  static constexpr double step = 1e-4;

  double radius() const {
    return surface_.GetType() == GeomAbs_Sphere ? surface_.Sphere().Radius() : surface_.Torus().MinorRadius();
  }
  gp_Pnt2d parameters(const gp_Pnt& place) const {
    double u = 0, v = 0;
    if (surface_.GetType() == GeomAbs_Sphere)
      ElSLib::Parameters(surface_.Sphere(), place, u, v);
    else
      ElSLib::Parameters(surface_.Torus(), place, u, v);
    return {u, v};
  }

  BRepAdaptor_Surface surface_;
  BRepTopAdaptor_FClass2d classifier_;
};

bool is_round(const StepShape_FaceSurface& face) {
  return !face.FaceGeometry().IsNull() &&
         (face.FaceGeometry()->IsKind(STANDARD_TYPE(StepGeom_SphericalSurface)) ||
          face.FaceGeometry()->IsKind(STANDARD_TYPE(StepGeom_ToroidalSurface)));
}

/// Whether every edge that can be judged has the face on its right and not on its left.
bool is_swapped(const StepShape_FaceSurface& face, const TopoDS_Face& made,
                const Handle(Transfer_TransientProcess) & process) {
  const GeomAbs_SurfaceType type = BRepAdaptor_Surface(made, false).GetType();
  if (type != GeomAbs_Sphere && type != GeomAbs_Torus) return false;
  Side side(made);
  bool any = false;
  for (const Walk& walk : walks_of(face)) {
    const TopoDS_Shape edge = TransferBRep::ShapeResult(process, walk.edge);
    if (edge.IsNull() || edge.ShapeType() != TopAbs_EDGE) continue;
    const bool on_left = side.has(TopoDS::Edge(edge), walk.forward, face.SameSense());
    const bool on_right = side.has(TopoDS::Edge(edge), walk.forward, !face.SameSense());
    if (on_left) return false;
    any = any || on_right;
  }
  return any;
}

}  // namespace

void add_swapped_sides(const XSControl_WorkSession& session, FileShapes& result) {
  const Handle(Interface_InterfaceModel) model = session.Model();
  const Handle(Transfer_TransientProcess) process = session.TransferReader()->TransientProcess();
  if (model.IsNull() || process.IsNull()) return;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto face = Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
    if (face.IsNull() || !is_round(*face)) continue;
    for (TopExp_Explorer it(TransferBRep::ShapeResult(process, face), TopAbs_FACE); it.More(); it.Next())
      if (is_swapped(*face, TopoDS::Face(it.Current()), process))
        result.lost.push_back({entity_number(*model, face), "made on the other side of its edges"});
  }
}

}  // namespace isopatch::geometry
