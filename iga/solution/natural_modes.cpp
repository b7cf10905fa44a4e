#include "iga/solution/natural_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/assembly/mass.hpp"
#include "iga/coupling/rigid_motions.hpp"
#include "iga/solution/assembled_system.hpp"
#include "iga/solution/size_forecast.hpp"
#include "iga/solution/solver_bytes.hpp"
#include "iga/solution/solver_choice.hpp"
#include "solvers/block_lanczos.hpp"
#include "solvers/block_product.hpp"
#include "solvers/cholmod_solver.hpp"
#include "solvers/mumps_solver.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using solvers::SymmetricBlockMatrix;

// More than any frequency of a part of this kind has copies: six rigid motions, three of a cube's.
constexpr int block_vectors = 8;
// Pairs beyond those wanted, among which the count finds a gap.
constexpr int beyond = 3;

void check(const ElasticityProblem& problem, const ModesOptions& options) {
  if (options.number < 1 || options.number > 200)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("number of modes is {}; its range is 1 .. 200", options.number));
  for (std::size_t p = 0; p < problem.materials.size(); ++p)
    if (!(problem.materials[p].density > 0))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("patch {} has no density; natural modes need one in every material", p));
}

// Vectors that the iteration may gather for so many modes.
int most_vectors(Index count) {
  return std::max(160, 6 * static_cast<int>(count));
}

// Refuses what does not fit: beside the stiffness and its factor there are the mass, the sum of both that is
// factorized, and the vectors with the mass times them; then the factor of the count.
void require_memory(const ElasticityProblem& problem, const ModesOptions& options, Index count) {
  const SizeForecast size =
      forecast_size(problem.discretization, problem.materials, Coupling::elimination, 1);
  const auto unknowns = static_cast<double>(size.unknowns);
  const double matrices = 2 * size.matrix_bytes;
  const double iteration = direct_bytes(size, solvers::Method::cholmod) +
                           8 * unknowns * (2 * most_vectors(count) + 6 * block_vectors);
  const double counting =
      options.count ? direct_bytes(size, solvers::Method::mumps) + 8 * unknowns * static_cast<double>(count)
                    : 0;
  const double needed = matrices + size.nodal_bytes + std::max(iteration, counting);
  solvers::SolverOptions limit;
  limit.memory_limit = options.memory_limit;
  const double available = available_bytes(limit, {});
  if (needed <= available) return;
  throw Error(
      ErrorCode::out_of_memory,
      fmt::format("{} modes of {} unknowns would take about {}, and {} are available: refine less, ask "
                  "for fewer with [modes] number, or raise [solver] memory_limit if you know better",
                  options.number, size.unknowns, gigabytes(needed), gigabytes(std::max(0.0, available))));
}

int rigid_motions_left(const CoupledProblem& coupled) {
  int count = 0;
  for (const FreeBody& body : free_bodies(*coupled.problem, coupled.global, coupled.frames))
    count += static_cast<int>(body.motions.size());
  return count;
}

MatrixXd times(const SymmetricBlockMatrix& matrix, const MatrixXd& x) {
  MatrixXd result(x.rows(), x.cols());
  for (Index j = 0; j < x.cols(); ++j) result.col(j) = multiply(matrix, x.col(j));
  return result;
}

// @param b  its blocks are where a has some, which has more where patches do not match
SymmetricBlockMatrix sum(const SymmetricBlockMatrix& a, double factor, const SymmetricBlockMatrix& b) {
  SymmetricBlockMatrix result = a;
  for (std::size_t row = 0; row < static_cast<std::size_t>(b.block_rows()); ++row) {
    auto at = static_cast<std::size_t>(a.row_start[row]);
    for (auto k = static_cast<std::size_t>(b.row_start[row]);
         k < static_cast<std::size_t>(b.row_start[row + 1]); ++k) {
      while (a.columns[at] != b.columns[k]) ++at;
      for (std::size_t i = 0; i < 9; ++i) result.values[9 * at + i] += factor * b.values[9 * k + i];
    }
  }
  return result;
}

