#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

namespace isopatch::parts {

/// A corner of an outline, mm, and the radius of the arc that rounds it, 0 for none.
struct Corner {
  double x, y, radius = 0;
};

/// A closed outline of lines and arcs in a plane, mm, whose area and first moment are known in closed form.
class Outline {
 public:
  explicit Outline(gp_Pnt2d start);
  /// A polygon, counterclockwise, with rounded corners; the rounds of neighbours may use their side up.
  static Outline polygon(const std::vector<Corner>& corners);
  static Outline rectangle(double width, double height, gp_Pnt2d lower_left = {0, 0}, double radius = 0);
  static Outline regular(int corners, double inner_radius);
  /// About two circles on the x axis, the first about the origin, and their common tangents.
  static Outline belt(double radius, double distance, double other_radius);

  /// A line of no length is left out.
  Outline& line_to(gp_Pnt2d end);
  /// An arc of less than a turn, counterclockwise or clockwise.
  Outline& arc_to(gp_Pnt2d end, gp_Pnt2d centre, bool counterclockwise = true);

  double area() const;
  /// The integral of x over the area: times 2 pi, the volume of the solid turned about the y axis.
  double first_moment() const;
  /// In the plane of `frame`. @throws std::runtime_error if it is open
  TopoDS_Face face(const gp_Ax3& frame) const;

 private:
  struct Piece {
    gp_Pnt2d from, to, centre;
    double angle = 0;  // swept, counterclockwise positive; 0: a line
  };
  gp_Pnt2d end() const { return pieces_.empty() ? start_ : pieces_.back().to; }

  gp_Pnt2d start_;
  std::vector<Piece> pieces_;
};

}  // namespace isopatch::parts
