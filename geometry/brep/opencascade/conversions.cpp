#include "geometry/brep/opencascade/internal/conversions.hpp"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

namespace isopatch::geometry {
namespace {

TColStd_Array1OfReal breaks(const KnotVector& knots) {
  const std::vector<double> values = knots.breaks();
  TColStd_Array1OfReal result(1, static_cast<int>(values.size()));
  for (int i = 0; i < result.Length(); ++i) result(i + 1) = values[static_cast<std::size_t>(i)];
  return result;
}

TColStd_Array1OfInteger multiplicities(const KnotVector& knots) {
  const std::vector<int> values = knots.multiplicities();
  TColStd_Array1OfInteger result(1, static_cast<int>(values.size()));
  for (int i = 0; i < result.Length(); ++i) result(i + 1) = values[static_cast<std::size_t>(i)];
  return result;
}

}  // namespace

Handle(Geom_BSplineSurface) to_shape(const NurbsSurface& surface, double scale) {
  const int nu = surface.size(0), nv = surface.size(1);
  TColgp_Array2OfPnt points(1, nu, 1, nv);
  TColStd_Array2OfReal weights(1, nu, 1, nv);
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const Eigen::Index k = i + static_cast<Eigen::Index>(nu) * j;
      points(i + 1, j + 1) = to_point(scale * surface.control_points().col(k));
      weights(i + 1, j + 1) = surface.weights()(k);
    }
  return new Geom_BSplineSurface(points, weights, breaks(surface.knots(0)), breaks(surface.knots(1)),
                                 multiplicities(surface.knots(0)), multiplicities(surface.knots(1)),
                                 surface.degree(0), surface.degree(1));
}

Handle(Geom_BSplineCurve) to_shape(const NurbsCurve& curve, double scale) {
  TColgp_Array1OfPnt points(1, curve.size());
  TColStd_Array1OfReal weights(1, curve.size());
  for (int i = 0; i < curve.size(); ++i) {
    points(i + 1) = to_point(scale * curve.control_points().col(i));
    weights(i + 1) = curve.weights()(i);
  }
  return new Geom_BSplineCurve(points, weights, breaks(curve.knots(0)), multiplicities(curve.knots(0)),
                               curve.degree(0));
}

Handle(Geom2d_BSplineCurve) to_domain_curve(const NurbsCurve& curve) {
  TColgp_Array1OfPnt2d points(1, curve.size());
  TColStd_Array1OfReal weights(1, curve.size());
  for (int i = 0; i < curve.size(); ++i) {
    points(i + 1) = gp_Pnt2d(curve.control_points()(0, i), curve.control_points()(1, i));
    weights(i + 1) = curve.weights()(i);
  }
  return new Geom2d_BSplineCurve(points, weights, breaks(curve.knots(0)), multiplicities(curve.knots(0)),
                                 curve.degree(0));
}

NurbsCurve to_nurbs(const Geom_BSplineCurve& curve, double scale) {
  std::vector<double> knots;
  for (int i = 1; i <= curve.NbKnots(); ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(curve.Multiplicity(i)), curve.Knot(i));
  Eigen::Matrix3Xd points(3, curve.NbPoles());
  Eigen::VectorXd weights(curve.NbPoles());
  for (int i = 0; i < curve.NbPoles(); ++i) {
    points.col(i) = scale * to_eigen(curve.Pole(i + 1));
    weights(i) = curve.Weight(i + 1);
  }
  return NurbsCurve({KnotVector(curve.Degree(), std::move(knots))}, std::move(points), std::move(weights));
}

NurbsSurface to_nurbs(const Geom_BSplineSurface& surface, double scale) {
  std::vector<double> u, v;
  for (int i = 1; i <= surface.NbUKnots(); ++i)
    u.insert(u.end(), static_cast<std::size_t>(surface.UMultiplicity(i)), surface.UKnot(i));
  for (int i = 1; i <= surface.NbVKnots(); ++i)
    v.insert(v.end(), static_cast<std::size_t>(surface.VMultiplicity(i)), surface.VKnot(i));
  const int nu = surface.NbUPoles(), nv = surface.NbVPoles();
  Eigen::Matrix3Xd points(3, nu * nv);
  Eigen::VectorXd weights(nu * nv);
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      points.col(i + nu * j) = scale * to_eigen(surface.Pole(i + 1, j + 1));
      weights(i + nu * j) = surface.Weight(i + 1, j + 1);
    }
  return NurbsSurface(
      {KnotVector(surface.UDegree(), std::move(u)), KnotVector(surface.VDegree(), std::move(v))},
      std::move(points), std::move(weights));
}

NurbsCurve to_nurbs(const Geom2d_BSplineCurve& curve) {
  std::vector<double> knots;
  for (int i = 1; i <= curve.NbKnots(); ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(curve.Multiplicity(i)), curve.Knot(i));
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, curve.NbPoles());
  Eigen::VectorXd weights(curve.NbPoles());
  for (int i = 0; i < curve.NbPoles(); ++i) {
    points.col(i).head<2>() = to_eigen(curve.Pole(i + 1));
    weights(i) = curve.Weight(i + 1);
  }
  return NurbsCurve({KnotVector(curve.Degree(), std::move(knots))}, std::move(points), std::move(weights));
}

}  // namespace isopatch::geometry
