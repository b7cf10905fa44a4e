#include "app/problem/resolution_warning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "iga/problem/springs.hpp"

namespace isopatch::app {
namespace {

constexpr double most_share = 0.02;      // of the energy: more is worth a warning
constexpr double wanted_share = 0.005;   // what the advice aims at
constexpr double incompressible = 0.45;  // Poisson's ratio from which volume changes may lock
constexpr int degree_against_locking = 4;
constexpr double oscillating = 0.49;  // Poisson's ratio from which a stress was 39 % wrong at degree 2

double highest_poisson(const iga::ElasticityProblem& problem) {
  double result = 0;
  for (const iga::Material& material : problem.materials) result = std::max(result, iga::poisson(material));
  return result;
}

std::array<int, 3> lowest_degree(const iga::Discretization& discretization) {
  std::array<int, 3> degree = {10, 10, 10};
  for (const auto& patch : discretization.patches)
    for (int d = 0; d < 3; ++d)
      degree[static_cast<std::size_t>(d)] = std::min(degree[static_cast<std::size_t>(d)], patch.degree(d));
  return degree;
}

// Halvings that bring a share that shrinks like h^(2 p) down to what is wanted.
int halvings(double share, int degree) {
  return std::clamp(static_cast<int>(std::ceil(std::log2(share / wanted_share) / (2 * degree))), 1, 5);
}

// Whether displacements are rather too small: forces act, for those of temperatures and prescribed
// displacements may err to either side; and no springs stand for holds, for these hold at points only, and a
// coarse part gives way between them.
bool is_too_stiff(const iga::ElasticityProblem& problem) {
  if (!iga::holds_among(iga::springs_of(problem)).empty()) return false;
  return !problem.surface_loads.empty() || !problem.volume_loads.empty() || !problem.point_loads.empty();
}

}  // namespace

double unresolved_share(const iga::ElasticityResults& results) {
  // Where a part is free to grow with its warmth, little is stored in it, and springs may hold the rest.
  const double stored = results.internal_energy + results.support_energy + results.interface_energy +
                        std::abs(results.thermal_work);
  return stored > 0 ? results.unresolved.total() / stored : 0;
}

std::optional<Warning> resolution_warning(const iga::ElasticityProblem& problem,
                                          const iga::ElasticityResults& results) {
  const double share = unresolved_share(results);
  if (!(share > most_share)) return std::nullopt;
  const std::array<int, 3> degrees = lowest_degree(problem.discretization);
  const auto& along = results.unresolved.along;
  const auto worst = static_cast<std::size_t>(std::max_element(along.begin(), along.end()) - along.begin());
  const int degree = degrees[worst];
  const double poisson = highest_poisson(problem);
  const std::string figure = fmt::format(
      "{:.1f} % of the energy is in the highest polynomials of the elements{}", 100 * share,
      is_too_stiff(problem) ? ", and displacements under loads are too small by about as much" : "");
  const int lowest = *std::min_element(degrees.begin(), degrees.end());
  if (poisson >= incompressible && results.unresolved.volumetric > 0.5 * results.unresolved.total())
    return Warning{fmt::format(
        "degree {} cannot keep the volume of nearly incompressible material (Poisson's ratio {:.4g}): {}. "
        "discretization.degree = {} mends it, or a refine that is higher by {}",
        lowest, poisson, figure, std::max(degree_against_locking, lowest + 1),
        halvings(share, std::max(1, lowest - 1)))};
  if (degree == 1)
    return Warning{
        fmt::format("elements of degree 1 (direction {} of the patches) cannot bend: {}. "
                    "discretization.degree = 2 mends it",
                    worst + 1, figure)};
  return Warning{
      fmt::format("the elements are large for what happens in them: {}. A refine that is higher by {} or a "
                  "discretization.degree of {} shows how much the figures still change",
                  figure, halvings(share, degree), std::min(degree + 1, 10))};
}

std::optional<Warning> pressure_warning(const iga::ElasticityProblem& problem) {
  const double poisson = highest_poisson(problem);
  if (!(poisson >= oscillating)) return std::nullopt;
  const double factor = poisson / (1 - 2 * poisson);  // lambda / (2 mu)
  return Warning{fmt::format(
      "Poisson's ratio {:.4g}: errors of the volume's change count {:.0f} times as much as other strains in "
      "the mean "
      "of the normal stresses, which oscillates. Displacements, shear and von Mises stress do not; "
      "components, "
      "principal stresses and their +- may be wrong by many times. A higher discretization.degree and "
      "isopatch compare --levels 3 show how much",
      poisson, factor)};
}

}  // namespace isopatch::app
