#include "iga/estimate/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "iga/spaces/element_sheets.hpp"

namespace isopatch::iga {
namespace {

// Sums over the elements of each layer of a patch of what is left along the layer's direction.
class LayerErrors {
 public:
  LayerErrors(const geometry::NurbsVolume& patch, const ElementErrors& errors) {
    std::array<Eigen::Index, 3> counts{};
    for (int d = 0; d < 3; ++d) {
      counts[static_cast<std::size_t>(d)] = patch.knots(d).element_count();
      sums_[static_cast<std::size_t>(d)] = Eigen::VectorXd::Zero(patch.knots(d).element_count());
    }
    Eigen::Index element = 0;
    for (Eigen::Index k = 0; k < counts[2]; ++k)
      for (Eigen::Index j = 0; j < counts[1]; ++j)
        for (Eigen::Index i = 0; i < counts[0]; ++i, ++element) {
          sums_[0][i] += errors.along(0, element);
          sums_[1][j] += errors.along(1, element);
          sums_[2][k] += errors.along(2, element);
        }
  }
  double of(const ElementLayer& layer) const {
    return sums_[static_cast<std::size_t>(layer.direction)][layer.span];
  }

 private:
  std::array<Eigen::VectorXd, 3> sums_;
};

// Shares of the error, and of what would be left if all sheets were halved, that are not gone after in one
// refinement: the last sheets promise little for their price, and the next estimate knows better.
constexpr double least_left = 0.1;
constexpr double least_left_of_all = 2;

// What halving a sheet promises, and its price.
struct Offer {
  std::size_t sheet = 0;
  double gain = 0;   // energy of the error that it takes away
  double nodes = 0;  // control points that it adds
  double worth() const { return gain / nodes; }
};

// A knot adds one function along its direction for each of the others.
double nodes_added(const geometry::NurbsVolume& patch, int direction) {
  return 1.0 * patch.size() / patch.size(direction);
}

Offer offer_of(const Discretization& d, const std::vector<LayerErrors>& errors, const ElementSheet& sheet) {
  Offer offer;
  for (const ElementLayer& layer : sheet) {
    const auto p = static_cast<std::size_t>(layer.patch);
    const geometry::NurbsVolume& patch = d.patches[p];
    offer.gain += errors[p].of(layer) * (1 - std::pow(4.0, -patch.degree(layer.direction)));
    offer.nodes += nodes_added(patch, layer.direction);
  }
  return offer;
}

KnotPlace middle(const Discretization& d, const ElementLayer& layer) {
  const std::vector<double> breaks =
      d.patches[static_cast<std::size_t>(layer.patch)].knots(layer.direction).breaks();
  const auto span = static_cast<std::size_t>(layer.span);
  return {layer.patch, layer.direction, std::midpoint(breaks[span], breaks[span + 1])};
}

}  // namespace

std::vector<KnotPlace> knots_to_add(const Discretization& d, const std::vector<ElementErrors>& errors,
                                    double wanted, double growth, bool spread) {
  std::vector<LayerErrors> of_layers;
  double left = 0;
  for (std::size_t p = 0; p < d.patches.size(); ++p) {
    of_layers.emplace_back(d.patches[p], errors[p]);
    left += errors[p].along.sum();
  }
  const std::vector<ElementSheet> sheets = element_sheets(d, spread);
  std::vector<Offer> offers;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    offers.push_back(offer_of(d, of_layers, sheets[i]));
    offers.back().sheet = i;
  }
  std::stable_sort(offers.begin(), offers.end(),
                   [](const Offer& a, const Offer& b) { return a.worth() > b.worth(); });
  double gains = 0;
  for (const Offer& offer : offers) gains += offer.gain;
  const double enough = std::max({wanted, least_left * left, least_left_of_all * (left - gains)});
  std::vector<KnotPlace> result;
  double room = (growth - 1) * d.node_count();
  for (const Offer& offer : offers) {
    if (left <= enough || !(offer.gain > 0)) break;
    if (!result.empty() && offer.nodes > room) break;
    result.push_back(middle(d, sheets[offer.sheet].front()));
    left -= offer.gain;
    room -= offer.nodes;
  }
  return result;
}

}  // namespace isopatch::iga
