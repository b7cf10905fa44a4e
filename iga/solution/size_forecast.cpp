#include "iga/solution/size_forecast.hpp"

#include <algorithm>

#include "iga/assembly/pattern_forecast.hpp"

namespace isopatch::iga {
namespace {

// Measured, in bytes a node of the solution space.
constexpr double geometry_of_node = 100;     // a patch and what knot insertion holds beside it
constexpr double nodal_of_node = 350;        // global nodes, frames, loads, displacements
constexpr double multigrid_of_node = 1000;   // 550 to 650, and what results take afterwards
constexpr double multipliers_of_node = 300;  // minimal residuals keep more vectors, of every node
constexpr double system_of_row = 300;

constexpr double nearly_incompressible = 0.45;  // Poisson's ratio

// The largest share of the elements that one process has.
double largest_share(const DirectionKnots& knots, int processes) {
  if (processes == 1) return 1;
  std::vector<PatchSpace> spaces;
  for (std::size_t p = 0; p < knots.size() / 3; ++p)
    spaces.push_back({nullptr, {knots[3 * p], knots[3 * p + 1], knots[3 * p + 2]}, {}, false});
  std::vector<double> nodes(spaces.size());
  double total = 0;
  for (std::size_t p = 0; p < spaces.size(); ++p) total += nodes[p] = 1.0 * spaces[p].size();
  double largest = 0;
  for (const std::vector<PatchShare>& shares : distribute(spaces, processes)) {
    double own = 0;
    // All rows of a patch are kept where a stretch of it is.
    for (const PatchShare& share : shares) own += nodes[static_cast<std::size_t>(share.patch)];
    largest = std::max(largest, own / total);
  }
  return largest;
}

// Separators of widened groups are as much thicker: fill grows with the square, operations with the cube.
solvers::FactorForecast factor_of(const PatternForecast& pattern) {
  solvers::FactorForecast factor = solvers::forecast_factor(pattern.groups);
  const double square = pattern.widening * pattern.widening;
  factor.entries /= square;
  factor.flops /= square * pattern.widening;
  factor.largest_front /= square;
  return factor;
}

}  // namespace

SizeForecast forecast_size(const geometry::MultiPatch& model, const DirectionKnots& knots,
                           const std::vector<Material>& materials, Coupling coupling, int processes,
                           NonMatchingCoupling non_matching) {
  const PatternForecast pattern = forecast_pattern(model, knots, coupling);
  const double share = largest_share(knots, processes);
  const double nodes = static_cast<double>(pattern.nodes), rows = static_cast<double>(pattern.rows);
  SizeForecast result;
  result.nodes = pattern.nodes;
  result.unknowns = 3 * pattern.rows + pattern.multipliers;
  for (const geometry::KnotVector& line : knots) result.degree = std::max(result.degree, line.degree());
  result.coupling = coupling;
  result.has_mortar = non_matching == NonMatchingCoupling::mortar && !model.non_matching().empty();
  result.processes = processes;
  result.is_nearly_incompressible =
      std::any_of(materials.begin(), materials.end(),
                  [](const Material& material) { return poisson(material) > nearly_incompressible; });
  result.factor = factor_of(pattern);
  result.geometry_bytes = geometry_of_node * nodes;
  result.nodal_bytes = nodal_of_node * nodes;
  result.matrix_bytes = share * static_cast<double>(pattern.blocks) * (9 * sizeof(double) + sizeof(int));
  result.system_bytes = system_of_row * rows;
  result.multigrid_bytes = share * multigrid_of_node * rows;
  if (result.has_multipliers()) result.multigrid_bytes += multipliers_of_node * nodes;
  return result;
}

SizeForecast forecast_size(const Discretization& discretization, const std::vector<Material>& materials,
                           Coupling coupling, int processes, NonMatchingCoupling non_matching) {
  DirectionKnots knots;
  for (const geometry::NurbsVolume& patch : discretization.patches)
    for (int d = 0; d < 3; ++d) knots.push_back(patch.knots(d));
  return forecast_size(discretization.model, knots, materials, coupling, processes, non_matching);
}

}  // namespace isopatch::iga
