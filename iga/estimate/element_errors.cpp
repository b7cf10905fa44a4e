#include "iga/estimate/element_errors.hpp"

#include <omp.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

#include "iga/internal/parallel_for.hpp"
#include "iga/material/internal/point_fields.hpp"
#include "iga/spaces/internal/element_tensors.hpp"

namespace isopatch::iga {
namespace {

// The Legendre polynomial of a degree, of norm 1 on [0, 1], times the weights of a rule: what a function is
// multiplied by to find how much of it oscillates so.
Eigen::VectorXd oscillation(int degree, const geometry::QuadratureRule& rule) {
  Eigen::VectorXd result(rule.nodes.size());
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = rule.weights[i] * std::sqrt(2 * degree + 1) *
                std::legendre(static_cast<unsigned>(degree), 2 * rule.nodes[i] - 1);
  return result;
}

// The geometry at a quadrature point: the same for all error components.
struct PointMap {
  Eigen::Matrix3d inverse;  // of the derivatives
  double measure = 0;       // weight times det J, m^3
  double denominator = 0;   // one over W
};

struct ElementScratch {
  TensorBuffers<4> geometry, error;
  std::vector<PointMap> maps;
  std::array<std::vector<double>, 3> stretches;           // |grad xi|^2 of each direction, times the volume
  std::array<std::vector<FieldLanes<4>>, 3> derivatives;  // of the error along each direction, and 0
};

// Several errors on the elements of one patch.
class ErrorsOnElements {
 public:
  ErrorsOnElements(const Discretization& d, std::size_t patch, const Material& material,
                   const std::vector<Eigen::Matrix3Xd>& errors)
      : patch_(d.patches[patch]),
        material_(material),
        points_(d.gauss_points[patch]),
        tensors_(patch_, gauss_rules(points_)) {
    for (const Eigen::Matrix3Xd& error : errors)
      errors_.emplace_back(error.middleCols(d.first_node[patch], patch_.size()));
    const auto rules = gauss_rules(points_);
    for (std::size_t i = 0; i < 3; ++i)
      oscillations_[i] = oscillation(patch_.degree(static_cast<int>(i)) - 1, rules[i]);
  }

  // @param out  of each error, for all patches
  void compute(std::int64_t element, ElementScratch& scratch, std::size_t patch,
               std::vector<std::vector<ElementErrors>>& out) const {
    const double volume = evaluate_map(element, scratch);
    for (std::size_t i = 0; i < errors_.size(); ++i) compute(element, i, volume, scratch, out[i][patch]);
  }

 private:
  // The element's volume.
  double evaluate_map(std::int64_t element, ElementScratch& scratch) const {
    const auto count = static_cast<std::size_t>(tensors_.point_count());
    scratch.maps.resize(count);
    for (std::size_t i = 0; i < 3; ++i) {
      scratch.stretches[i].resize(count);
      scratch.derivatives[i].resize(count);
    }
    gather(tensors_, element, patch_.control_points(), patch_.weights(), scratch.geometry.coefficients);
    tensors_.gradients(element, scratch.geometry);
    double volume = 0;
    tensors_.for_each_point(element, [&](Eigen::Index point, double weight) {
      const auto q = static_cast<std::size_t>(point);
      const Eigen::Matrix3d jacobian = rational_point(scratch.geometry, q).derivatives;
      PointMap& map = scratch.maps[q];
      map = {jacobian.inverse(), weight * jacobian.determinant(), 1 / scratch.geometry.at[0][q][3]};
      volume += map.measure;
      for (std::size_t i = 0; i < 3; ++i)
        scratch.stretches[i][q] = map.measure * map.inverse.row(static_cast<Eigen::Index>(i)).squaredNorm();
    });
    return volume;
  }

