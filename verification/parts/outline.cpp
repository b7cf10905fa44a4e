#include "verification/parts/internal/outline.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec2d.hxx>
#include <numbers>
#include <stdexcept>

namespace isopatch::parts {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double no_length = 1e-9;  // mm: far below what CAD files distinguish (1e-7)

/// Of an arc from a to b about a centre: in (0, 2 pi), or (-2 pi, 0) clockwise.
double swept_angle(gp_Pnt2d a, gp_Pnt2d b, gp_Pnt2d centre, bool counterclockwise) {
  const gp_Vec2d from(centre, a), to(centre, b);
  const double angle = std::atan2(from.Crossed(to), from.Dot(to));
  if (counterclockwise) return angle > 0 ? angle : angle + 2 * pi;
  return angle < 0 ? angle : angle - 2 * pi;
}

}  // namespace

Outline::Outline(gp_Pnt2d start) : start_(start) {}

Outline Outline::polygon(const std::vector<Corner>& corners) {
  std::vector<gp_Pnt2d> before, after, centres;  // where rounds begin and end
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& here = corners[i];
    const Corner& last = corners[(i + corners.size() - 1) % corners.size()];
    const Corner& next = corners[(i + 1) % corners.size()];
    const gp_Pnt2d corner(here.x, here.y);
    const gp_Vec2d back = gp_Vec2d(corner, {last.x, last.y}).Normalized();
    const gp_Vec2d on = gp_Vec2d(corner, {next.x, next.y}).Normalized();
    const double half = std::acos(back.Dot(on)) / 2;
    const double length = here.radius / std::tan(half);
    before.push_back(corner.Translated(back * length));
    after.push_back(corner.Translated(on * length));
    centres.push_back(corner.Translated((back + on).Normalized() * (here.radius / std::sin(half))));
  }
  Outline result(after[0]);
  for (std::size_t k = 1; k <= corners.size(); ++k) {
    const std::size_t i = k % corners.size();
    result.line_to(before[i]);
    const bool left = gp_Vec2d(result.end(), centres[i]).Crossed(gp_Vec2d(result.end(), after[i])) < 0;
    if (corners[i].radius > 0) result.arc_to(after[i], centres[i], left);
  }
  return result;
}

Outline Outline::rectangle(double width, double height, gp_Pnt2d lower_left, double radius) {
  const double x = lower_left.X(), y = lower_left.Y();
  return polygon(
      {{x, y, radius}, {x + width, y, radius}, {x + width, y + height, radius}, {x, y + height, radius}});
}

Outline Outline::regular(int corners, double inner_radius) {
  std::vector<Corner> places;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners, radius = inner_radius / std::cos(pi / corners);
    places.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon(places);
}

Outline Outline::belt(double radius, double distance, double other_radius) {
  const double angle = std::acos((radius - other_radius) / distance);
  const double c = std::cos(angle), s = std::sin(angle);
  const gp_Pnt2d other(distance, 0);
  return Outline({other_radius * c + distance, -other_radius * s})
      .arc_to({other_radius * c + distance, other_radius * s}, other)
      .line_to({radius * c, radius * s})
      .arc_to({radius * c, -radius * s}, {0, 0})
      .line_to({other_radius * c + distance, -other_radius * s});
}

Outline& Outline::line_to(gp_Pnt2d end_point) {
  if (end().Distance(end_point) > no_length) pieces_.push_back({end(), end_point, {}, 0});
  return *this;
}

Outline& Outline::arc_to(gp_Pnt2d end_point, gp_Pnt2d centre, bool counterclockwise) {
  pieces_.push_back({end(), end_point, centre, swept_angle(end(), end_point, centre, counterclockwise)});
  return *this;
}

// By Green's theorem, piece by piece: 1/2 of the integral of x dy - y dx.
double Outline::area() const {
  double sum = 0;
  for (const Piece& piece : pieces_) {
    const gp_Pnt2d &a = piece.from, &b = piece.to, &c = piece.centre;
    if (piece.angle == 0)
      sum += a.X() * b.Y() - b.X() * a.Y();
    else
      sum += c.SquareDistance(a) * piece.angle + c.X() * (b.Y() - a.Y()) - c.Y() * (b.X() - a.X());
  }
  return sum / 2;
}

// 1/2 of the integral of x^2 dy.
double Outline::first_moment() const {
  double sum = 0;
  for (const Piece& piece : pieces_) {
    const gp_Pnt2d &a = piece.from, &b = piece.to, &c = piece.centre;
    if (piece.angle == 0) {
      sum += (b.Y() - a.Y()) * (a.X() * a.X() + a.X() * b.X() + b.X() * b.X()) / 3;
      continue;
    }
    const double r = c.Distance(a), from = std::atan2(a.Y() - c.Y(), a.X() - c.X());
    const auto integral = [&](double t) {
      const double sine = std::sin(t);
      return c.X() * c.X() * r * sine + 2 * c.X() * r * r * (t / 2 + std::sin(2 * t) / 4) +
             r * r * r * (sine - sine * sine * sine / 3);
    };
    sum += integral(from + piece.angle) - integral(from);
  }
  return sum / 2;
}

TopoDS_Face Outline::face(const gp_Ax3& frame) const {
  if (end().Distance(start_) > no_length) throw std::runtime_error("an outline is open");
  const auto in_space = [&](gp_Pnt2d p) {
    return frame.Location().Translated(gp_Vec(frame.XDirection()) * p.X() +
                                       gp_Vec(frame.YDirection()) * p.Y());
  };
  BRepBuilderAPI_MakeWire wire;
  for (const Piece& piece : pieces_) {
    const gp_Pnt a = in_space(piece.from), b = in_space(piece.to);
    const gp_Dir axis = piece.angle < 0 ? frame.Direction().Reversed() : frame.Direction();
    if (piece.angle == 0) {
      wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge());
    } else {
      const gp_Circ circle(gp_Ax2(in_space(piece.centre), axis), piece.centre.Distance(piece.from));
      wire.Add(BRepBuilderAPI_MakeEdge(circle, a, b).Edge());
    }
  }
  return BRepBuilderAPI_MakeFace(gp_Pln(frame), wire.Wire()).Face();
}

}  // namespace isopatch::parts
