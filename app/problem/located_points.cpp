#include "app/problem/located_points.hpp"

#include <cmath>

#include "app/base/place_outside.hpp"
#include "app/base/place_tolerance.hpp"
#include "geometry/base/error.hpp"
#include "geometry/quadrature.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::app {
namespace {

// Finds places in a model's patches.
class Finder {
 public:
  Finder(const geometry::MultiPatch& model, const Place& place) : model_(model), place_(place) {
    undeformed_.patches = model.patches();
    for (const auto& patch : model.patches())
      undeformed_.displacement.emplace_back(Eigen::Matrix3Xd::Zero(3, patch.size()));
    undeformed_.materials.resize(model.patches().size());
  }
  iga::PatchPoint operator()(const Eigen::Vector3d& wanted, double weight) const {
    const iga::Location found = iga::locate(undeformed_, wanted);
    if (found.distance > place_tolerance * model_.size())
      throw error_at(place_, outside_text(model_, wanted, found));
    return {PatchId(found.patch), found.parameter, weight};
  }

 private:
  const geometry::MultiPatch& model_;
  const Place& place_;
  iga::ElasticField undeformed_;
};

}  // namespace

std::vector<iga::PatchPoint> located_points(const geometry::MultiPatch& model,
                                            const std::vector<Eigen::Vector3d>& places, const Place& place) {
  const Finder find(model, place);
  std::vector<iga::PatchPoint> result;
  for (const Eigen::Vector3d& wanted : places)
    result.push_back(find(wanted, 1 / static_cast<double>(places.size())));
  return result;
}

std::vector<iga::PatchPoint> located_line(const geometry::MultiPatch& model,
                                          const std::vector<Eigen::Vector3d>& places, const Place& place) {
  constexpr int pieces = 100;
  const double whole = length_of(places);
  if (!(whole > 0)) throw error_at(place, "the line has no length: its points are one");
  const geometry::QuadratureRule rule = geometry::gauss_legendre(4);
  const Finder find(model, place);
  std::vector<iga::PatchPoint> result;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Eigen::Vector3d along = places[i + 1] - places[i];
    const double share = along.norm() / whole;
    const int count = static_cast<int>(std::ceil(share * pieces));
    for (int k = 0; k < count; ++k)
      for (Eigen::Index q = 0; q < rule.nodes.size(); ++q)
        result.push_back(
            find(places[i] + (k + rule.nodes[q]) / count * along, share / count * rule.weights[q]));
  }
  return result;
}

double length_of(const std::vector<Eigen::Vector3d>& places) {
  double result = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) result += (places[i + 1] - places[i]).norm();
  return result;
}

}  // namespace isopatch::app