// A square of frequencies below which most parts of this size have none: a bar's first is 10 times as large.
double shift_of(const ElasticityProblem& problem) {
  double speed = 0;  // squared, of the stiffest
  for (const Material& m : problem.materials) speed = std::max(speed, young(m) / m.density);
  return speed / std::pow(problem.discretization.model.size(), 2);
}

// Random displacements that supports allow.
MatrixXd start_block(const std::vector<const SupportFrame*>& frame_of_row) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  MatrixXd result = MatrixXd::Zero(3 * static_cast<Index>(frame_of_row.size()), block_vectors);
  for (std::size_t row = 0; row < frame_of_row.size(); ++row)
    for (int k = 0; k < frame_of_row[row]->free; ++k)
      for (Index j = 0; j < block_vectors; ++j) result(3 * static_cast<Index>(row) + k, j) = uniform(random);
  return result;
}

// Stiffness and mass of the free directions.
struct Pencil {
  AssembledSystem assembled;
  SymmetricBlockMatrix mass;
  const SymmetricBlockMatrix& stiffness() const { return assembled.system.stiffness; }
};

Pencil pencil_of(const CoupledProblem& coupled, const Progress& progress) {
  Pencil result{assembled_system(coupled, progress), {}};
  progress("mass", 0);
  result.mass = assemble_mass(coupled.discretization(), coupled.problem->materials,
                              result.assembled.numbering, coupled.points);
  std::vector<LoadOfRows> no_loads;
  apply_supports(result.mass, result.assembled.system.rows, result.assembled.frame_of_row, no_loads);
  // Fixed components have stiffness and no mass: no frequency at all.
  for (std::size_t row = 0; row < result.assembled.frame_of_row.size(); ++row)
    for (int k = result.assembled.frame_of_row[row]->free; k < 3; ++k)
      result.mass.values[9 * static_cast<std::size_t>(result.mass.row_start[row]) +
                         static_cast<std::size_t>(4 * k)] = 0;
  return result;
}

// Eigenpairs of the pencil, increasing, orthonormal in the mass.
struct Pairs {
  VectorXd values;
  MatrixXd vectors;
  double next_value;
};

Pairs lowest_pairs(const Pencil& pencil, int count, double shift) {
  const solvers::BlockOperator inverse = solvers::cholmod_block_inverse(
      shift > 0 ? sum(pencil.stiffness(), shift, pencil.mass) : pencil.stiffness());
  const auto mass = [&](const MatrixXd& x) { return times(pencil.mass, x); };
  const solvers::EigenPairs found = solvers::largest_eigenpairs(
      [&](const MatrixXd& x) { return inverse(mass(x)); }, mass, start_block(pencil.assembled.frame_of_row),
      {.count = count, .tolerance = 1e-9, .most_vectors = most_vectors(count)});
  // Once more in the space found, with the stiffness itself: the shift takes no digits then.
  const MatrixXd kx = times(pencil.stiffness(), found.vectors), mx = mass(found.vectors);
  const SymmetricEigen ritz = symmetric_eigen(found.vectors.transpose() * kx, found.vectors.transpose() * mx);
  return {ritz.values, found.vectors * ritz.vectors, found.next_value > 0 ? 1 / found.next_value - shift : 0};
}

// The pair after which the gap to the next is widest, not before those wanted.
Index last_before_gap(const Pairs& pairs, Index wanted) {
  Index best = wanted - 1;
  double widest = 0;
  for (Index i = wanted - 1; i < std::min(wanted + beyond, pairs.values.size()); ++i) {
    const double next = i + 1 < pairs.values.size() ? pairs.values[i + 1] : pairs.next_value;
    const double gap = next / pairs.values[i] - 1;
    if (gap > widest) {
      widest = gap;
      best = i;
    }
  }
  return best;
}

