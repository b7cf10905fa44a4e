#include "geometry/brep/opencascade/internal/tessellation.hpp"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/conversions.hpp"

namespace isopatch::geometry {
namespace {

FaceTriangles triangles_of(const Poly_Triangulation& mesh, const gp_Trsf& place, bool reversed,
                           double metres) {
  FaceTriangles result;
  result.uv.resize(2, mesh.NbNodes());
  result.points.resize(3, mesh.NbNodes());
  for (int i = 0; i < mesh.NbNodes(); ++i) {
    result.uv.col(i) = to_eigen(mesh.UVNode(i + 1));
    result.points.col(i) = metres * to_eigen(mesh.Node(i + 1).Transformed(place));
  }
  result.triangles.resize(3, mesh.NbTriangles());
  for (int i = 0; i < mesh.NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    mesh.Triangle(i + 1).Get(a, b, c);
    if (reversed) std::swap(b, c);
    result.triangles.col(i) << a - 1, b - 1, c - 1;
  }
  return result;
}

class Mesher {
 public:
  Mesher(const ShapeInput& input, const std::vector<FaceGeometry>& faces,
         const std::vector<EdgeGeometry>& edges, double chord, double turn)
      : input_(input), faces_(faces), edges_(edges), copy_(input.shape, false, false) {
    // On a copy, since meshes are kept in the shape.
    BRepMesh_IncrementalMesh(copy_.Shape(), chord, false, turn, false);
  }

  Tessellation make() {
    result_.edges.resize(edges_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) add_face(i);
    return std::move(result_);
  }

 private:
  void add_face(std::size_t index) {
    const TopoDS_Face copied = TopoDS::Face(copy_.ModifiedShape(faces_[index].face));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(copied, location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0)
      throw Error(ErrorCode::unsupported,
                  fmt::format("face {} cannot be triangulated; its loops may cross", index));
    const bool reversed = input_.faces[index].Orientation() == TopAbs_REVERSED;
    FaceTriangles face = triangles_of(*mesh, location.Transformation(), reversed, input_.metres);
    for (const auto& [use, curve] : faces_[index].uses) {
      const TopoDS_Edge edge = oriented_copy(use, reversed);
      const Handle(Poly_PolygonOnTriangulation) polygon =
          BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
      if (polygon.IsNull())
        throw Error(ErrorCode::unsupported,
                    fmt::format("edge {} of face {} cannot be triangulated", use.edge.value, index));
      join(face, *polygon, use.edge);
    }
    result_.faces.push_back(std::move(face));
  }

  TopoDS_Edge oriented_copy(EdgeUse use, bool face_reversed) const {
    const TopoDS_Edge& edge = edges_[static_cast<std::size_t>(use.edge.value)].edge;
    const TopoDS_Shape copied = copy_.ModifiedShape(edge);
    return TopoDS::Edge(copied.Oriented(use.reversed != face_reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
  }

  // The edge's points are those of the face that comes first; the others take them over.
  void join(FaceTriangles& face, const Poly_PolygonOnTriangulation& polygon, EdgeId id) {
    EdgePoints& edge = result_.edges[static_cast<std::size_t>(id.value)];
    const int count = polygon.NbNodes();
    if (edge.points.cols() == 0) {
      const EdgeGeometry& geometry = edges_[static_cast<std::size_t>(id.value)];
      edge.points.resize(3, count);
      edge.t = Eigen::VectorXd::LinSpaced(count, 0, 1);
      const Handle(TColStd_HArray1OfReal) parameters = polygon.Parameters();
      for (int i = 0; i < count; ++i) {
        edge.points.col(i) = face.points.col(polygon.Node(i + 1) - 1);
        if (!parameters.IsNull())
          edge.t(i) = (parameters->Value(i + 1) - geometry.first) / (geometry.last - geometry.first);
      }
      return;
    }
    if (count != edge.points.cols())
      throw Error(ErrorCode::unsupported,
                  fmt::format("the faces at edge {} are triangulated differently", id.value));
    for (int i = 0; i < count; ++i) face.points.col(polygon.Node(i + 1) - 1) = edge.points.col(i);
  }

  const ShapeInput& input_;
  const std::vector<FaceGeometry>& faces_;
  const std::vector<EdgeGeometry>& edges_;
  BRepBuilderAPI_Copy copy_;
  Tessellation result_;
};

}  // namespace

Tessellation tessellate_shape(const ShapeInput& input, const std::vector<FaceGeometry>& faces,
                              const std::vector<EdgeGeometry>& edges, double chord, double turn) {
  return Mesher(input, faces, edges, chord, turn).make();
}

}  // namespace isopatch::geometry
