#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry::test {

/// A STEP file as text, entity by entity; each function gives the entity's number. Faces carry no curves in
/// their domains, so that the reader makes them.
class StepText {
 public:
  /// Metres per unit are the reader's; everything is moved by `offset`.
  explicit StepText(Eigen::Vector3d offset = Eigen::Vector3d::Zero()) : offset_(std::move(offset)) {}

  /// An entity as it stands in the file, without number and semicolon.
  int add(const std::string& entity);
  int point(const Eigen::Vector3d& at);
  int direction(const Eigen::Vector3d& along);
  int frame(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis = {0, 0, 1},
            const Eigen::Vector3d& x = {1, 0, 0});
  int vertex(const Eigen::Vector3d& at);
  int line(const Eigen::Vector3d& from, const Eigen::Vector3d& along);
  /// Not rational.
  int spline(const NurbsCurve& curve, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());
  int plane(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal);
  int edge(int start, int end, int curve);
  /// @param uses  numbers of edges, negative where they are walked backwards
  int loop(const std::vector<int>& uses);
  /// @param agrees  whether the outward normal is the surface's
  int face(int surface, const std::vector<int>& loops, bool agrees = true);

  /// The file. @param unit  "m" or "mm"
  std::string file(const std::vector<int>& faces, const std::string& unit) const;

 private:
  Eigen::Vector3d offset_;
  std::string text_;
  int count_ = 0;
};

/// Over a closed curve in the plane z = 0, counter-clockwise seen from above, of height h along z.
struct ClosedCurve {
  int bottom, top;        ///< the curve's entity at z = 0 and at z = h
  Eigen::Vector3d start;  ///< where it starts and ends
};
std::vector<int> prism_faces(StepText& step, const ClosedCurve& curve, double h);
std::vector<int> elliptic_prism(StepText& step, double a, double b, double h);
std::vector<int> spline_prism(StepText& step, const NurbsCurve& curve, double h);
/// Around the z axis; the sphere's and the torus's centre is the origin, the cone's apex is at z = h.
std::vector<int> cylinder(StepText& step, double r, double h);
std::vector<int> cone(StepText& step, double r, double h);
std::vector<int> sphere(StepText& step, double r);
std::vector<int> torus(StepText& step, double large, double small);
/// The volume under a curve (x, z) of the half plane x > 0 with both ends on the axis, turned around z.
std::vector<int> revolved(StepText& step, const NurbsCurve& profile);
/// [0, sides]; the plane of the face at high x lies `off` outside of its edges.
std::vector<int> block(StepText& step, const Eigen::Vector3d& sides, double off = 0);

/// A closed B-spline of the degree in the plane z = 0 around the origin, clamped: `points` control points at
/// radii between 0.6 and 1.4, counter-clockwise. Seeded.
NurbsCurve random_closed_spline(int degree, int points, unsigned seed);

}  // namespace isopatch::geometry::test
