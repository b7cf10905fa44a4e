#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/base/ids.hpp"
#include "geometry/brep/brep_parts.hpp"
#include "geometry/brep/measure.hpp"
#include "geometry/brep/tessellation.hpp"
#include "geometry/splines/nurbs.hpp"
#include "geometry/topology/edge_use.hpp"

namespace isopatch::geometry {

class BrepKernel;

/// A solid by its boundary: trimmed surfaces that meet along edges, which meet in vertices.
///
/// Immutable and cheap to copy; made by the readers (`read_brep`), `sew` and `make_brep`. Lengths are metres,
/// whatever the file's unit. Faces, edges and vertices count from 0 in the order of the file. Nothing is
/// promised about closedness, orientation or topology: `check(Brep)` reports that. Edges without length that
/// only close a domain (the pole of a sphere) are left out.
///
/// Every function of an id throws Error invalid_argument if the model has no such face, edge or vertex. All
/// may be called from several threads at once.
class Brep {
 public:
  explicit Brep(std::shared_ptr<const BrepKernel> kernel);

  const std::vector<BrepFace>& faces() const;
  const std::vector<BrepEdge>& edges() const;
  /// Positions of the vertices, (3, V), m.
  const Eigen::Matrix3Xd& vertices() const;

  const BrepFace& face(FaceId face) const;
  const BrepEdge& edge(EdgeId edge) const;
  Eigen::Vector3d vertex(VertexId vertex) const;

  /// Diagonal of the box of the model, m; what relative tolerances refer to.
  double size() const;
  /// Lowest and highest coordinates of the solid, m.
  std::array<Eigen::Vector3d, 2> box() const;
  /// m^3. Negative for a solid that is turned inside out. Quadrature of the exact surfaces and of the curves
  /// in their domains, to 1e-7 of the value unless the error says otherwise, mostly to 1e-12.
  /// @cost  some 50 to 1000 points a face, and as many for each span of a spline; kept
  double volume() const { return measured_volume().value; }
  double area(FaceId face) const { return measured_area(face).value; }  ///< m^2
  double area() const { return measured_area().value; }                 ///< m^2, of all faces
  /// The same with the estimates of their errors; those of lengths are in `BrepEdge`.
  Measure measured_volume() const;
  Measure measured_area(FaceId face) const;
  Measure measured_area() const;

  // Edges. t runs over [0, 1] from start to end, in proportion to the curve's own parameter (not to its
  // length).

  Eigen::Vector3d point(EdgeId edge, double t) const;
  /// d point / d t, m; not of unit length.
  Eigen::Vector3d tangent(EdgeId edge, double t) const;
  /// Nearest point of the edge, its ends included.
  EdgeProjection project(EdgeId edge, const Eigen::Vector3d& point) const;
  /// The edge as an exact NURBS curve from start to end, m. Its parameter need not be t.
  /// @throws Error unsupported if the curve has no exact rational form (an offset curve)
  NurbsCurve curve(EdgeId edge) const;

  // Faces. uv are the parameters of the face's surface as the file has it (angles in rad, spline parameters);
  // lengths among them are in kernel units, so only use them through these functions.

  /// Box around the face's loops in its domain. On periodic surfaces loops may lie anywhere within two
  /// periods.
  DomainBox domain(FaceId face) const;
  /// The use's curve in the face's domain. `t` is the edge's, so a reversed use walks from t = 1 to t = 0.
  ///
  /// point(face, domain_point(face, use, t)) is point(use.edge, t) up to the file's tolerance.
  /// @throws Error invalid_argument if no loop of the face has this use
  Eigen::Vector2d domain_point(FaceId face, EdgeUse use, double t) const;
  /// d domain_point / d t.
  Eigen::Vector2d domain_tangent(FaceId face, EdgeUse use, double t) const;

  /// Point of the untrimmed surface, m. Also outside the trimming loops, as far as the surface goes.
  Eigen::Vector3d point(FaceId face, const Eigen::Vector2d& uv) const;
  /// S_u and S_v, (3, 2), m per parameter.
  Eigen::Matrix<double, 3, 2> derivatives(FaceId face, const Eigen::Vector2d& uv) const;
  /// S_uu, S_uv and S_vv, (3, 3), m per parameter^2.
  Eigen::Matrix3d second_derivatives(FaceId face, const Eigen::Vector2d& uv) const;
  /// Unit normal that points out of the solid. Where the surface degenerates (a pole), the limit from the
  /// inside.
  Eigen::Vector3d outward_normal(FaceId face, const Eigen::Vector2d& uv) const;
  /// Nearest point of the surface within domain(face); not necessarily inside the loops, ask `contains`.
  FaceProjection project(FaceId face, const Eigen::Vector3d& point) const;
  /// The same from a start near it (a neighbour's parameters): Newton's method, falls back to the full
  /// search.
  FaceProjection project(FaceId face, const Eigen::Vector3d& point, const Eigen::Vector2d& start) const;
  /// Whether uv lies inside the loops or on them (closer in space than the edges' tolerance).
  bool contains(FaceId face, const Eigen::Vector2d& uv) const;
  /// What the surface is; nothing for splines and others.
  std::optional<Carrier> carrier(FaceId face) const;

  /// The kernel's own shape, for the writers.
  const BrepKernel& kernel() const { return *kernel_; }

 private:
  std::shared_ptr<const BrepKernel> kernel_;
};

/// A closed triangulation of the solid, face by face.
/// @throws Error unsupported  a face that cannot be triangulated, naming it
Tessellation tessellate(const Brep& brep, const TessellationOptions& options = {});

}  // namespace isopatch::geometry
