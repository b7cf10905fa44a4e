#include "iga/bezier_output.hpp"

#include <omp.h>

#include "geometry/splines/basis.hpp"
#include "geometry/splines/transfer.hpp"
#include "iga/internal/element_tensors.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/internal/point_fields.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;

// From the coefficients of the functions of each element of a direction to those of its Bezier piece.
std::vector<Eigen::MatrixXd> extractions(const KnotVector& knots) {
  const int p = knots.degree();
  const Eigen::MatrixXd all = geometry::transfer(knots, geometry::bezier_knots(knots));
  const std::vector<double> breaks = knots.breaks();
  std::vector<Eigen::MatrixXd> result;
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    result.emplace_back(all.block(static_cast<Eigen::Index>(e) * p, knots.span(breaks[e]) - p, p + 1, p + 1));
  return result;
}

// From values at the Gauss points of the unit interval to the Bernstein coefficients of their interpolant.
Eigen::MatrixXd interpolation(int degree) {
  const geometry::QuadratureRule rule = geometry::gauss_legendre(degree + 1);
  const KnotVector knots = KnotVector::bezier(degree);
  Eigen::MatrixXd values(degree + 1, degree + 1);
  for (Eigen::Index q = 0; q <= degree; ++q)
    values.row(q) = geometry::basis(knots, rule.nodes[q]).values.row(0);
  return values.inverse();
}

// One matrix along each direction of a tensor, in place.
void apply(const Eigen::MatrixXd& u, const Eigen::MatrixXd& v, const Eigen::MatrixXd& w,
           std::vector<Packet<8>>& tensor, std::vector<Packet<8>>& spare) {
  const Eigen::Index m = u.rows();
  const Eigen::Index n = v.rows();
  const Eigen::Index o = w.rows();
  spare.resize(tensor.size());
  contract<false, false, 8>(u, 1, n * o, tensor.data(), spare.data());
  contract<false, false, 8>(v, m, o, spare.data(), tensor.data());
  contract<false, false, 8>(w, m * n, 1, tensor.data(), spare.data());
  std::swap(tensor, spare);
}

// Of one cell: place, weight, displacement, stress, von Mises stress and det J at each point.
std::int64_t numbers_bytes(const NurbsVolume& patch) {
  std::int64_t bytes = 15 * sizeof(double);
  for (int d = 0; d < 3; ++d) bytes *= patch.degree(d) + 1;
  return bytes;
}

struct Scratch {
  TensorBuffers<8> fields;
  std::vector<Packet<8>> bezier;
  std::vector<Packet<8>> results;  // stress, von Mises, det J, times the weight function
  std::vector<Packet<8>> spare;
};

}  // namespace

struct BezierOutput::State {
  State(const ElasticField& field, int patch)
      : index(patch),
        patch(field.patches[static_cast<std::size_t>(patch)]),
        material(field.materials[static_cast<std::size_t>(patch)]),
        displacement(field.displacement[static_cast<std::size_t>(patch)]),
        tensors(this->patch, 0) {
    for (int d = 0; d < 3; ++d) {
      extraction[static_cast<std::size_t>(d)] = extractions(this->patch.knots(d));
      to_coefficients[static_cast<std::size_t>(d)] = interpolation(this->patch.degree(d));
    }
  }

  // The element's Bezier coefficients, and the fields' interpolants, both times the weights.
  void compute(std::int64_t element, Scratch& s) const {
    gather(tensors, element, patch, displacement.data(), s.fields.coefficients);
    tensors.gradients(element, s.fields);
    s.results.resize(static_cast<std::size_t>(tensors.point_count()));
    for (std::size_t q = 0; q < s.results.size(); ++q) {
      const RationalPoint place = rational_point(s.fields, q);
      const Eigen::Matrix3d gradient =
          rational_point(s.fields, q, 4).derivatives * place.derivatives.inverse();
      const Eigen::Matrix3d t = stress_of_gradient(gradient, material);
      s.results[q] << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2), von_mises(t),
          place.derivatives.determinant();
      s.results[q] *= s.fields.at[0][q][3];
    }
    apply(to_coefficients[0], to_coefficients[1], to_coefficients[2], s.results, s.spare);
    s.bezier = s.fields.coefficients;
    const auto of_direction = [&](std::size_t d) -> const Eigen::MatrixXd& {
      const auto count = static_cast<std::int64_t>(extraction[d].size());
      const Eigen::MatrixXd& matrix = extraction[d][static_cast<std::size_t>(element % count)];
      element /= count;
      return matrix;
    };
    const Eigen::MatrixXd& u = of_direction(0);
    const Eigen::MatrixXd& v = of_direction(1);
    apply(u, v, of_direction(2), s.bezier, s.spare);
  }

  int index;
  const NurbsVolume& patch;
  const Material& material;
  const Eigen::Matrix3Xd& displacement;
  ElementTensors tensors;
  std::array<std::vector<Eigen::MatrixXd>, 3> extraction;
  std::array<Eigen::MatrixXd, 3> to_coefficients;
};