  void compute(std::int64_t element, std::size_t which, double volume, ElementScratch& scratch,
               ElementErrors& out) const {
    gather(tensors_, element, errors_[which], patch_.weights(), scratch.error.coefficients);
    tensors_.gradients(element, scratch.error);
    const double lambda = material_.lambda, mu = material_.mu;
    double energy = 0, squares = 0;
    for (std::size_t q = 0; q < scratch.maps.size(); ++q) {
      const PointMap& map = scratch.maps[q];
      const auto [along, gradient] = point_derivatives(scratch.error, q, map.inverse, map.denominator);
      const auto& [x, y, z] = gradient;
      for (std::size_t i = 0; i < 3; ++i) scratch.derivatives[i][q] = along[i];
      const double xy = x[1] + y[0], yz = y[2] + z[1], zx = z[0] + x[2];
      const double shear = xy * xy + yz * yz + zx * zx, trace = x[0] + y[1] + z[2];
      const double a = x[0] - y[1], b = y[1] - z[2], c = z[2] - x[0];
      energy += 0.5 * map.measure *
                (lambda * trace * trace + mu * (2 * (x[0] * x[0] + y[1] * y[1] + z[2] * z[2]) + shear));
      squares += map.measure * mu * mu * (2 * (a * a + b * b + c * c) + 3 * shear);  // of von Mises' stress
    }
    out.energy[element] = energy;
    out.stress[element] = std::sqrt(squares / volume);
    out.along.col(element) = energy * shares(scratch);
  }

  // Shares of the error energy along the three directions, which add up to 1.
  Eigen::Vector3d shares(const ElementScratch& at) const {
    Eigen::Vector3d result;
    std::size_t inner = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto count = static_cast<std::size_t>(points_[i]);
      result[static_cast<Eigen::Index>(i)] =
          along_lines(oscillations_[i], count, inner, at.derivatives[i], at.stretches[i]);
      inner *= count;
    }
    const double sum = result.sum();
    return sum > 0 ? Eigen::Vector3d(result / sum) : Eigen::Vector3d::Constant(1. / 3);
  }

  // The sum over all lines of points along a direction.
  static double along_lines(const Eigen::VectorXd& oscillation, std::size_t count, std::size_t inner,
                            const std::vector<FieldLanes<4>>& derivatives,
                            const std::vector<double>& stretches) {
    double sum = 0;
    for (std::size_t layer = 0; layer < derivatives.size(); layer += count * inner)
      for (std::size_t start = layer; start < layer + inner; ++start) {
        FieldLanes<4> part = FieldLanes<4>::Zero();
        double stretch = 0;
        for (std::size_t i = 0; i < count; ++i) {
          part += oscillation[static_cast<Eigen::Index>(i)] * derivatives[start + i * inner];
          stretch += stretches[start + i * inner];
        }
        sum += stretch * part.square().sum();
      }
    return sum;
  }

  const geometry::NurbsVolume& patch_;
  const Material& material_;
  std::vector<Eigen::Matrix3Xd> errors_;  // of this patch
  GaussPoints points_;
  ElementTensors tensors_;
  std::array<Eigen::VectorXd, 3> oscillations_;  // of each direction
};

}  // namespace

std::vector<std::vector<ElementErrors>> element_errors(const Discretization& d,
                                                       const std::vector<Material>& materials,
                                                       const std::vector<Eigen::Matrix3Xd>& errors,
                                                       const std::vector<PatchLayers>& parts,
                                                       const solvers::Processes& processes) {
  std::vector<ElementErrors> nothing;
  for (const geometry::NurbsVolume& patch : d.patches) {
    const Eigen::Index count = Eigen::Index{patch.knots(0).element_count()} * patch.knots(1).element_count() *
                               patch.knots(2).element_count();
    nothing.push_back(
        {Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count), Eigen::Matrix3Xd::Zero(3, count)});
  }
  std::vector<std::vector<ElementErrors>> result(errors.size(), nothing);
  std::vector<ElementScratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
  for (const PatchLayers& part : parts) {
    const auto p = static_cast<std::size_t>(part.patch);
    const ErrorsOnElements of_patch(d, p, materials[p], errors);
    const std::int64_t row = d.patches[p].knots(0).element_count();
    const std::int64_t layer = row * d.patches[p].knots(1).element_count();
    const std::int64_t first = layer * part.first_layer;
    parallel_for((layer * part.last_layer - first) / row, [&](std::int64_t task, int thread) {
      for (std::int64_t i = 0; i < row; ++i)
        of_patch.compute(first + task * row + i, scratch[static_cast<std::size_t>(thread)], p, result);
    });
  }
  if (processes.count() > 1)
    for (std::vector<ElementErrors>& of_error : result)
      for (ElementErrors& of_patch : of_error) {
        processes.sum(of_patch.energy);
        processes.sum(of_patch.stress);
        processes.sum(Eigen::Map<Eigen::VectorXd>(of_patch.along.data(), of_patch.along.size()));
      }
  return result;
}

}  // namespace isopatch::iga
