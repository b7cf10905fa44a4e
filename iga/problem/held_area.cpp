#include "iga/problem/held_area.hpp"

#include <algorithm>

#include "iga/problem/internal/face_quadrature.hpp"
#include "iga/problem/internal/held_parts.hpp"
#include "iga/problem/loads.hpp"

namespace isopatch::iga {
namespace {

// The share of the functions at a point of a face that are held.
double held_share(const geometry::NurbsSurface& surface, const std::vector<char>& is_held,
                  const DirectionTable::Element& u, Eigen::Index qu, const DirectionTable::Element& v,
                  Eigen::Index qv) {
  double held = 0, all = 0;
  for (Eigen::Index b = 0; b < v.values.cols(); ++b)
    for (Eigen::Index a = 0; a < u.values.cols(); ++a) {
      const Eigen::Index i = u.first + a + surface.size(0) * (v.first + b);
      const double value = surface.weights()[i] * u.values(qu, a) * v.values(qv, b);
      all += value;
      if (is_held[static_cast<std::size_t>(i)]) held += value;
    }
  return held / all;
}

void add_face(const geometry::NurbsVolume& patch, geometry::Side side, const Region& region,
              HeldArea& result) {
  const std::vector<int> all = geometry::face_control_points(patch.sizes(), side);
  const std::vector<int> held = held_control_points(patch, side, region);
  std::vector<char> is_held;
  for (const int node : all)
    is_held.push_back(std::find(held.begin(), held.end(), node) != held.end() ? char{1} : char{0});
  const FaceQuadrature whole(patch, side);
  const DirectionTable::Element *last_u = nullptr, *last_v = nullptr;
  bool is_inside = false;
  whole.for_each([&](const FacePoint& point, const DirectionTable::Element& u, Eigen::Index qu,
                     const DirectionTable::Element& v, Eigen::Index qv) {
    result.held += point.area * held_share(whole.surface(), is_held, u, qu, v, qv);
    if (&u != last_u || &v != last_v) {
      result.has_element = result.has_element || is_inside;
      is_inside = true;
      last_u = &u;
      last_v = &v;
    }
    is_inside = is_inside && region.contains(point.place);
  });
  result.has_element = result.has_element || is_inside;
}

}  // namespace

HeldArea held_area(const std::vector<geometry::NurbsVolume>& patches, const Support& support) {
  HeldArea result;
  for (const geometry::PatchFace& face : support.faces)
    add_face(patches.at(static_cast<std::size_t>(face.patch.value)), face.side, support.region, result);
  result.asked = area_of(patches, support.faces, support.region);
  return result;
}

}  // namespace isopatch::iga