BezierOutput::BezierOutput(const ElasticField& field, int patch)
    : state_(std::make_unique<State>(field, patch)) {}
BezierOutput::~BezierOutput() = default;
BezierOutput::BezierOutput(BezierOutput&&) noexcept = default;

int BezierOutput::cell_count() const {
  return static_cast<int>(state_->tensors.element_count());
}

geometry::BezierCells BezierOutput::cells(int first, int last) const {
  const NurbsVolume& patch = state_->patch;
  const Eigen::Index per_cell = state_->tensors.function_count();
  const Eigen::Index total = per_cell * (last - first);
  geometry::BezierCells cells;
  cells.degree = {patch.degree(0), patch.degree(1), patch.degree(2)};
  cells.cell_count = last - first;
  cells.points.resize(3, total);
  if (patch.is_rational()) cells.weights.resize(total);
  cells.point_fields = {{"displacement", Eigen::MatrixXd(3, total)},
                        {"stress", Eigen::MatrixXd(6, total)},
                        {"von_mises", Eigen::MatrixXd(1, total)},
                        {"jacobian", Eigen::MatrixXd(1, total)}};
  cells.cell_fields = {{"patch", Eigen::MatrixXd::Constant(1, cells.cell_count, state_->index)}};
  std::vector<Scratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
  constexpr int per_task = 8;
  parallel_for((cells.cell_count + per_task - 1) / per_task, [&](std::int64_t task, int thread) {
    Scratch& s = scratch[static_cast<std::size_t>(thread)];
    const int end = std::min(cells.cell_count, static_cast<int>(task + 1) * per_task);
    for (int cell = static_cast<int>(task) * per_task; cell < end; ++cell) {
      state_->compute(first + cell, s);
      for (Eigen::Index a = 0; a < per_cell; ++a) {
        const Eigen::Index at = per_cell * cell + a;
        const Packet<8>& place = s.bezier[static_cast<std::size_t>(a)];
        const double inverse = 1 / place[3];
        const Packet<8> results = inverse * s.results[static_cast<std::size_t>(a)];
        cells.points.col(at) = inverse * place.head<3>().matrix();
        if (cells.weights.size() > 0) cells.weights[at] = place[3];
        cells.point_fields[0].values.col(at) = inverse * place.segment<3>(4).matrix();
        cells.point_fields[1].values.col(at) = results.head<6>().matrix();
        cells.point_fields[2].values(0, at) = results[6];
        cells.point_fields[3].values(0, at) = results[7];
      }
    }
  });
  return cells;
}

geometry::BezierCells bezier_cells(const ElasticField& field, int patch) {
  const BezierOutput output(field, patch);
  return output.cells(0, output.cell_count());
}

std::int64_t bezier_bytes(const ElasticField& field) {
  std::int64_t bytes = 0;
  for (const NurbsVolume& patch : field.patches) {
    std::int64_t cells = 1;
    for (int d = 0; d < 3; ++d) cells *= patch.knots(d).element_count();
    bytes += cells * numbers_bytes(patch);
  }
  return bytes;
}

void write_bezier_cells(const ElasticField& field, int patch, const geometry::ByteSink& sink,
                        geometry::Precision precision) {
  const BezierOutput output(field, patch);
  const std::int64_t bytes_per_cell = numbers_bytes(field.patches[static_cast<std::size_t>(patch)]);
  const auto piece = static_cast<int>(std::max<std::int64_t>(1, (std::int64_t{16} << 20) / bytes_per_cell));
  std::vector<int> sizes;
  for (int start = 0; start < output.cell_count(); start += piece)
    sizes.push_back(std::min(piece, output.cell_count() - start));
  geometry::write_vtu(
      sizes,
      [&](std::size_t i) {
        const int start = static_cast<int>(i) * piece;
        return output.cells(start, start + sizes[i]);
      },
      sink, precision);
}

}  // namespace isopatch::iga