double frequency_of(double eigenvalue) {
  return std::sqrt(std::max(0.0, eigenvalue)) / (2 * std::numbers::pi);
}

void count_modes(const Pencil& pencil, const Pairs& pairs, Index wanted, NaturalModes& result) {
  const Index last = last_before_gap(pairs, wanted);
  const double next = last + 1 < pairs.values.size() ? pairs.values[last + 1] : pairs.next_value;
  const double between =
      next > pairs.values[last] ? 0.5 * (pairs.values[last] + next) : 1.001 * pairs.values[last];
  result.counted_to = frequency_of(between);
  result.counted = solvers::negative_eigenvalues(sum(pencil.stiffness(), -between, pencil.mass));
  if (result.counted == last + 1) return;
  throw Error(ErrorCode::not_converged,
              fmt::format("{} modes were found up to {:.6g} Hz, and the factors count {}; ask for another "
                          "number of modes",
                          last + 1, result.counted_to, result.counted));
}

std::vector<Eigen::Matrix3Xd> shape_of(const CoupledProblem& coupled, const AssembledSystem& assembled,
                                       const VectorXd& x) {
  const Eigen::Matrix3Xd of_rows = displacement_of_rows(x, assembled.frame_of_row, VectorXd::Zero(x.size()));
  const Discretization& d = coupled.discretization();
  std::vector<Eigen::Matrix3Xd> result;
  for (std::size_t p = 0; p < d.patches.size(); ++p) {
    Eigen::Matrix3Xd& shape = result.emplace_back(3, d.patches[p].size());
    for (Index i = 0; i < shape.cols(); ++i)
      shape.col(i) =
          of_rows.col(assembled.numbering.row_of_node[static_cast<std::size_t>(d.first_node[p] + i)]);
  }
  return result;
}

}  // namespace

NaturalModes natural_modes(const ElasticityProblem& problem, const ModesOptions& options,
                           const Progress& progress) {
  check(problem, options);
  Stopwatch watch;
  const CoupledProblem coupled = coupled_problem(problem, {.points = options.quadrature_points});
  NaturalModes result;
  result.rigid_motions = rigid_motions_left(coupled);
  const Index wanted = result.rigid_motions + options.number;
  const Index count = wanted + beyond;
  require_memory(problem, options, count);
  const Pencil pencil = pencil_of(coupled, progress);
  result.timings.push_back({"assembly", watch.lap()});
  progress("modes", 0);
  const double shift = result.rigid_motions > 0 ? shift_of(problem) : 0;
  const Pairs pairs = lowest_pairs(pencil, static_cast<int>(count), shift);
  if (pairs.values.size() < wanted)
    throw Error(ErrorCode::invalid_argument, fmt::format("the part has {} modes in this space, fewer than {}",
                                                         pairs.values.size(), wanted));
  result.timings.push_back({"modes", watch.lap()});
  if (options.count) {
    progress("counting the modes", 0);
    count_modes(pencil, pairs, wanted, result);
  }
  result.timings.push_back({"count", watch.lap()});
  const MatrixXd x = pairs.vectors.leftCols(wanted);
  const MatrixXd kx = times(pencil.stiffness(), x), mx = times(pencil.mass, x);
  result.worst_orthogonality =
      (x.transpose() * mx - MatrixXd::Identity(wanted, wanted)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  const double scale = kx.col(result.rigid_motions).norm();
  for (Index i = 0; i < wanted; ++i) {
    const double value = pairs.values[i];
    const bool is_rigid = i < result.rigid_motions;
    const VectorXd rest = kx.col(i) - value * mx.col(i);
    result.modes.push_back({is_rigid ? 0 : frequency_of(value), is_rigid,
                            shape_of(coupled, pencil.assembled, x.col(i)),
                            rest.norm() / (is_rigid ? scale : kx.col(i).norm())});
  }
  return result;
}

}  // namespace isopatch::iga
