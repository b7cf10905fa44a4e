#include "iga/internal_forces.hpp"

#include "iga/internal/element_loop.hpp"

namespace isopatch::iga {
namespace {

struct ElementForces {
  ElementAt at;
  std::vector<int> functions;
  Eigen::MatrixXd forces;  // (n, 3)
  double energy = 0;
  double max_von_mises = 0;
  Eigen::Index worst_point = 0;
  Eigen::Vector3d worst_place;
};

void compute_element(const ElementValues& values, const Material& material,
                     const Eigen::Matrix3Xd& displacement, int first_node, ElementForces& out) {
  const auto n = static_cast<Eigen::Index>(values.functions.size());
  out.functions = values.functions;
  Eigen::Matrix3Xd u(3, n);
  for (Eigen::Index a = 0; a < n; ++a)
    u.col(a) = displacement.col(first_node + values.functions[static_cast<std::size_t>(a)]);
  out.forces.setZero(n, 3);
  out.energy = 0;
  out.max_von_mises = -1;
  for (Eigen::Index q = 0; q < values.measures.size(); ++q) {
    Eigen::Matrix3d gradient;
    for (int j = 0; j < 3; ++j) gradient.col(j) = u * values.gradients[static_cast<std::size_t>(j)].col(q);
    const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
    const Eigen::Matrix3d sigma = stress(strain, material);
    out.energy += 0.5 * values.measures[q] * sigma.cwiseProduct(strain).sum();
    for (int j = 0; j < 3; ++j)
      out.forces += values.measures[q] * values.gradients[static_cast<std::size_t>(j)].col(q) * sigma.row(j);
    const double equivalent = von_mises(sigma);
    if (equivalent > out.max_von_mises) {
      out.max_von_mises = equivalent;
      out.worst_point = q;
      out.worst_place = values.places.col(q);
    }
  }
}

}  // namespace

InternalForces internal_forces(const Discretization& d, const std::vector<Material>& materials,
                               const Eigen::Matrix3Xd& displacement, int points, const Progress& progress) {
  InternalForces result;
  result.forces = Eigen::Matrix3Xd::Zero(3, d.node_count());
  result.max_von_mises.value = -1;
  ElementAt worst;
  Eigen::Index worst_point = 0;
  struct NoScratch {};
  for_each_element<NoScratch, ElementForces>(
      d, points, 16384, progress, "stresses",
      [&](const ElementAt& at, const ElementValues& values, NoScratch&, ElementForces& element) {
        const auto p = static_cast<std::size_t>(at.patch);
        element.at = at;
        compute_element(values, materials[p], displacement, d.first_node[p], element);
      },
      [&](std::span<const ElementForces> elements) {
        for (const ElementForces& element : elements) {
          result.energy += element.energy;
          const int first = d.first_node[static_cast<std::size_t>(element.at.patch)];
          for (std::size_t a = 0; a < element.functions.size(); ++a)
            result.forces.col(first + element.functions[a]) +=
                element.forces.row(static_cast<Eigen::Index>(a)).transpose();
          if (element.max_von_mises > result.max_von_mises.value) {
            result.max_von_mises = {element.max_von_mises, element.worst_place, element.at.patch, {}};
            worst = element.at;
            worst_point = element.worst_point;
          }
        }
      });
  const ElementEvaluator evaluator(d.patches[static_cast<std::size_t>(worst.patch)], points);
  result.max_von_mises.parameter = evaluator.parameter(worst.element, worst_point);
  return result;
}

}  // namespace isopatch::iga
