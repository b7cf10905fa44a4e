#include "geometry/brep/opencascade/internal/smooth_ranges.hpp"

#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isopatch::geometry {
namespace {

template <class Adaptor>
std::vector<double> intervals(const Adaptor& adaptor) {
  TColStd_Array1OfReal ends(1, adaptor.NbIntervals(GeomAbs_CN) + 1);
  adaptor.Intervals(ends, GeomAbs_CN);
  return {ends.begin(), ends.end()};
}

bool is_round(GeomAbs_CurveType type) {
  return type == GeomAbs_Circle || type == GeomAbs_Ellipse;
}

// Cut evenly into pieces of a right angle at most.
std::vector<double> quarters(double first, double last) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((last - first) / (std::numbers::pi / 2) - 1e-9)));
  std::vector<double> result;
  for (int i = 0; i <= pieces; ++i) result.push_back(first + (last - first) * i / pieces);
  return result;
}

template <class Adaptor, class Curve>
std::vector<double> ranges(const Curve& curve, double first, double last) {
  if (first > last) {
    std::vector<double> result = ranges<Adaptor>(curve, last, first);
    std::reverse(result.begin(), result.end());
    return result;
  }
  if (!(last > first)) return {first, last};
  const Adaptor adaptor(curve, first, last);
  std::vector<double> result = is_round(adaptor.GetType()) ? quarters(first, last) : intervals(adaptor);
  result.front() = first;
  result.back() = last;
  return result;
}

// What lies between, and its repetitions, if it is periodic.
std::vector<double> repeated(const std::vector<double>& places, double period, double low, double high) {
  std::vector<double> result;
  for (const double place : places) {
    if (!(period > 0)) {
      result.push_back(place);
      continue;
    }
    for (double at = place - period * std::floor((place - low) / period); at < high; at += period)
      result.push_back(at);
  }
  const double margin = 1e-12 * (high - low);
  std::erase_if(result, [&](double at) { return !(at > low + margin && at < high - margin); });
  std::sort(result.begin(), result.end());
  const auto same = [&](double a, double b) { return b - a <= margin; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

}  // namespace

std::vector<double> smooth_ranges(const Handle(Geom_Curve) & curve, double first, double last) {
  return ranges<GeomAdaptor_Curve>(curve, first, last);
}

std::vector<double> smooth_ranges(const Handle(Geom2d_Curve) & curve, double first, double last) {
  return ranges<Geom2dAdaptor_Curve>(curve, first, last);
}

std::vector<double> knots_between(const GeomAdaptor_Surface& surface, Direction direction, double low,
                                  double high) {
  const bool u = direction == Direction::u;
  TColStd_Array1OfReal ends(1, (u ? surface.NbUIntervals(GeomAbs_CN) : surface.NbVIntervals(GeomAbs_CN)) + 1);
  if (u)
    surface.UIntervals(ends, GeomAbs_CN);
  else
    surface.VIntervals(ends, GeomAbs_CN);
  if (ends.Length() <= 2) return {};  // nothing but its bounds
  double period = 0;
  if (u && surface.IsUPeriodic()) period = surface.UPeriod();
  if (!u && surface.IsVPeriodic()) period = surface.VPeriod();
  return repeated({ends.begin(), ends.end()}, period, low, high);
}

bool is_angle(const GeomAdaptor_Surface& surface, Direction direction) {
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_SurfaceOfRevolution:
      return direction == Direction::u;
    case GeomAbs_Sphere:
    case GeomAbs_Torus:
      return true;
    default:
      return false;
  }
}

}  // namespace isopatch::geometry
