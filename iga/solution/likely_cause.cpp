#include "iga/solution/likely_cause.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace isopatch::iga {
namespace {

int highest_degree(const Discretization& d) {
  int degree = 0;
  for (const geometry::NurbsVolume& patch : d.patches)
    for (int direction = 0; direction < 3; ++direction) degree = std::max(degree, patch.degree(direction));
  return degree;
}

std::string of_points(const ElasticityProblem& problem, int points) {
  if (!has_too_few_points(problem.discretization, points)) return {};
  const int degree = highest_degree(problem.discretization);
  return fmt::format(
      "{} Gauss {} per direction {} too few for degree {}, so that motions may have no energy: use {} or "
      "the default, points = 0",
      points, points == 1 ? "point" : "points", points == 1 ? "is" : "are", degree, degree + 1);
}

// The stiffness against a change of volume over that against a change of shape is about 1 / (1 - 2 nu).
std::string of_poisson(const ElasticityProblem& problem) {
  constexpr double hard = 0.4999;
  double worst = 0;
  for (const Material& material : problem.materials) worst = std::max(worst, poisson(material));
  if (worst < hard) return {};
  return fmt::format(
      "a Poisson's ratio of {:.9g} makes a material {:.0e} times as stiff against a change of volume as "
      "against one of shape: use at most 0.4999",
      worst, 1 / (1 - 2 * worst));
}

std::string of_materials(const ElasticityProblem& problem) {
  constexpr double hard = 1e8;
  double least = 1e300, most = 0;
  for (const Material& material : problem.materials) {
    least = std::min(least, young(material));
    most = std::max(most, young(material));
  }
  if (most < hard * least) return {};
  return fmt::format(
      "the stiffest material has a Young's modulus {:.0e} times that of the softest: check their units",
      most / least);
}

// Mean length of a patch's control polygons along a direction.
double mean_length(const geometry::NurbsVolume& patch, int direction) {
  int stride = 1;
  for (int d = 0; d < direction; ++d) stride *= patch.size(d);
  const int count = patch.size(direction);
  double total = 0;
  for (int i = 0; i < patch.size(); ++i)
    if (i / stride % count + 1 < count)
      total += (patch.control_points().col(i + stride) - patch.control_points().col(i)).norm();
  return total * count / patch.size();
}

std::string of_shape(const ElasticityProblem& problem) {
  constexpr double hard = 500;
  double most = 1;
  std::size_t thinnest = 0;
  const auto& patches = problem.discretization.model.patches();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Eigen::Vector3d lengths(mean_length(patches[p], 0), mean_length(patches[p], 1),
                                  mean_length(patches[p], 2));
    const double ratio = lengths.maxCoeff() / lengths.minCoeff();
    if (ratio <= most) continue;
    most = ratio;
    thinnest = p;
  }
  if (most < hard) return {};
  return fmt::format("patch {} is {:.0f} times as long as thick: make it of several patches or elements",
                     thinnest, most);
}

}  // namespace

bool has_too_few_points(const Discretization& discretization, int points) {
  return points > 0 && points <= highest_degree(discretization);
}

std::string likely_cause(const ElasticityProblem& problem, int points) {
  std::vector<std::string> causes;
  for (std::string cause :
       {of_points(problem, points), of_poisson(problem), of_materials(problem), of_shape(problem)})
    if (!cause.empty()) causes.push_back(std::move(cause));
  if (causes.empty())
    return "look for parts that are held in few points only, for extreme differences of stiffness and for "
           "badly shaped "
           "patches";
  return fmt::format("{}", fmt::join(causes, "; "));
}

}  // namespace isopatch::iga
