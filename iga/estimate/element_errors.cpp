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

// The values at the points of an element of which the shares of its directions are made.
struct PointValues {
  std::array<std::vector<Eigen::Vector3d>, 3> derivatives;  // of the error along each direction
  std::array<std::vector<double>, 3> stretches;             // |grad xi|^2 of each, times the volume
};

struct ElementScratch {
  TensorBuffers<8> buffers;
  PointValues points;
};

class ErrorOnElements {
 public:
  ErrorOnElements(const Discretization& d, std::size_t patch, const Material& material,
                  const Eigen::Matrix3Xd& error)
      : patch_(d.patches[patch]),
        material_(material),
        error_(error.data() + 3 * static_cast<Eigen::Index>(d.first_node[patch])),
        points_(d.gauss_points[patch]),
        tensors_(patch_, gauss_rules(points_)) {
    const auto rules = gauss_rules(points_);
    for (std::size_t i = 0; i < 3; ++i)
      oscillations_[i] = oscillation(patch_.degree(static_cast<int>(i)) - 1, rules[i]);
  }

  void compute(std::int64_t element, ElementScratch& scratch, ElementErrors& out) const {
    TensorBuffers<8>& buffers = scratch.buffers;
    resize(scratch.points);
    gather(tensors_, element, patch_, error_, buffers.coefficients);
    tensors_.gradients(element, buffers);
    double energy = 0, squares = 0, volume = 0;
    tensors_.for_each_point(element, [&](Eigen::Index point, double weight) {
      const auto q = static_cast<std::size_t>(point);
      const Eigen::Matrix3d jacobian = rational_point(buffers, q).derivatives;
      const Eigen::Matrix3d inverse = jacobian.inverse();
      const Eigen::Matrix3d along = rational_point(buffers, q, 4).derivatives;
      const Eigen::Matrix3d gradient = along * inverse;
      const Eigen::Matrix3d stress = stress_of_gradient(gradient, material_);
      const double measure = weight * jacobian.determinant();
      energy += 0.5 * measure * stress.cwiseProduct(gradient).sum();
      squares += measure * std::pow(von_mises(stress), 2);
      volume += measure;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto direction = static_cast<Eigen::Index>(i);
        scratch.points.derivatives[i][q] = along.col(direction);
        scratch.points.stretches[i][q] = measure * inverse.row(direction).squaredNorm();
      }
    });
    out.energy[element] = energy;
    out.stress[element] = std::sqrt(squares / volume);
    out.along.col(element) = energy * shares(scratch.points);
  }

 private:
  void resize(PointValues& points) const {
    for (std::size_t i = 0; i < 3; ++i) {
      points.derivatives[i].resize(static_cast<std::size_t>(tensors_.point_count()));
      points.stretches[i].resize(static_cast<std::size_t>(tensors_.point_count()));
    }
  }

  // Of the three directions, which add up to 1.
  Eigen::Vector3d shares(const PointValues& points) const {
    Eigen::Vector3d result;
    std::size_t inner = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto count = static_cast<std::size_t>(points_[i]);
      result[static_cast<Eigen::Index>(i)] =
          along_lines(oscillations_[i], count, inner, points.derivatives[i], points.stretches[i]);
      inner *= count;
    }
    const double sum = result.sum();
    return sum > 0 ? Eigen::Vector3d(result / sum) : Eigen::Vector3d::Constant(1. / 3);
  }

  // The sum over all lines of points along a direction.
  static double along_lines(const Eigen::VectorXd& oscillation, std::size_t count, std::size_t inner,
                            const std::vector<Eigen::Vector3d>& derivatives,
                            const std::vector<double>& stretches) {
    double sum = 0;
    for (std::size_t start = 0; start < derivatives.size(); ++start) {
      if (start / inner % count != 0) continue;
      Eigen::Vector3d part = Eigen::Vector3d::Zero();
      double stretch = 0;
      for (std::size_t i = 0; i < count; ++i) {
        part += oscillation[static_cast<Eigen::Index>(i)] * derivatives[start + i * inner];
        stretch += stretches[start + i * inner];
      }
      sum += stretch * part.squaredNorm();
    }
    return sum;
  }

  const geometry::NurbsVolume& patch_;
  const Material& material_;
  const double* error_;
  GaussPoints points_;
  ElementTensors tensors_;
  std::array<Eigen::VectorXd, 3> oscillations_;  // of each direction
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
    result.push_back(
        {Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count), Eigen::Matrix3Xd::Zero(3, count)});
  }
  std::vector<ElementScratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
  for (const PatchLayers& part : parts) {
    const auto p = static_cast<std::size_t>(part.patch);
    const ErrorOnElements of_patch(d, p, materials[p], error);
    const std::int64_t row = d.patches[p].knots(0).element_count();
    const std::int64_t layer = row * d.patches[p].knots(1).element_count();
    const std::int64_t first = layer * part.first_layer;
    parallel_for((layer * part.last_layer - first) / row, [&](std::int64_t task, int thread) {
      for (std::int64_t i = 0; i < row; ++i)
        of_patch.compute(first + task * row + i, scratch[static_cast<std::size_t>(thread)], result[p]);
    });
  }
  if (processes.count() > 1)
    for (ElementErrors& of_patch : result) {
      processes.sum(of_patch.energy);
      processes.sum(of_patch.stress);
      processes.sum(Eigen::Map<Eigen::VectorXd>(of_patch.along.data(), of_patch.along.size()));
    }
  return result;
}

}  // namespace isopatch::iga
