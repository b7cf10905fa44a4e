#include "verification/suites/exact_solution.hpp"

#include <cmath>

#include "iga/spaces/element.hpp"

namespace isopatch::verification {
namespace {

// sum of stress times strain, twice the energy's density.
double density(const Eigen::Matrix3d& gradient, const iga::Material& material) {
  return stress_of(gradient, material).cwiseProduct(gradient).sum();
}

}  // namespace

Eigen::Matrix3d stress_of(const Eigen::Matrix3d& gradient, const iga::Material& material) {
  return iga::stress(0.5 * (gradient + gradient.transpose()), material);
}

Errors errors(const iga::ElasticField& field, const ExactSolution& exact, int points) {
  Eigen::Array4d sums = Eigen::Array4d::Zero();
  iga::ElementValues values;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const iga::ElementEvaluator evaluator(field.patches[p], points);
    for (std::int64_t e = 0; e < evaluator.element_count(); ++e) {
      evaluator.evaluate(e, values);
      Eigen::Matrix3Xd u(3, static_cast<Eigen::Index>(values.functions.size()));
      for (Eigen::Index a = 0; a < u.cols(); ++a)
        u.col(a) = field.displacement[p].col(values.functions[static_cast<std::size_t>(a)]);
      for (Eigen::Index q = 0; q < values.measures.size(); ++q) {
        Eigen::Matrix3d gradient;
        for (int j = 0; j < 3; ++j)
          gradient.col(j) = u * values.gradients[static_cast<std::size_t>(j)].col(q);
        const Eigen::Vector3d place = values.places.col(q);
        const Eigen::Vector3d displacement = exact.displacement(place);
        const Eigen::Matrix3d exact_gradient = exact.gradient(place);
        sums += values.measures[q] * Eigen::Array4d((u * values.values.col(q) - displacement).squaredNorm(),
                                                    displacement.squaredNorm(),
                                                    density(gradient - exact_gradient, field.materials[p]),
                                                    density(exact_gradient, field.materials[p]));
      }
    }
  }
  return {std::sqrt(sums[0] / sums[1]), std::sqrt(sums[2] / sums[3])};
}

}  // namespace isopatch::verification
