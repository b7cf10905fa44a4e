#include "geometry/brep/opencascade/internal/domain_curve.hpp"

#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>

namespace isopatch::geometry {

Handle(Geom2d_Curve) domain_curve(const Eigen::VectorXd& t, const Eigen::Matrix2Xd& points, double near) {
  const Eigen::Index last = t.size() - 1;
  const Eigen::Vector2d slope = (points.col(last) - points.col(0)) / (t[last] - t[0]);
  double off = 0;
  for (Eigen::Index i = 0; i <= last; ++i)
    off = std::max(off, (points.col(0) + (t[i] - t[0]) * slope - points.col(i)).norm());
  const auto point = [&](Eigen::Index i) { return gp_Pnt2d(points(0, i), points(1, i)); };
  if (off <= near && std::abs(slope.norm() - 1) < 1e-9) {
    const gp_Dir2d along(slope.x(), slope.y());
    return new Geom2d_Line(point(0).Translated(-t[0] * gp_Vec2d(along)), along);
  }
  if (off <= near) {
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = point(0);
    poles(2) = point(last);
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = t[0];
    knots(2) = t[last];
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
  }
  const Handle(TColgp_HArray1OfPnt2d) all = new TColgp_HArray1OfPnt2d(1, static_cast<int>(last) + 1);
  const Handle(TColStd_HArray1OfReal) at = new TColStd_HArray1OfReal(1, static_cast<int>(last) + 1);
  for (Eigen::Index i = 0; i <= last; ++i) {
    all->SetValue(static_cast<int>(i) + 1, point(i));
    at->SetValue(static_cast<int>(i) + 1, t[i]);
  }
  Geom2dAPI_Interpolate interpolation(all, at, false, 0);
  interpolation.Perform();
  return Handle(Geom2d_Curve)(interpolation.Curve());
}

}  // namespace isopatch::geometry
