#include "iga/estimate/element_errors.hpp"

#include <omp.h>

#include <Eigen/LU>
#include <cmath>

#include "iga/internal/parallel_for.hpp"
#include "iga/material/internal/point_fields.hpp"
#include "iga/spaces/internal/element_tensors.hpp"

namespace isopatch::iga {
namespace {

class ErrorOnElements {
 public:
  ErrorOnElements(const Discretization& d, std::size_t patch, const Material& material,
                  const Eigen::Matrix3Xd& error)
      : patch_(d.patches[patch]),
        material_(material),
        error_(error.data() + 3 * static_cast<Eigen::Index>(d.first_node[patch])),
        tensors_(patch_, gauss_rules(d.gauss_points[patch])) {}

  void compute(std::int64_t element, TensorBuffers<8>& buffers, ElementErrors& out) const {
    gather(tensors_, element, patch_, error_, buffers.coefficients);
    tensors_.gradients(element, buffers);
    double energy = 0, squares = 0, volume = 0;
    tensors_.for_each_point(element, [&](Eigen::Index point, double weight) {
      const auto q = static_cast<std::size_t>(point);
      const Eigen::Matrix3d jacobian = rational_point(buffers, q).derivatives;
      const Eigen::Matrix3d gradient = rational_point(buffers, q, 4).derivatives * jacobian.inverse();
      const Eigen::Matrix3d stress = stress_of_gradient(gradient, material_);
      const double measure = weight * jacobian.determinant();
      energy += 0.5 * measure * stress.cwiseProduct(gradient).sum();
      squares += measure * std::pow(von_mises(stress), 2);
      volume += measure;
    });
    out.energy[element] = energy;
    out.stress[element] = std::sqrt(squares / volume);
  }

 private:
  const geometry::NurbsVolume& patch_;
  const Material& material_;
  const double* error_;
  ElementTensors tensors_;
};

}  // namespace

std::vector<ElementErrors> element_errors(const Discretization& d, const std::vector<Material>& materials,
                                          const Eigen::Matrix3Xd& error,
                                          const std::vector<PatchLayers>& parts,
                                          const solvers::Processes& processes) {
  std::vector<ElementErrors> result;
  for (const geometry::NurbsVolume& patch : d.patches) {
    const Eigen::Index count = Eigen::Index{patch.knots(0).element_count()} * patch.knots(1).element_count() *
                               patch.knots(2).element_count();
    result.push_back({Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)});
  }
  std::vector<TensorBuffers<8>> buffers(static_cast<std::size_t>(omp_get_max_threads()));
  for (const PatchLayers& part : parts) {
    const auto p = static_cast<std::size_t>(part.patch);
    const ErrorOnElements of_patch(d, p, materials[p], error);
    const std::int64_t row = d.patches[p].knots(0).element_count();
    const std::int64_t layer = row * d.patches[p].knots(1).element_count();
    const std::int64_t first = layer * part.first_layer;
    parallel_for((layer * part.last_layer - first) / row, [&](std::int64_t task, int thread) {
      for (std::int64_t i = 0; i < row; ++i)
        of_patch.compute(first + task * row + i, buffers[static_cast<std::size_t>(thread)], result[p]);
    });
  }
  if (processes.count() > 1)
    for (ElementErrors& of_patch : result) {
      processes.sum(of_patch.energy);
      processes.sum(of_patch.stress);
    }
  return result;
}

}  // namespace isopatch::iga
