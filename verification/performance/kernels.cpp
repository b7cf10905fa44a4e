#include "verification/performance/kernels.hpp"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <memory>
#include <numeric>
#include <string>

#include "geometry/models/box.hpp"
#include "geometry/models/cylinder.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/operator/stiffness_operator.hpp"
#include "solvers/block_product.hpp"

namespace isopatch::verification {
namespace {

// A patch as the solution space, every node with its own row.
struct Model {
  CurvedPatch patch;
  iga::Discretization discretization;
  std::vector<iga::Material> materials;
  iga::RowNumbering numbering;
};

Model model_of(const CurvedPatch& patch) {
  const geometry::PatchSet patches = patch.rational
                                         ? geometry::cylinder_model({.height = 1})
                                         : geometry::box_model({.distortion = 0.1, .curvature = 0.4});
  Model model{patch,
              iga::discretize(geometry::connect(patches),
                              {.degree = {patch.degree, patch.degree, patch.degree},
                               .elements_per_direction = {patch.spans, patch.spans, patch.spans}}),
              {iga::isotropic(210e9, 0.3)},
              {}};
  model.numbering.rows = model.discretization.node_count();
  model.numbering.row_of_node.resize(static_cast<std::size_t>(model.numbering.rows));
  std::iota(model.numbering.row_of_node.begin(), model.numbering.row_of_node.end(), 0);
  return model;
}

solvers::SymmetricBlockMatrix matrix_of(const Model& model) {
  return iga::assemble_stiffness(model.discretization, model.materials, model.numbering);
}

void count(benchmark::State& state, const Model& model, int threads, std::int64_t bytes) {
  state.counters["p"] = model.patch.degree;
  state.counters["spans"] = model.patch.spans;
  state.counters["rational"] = model.patch.rational;
  state.counters["omp_threads"] = threads;
  state.counters["dofs"] = 3.0 * model.numbering.rows;
  state.counters["elements"] = static_cast<double>(model.discretization.element_count());
  state.counters["bytes"] = static_cast<double>(bytes);
}

void formation(benchmark::State& state, const Model& model, int threads) {
  omp_set_num_threads(threads);
  // Once before: where the host of a virtual machine has taken free memory back, getting it again takes ten
  // times as long as zeroing it, and the first repetition would pay for all.
  std::int64_t bytes = matrix_of(model).bytes();
  for ([[maybe_unused]] auto _ : state) bytes = matrix_of(model).bytes();
  count(state, model, threads, bytes);
}

void product(benchmark::State& state, const Model& model, int threads) {
  omp_set_num_threads(omp_get_num_procs());
  const solvers::SymmetricBlockMatrix matrix = matrix_of(model);
  omp_set_num_threads(threads);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 1);
  for ([[maybe_unused]] auto _ : state) {
    const Eigen::VectorXd y = multiply(matrix, x);
    benchmark::DoNotOptimize(y.data());
  }
  count(state, model, threads, matrix.bytes());
}

void apply(benchmark::State& state, const Model& model, int threads) {
  omp_set_num_threads(threads);
  const std::vector<iga::PatchSpace> spaces = iga::isoparametric_spaces(model.discretization);
  const iga::StiffnessOperator stiffness(spaces, iga::whole_patches(spaces), model.materials);
  const Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Random(3, stiffness.node_count());
  for ([[maybe_unused]] auto _ : state) {
    const Eigen::Matrix3Xd y = stiffness.apply(x);
    benchmark::DoNotOptimize(y.data());
  }
  // The least traffic: read the vector, the control points and their weights, read and write the result.
  const int numbers_per_node = 3 + 3 + (model.patch.rational ? 1 : 0) + 6;
  count(state, model, threads, std::int64_t{8} * numbers_per_node * model.numbering.rows);
}

}  // namespace

void register_kernels(const CurvedPatch& patch, const std::vector<int>& thread_counts, bool with_matrix) {
  const auto model = std::make_shared<const Model>(model_of(patch));
  const std::string name = "/p:" + std::to_string(patch.degree) + "/spans:" + std::to_string(patch.spans) +
                           "/rational:" + std::to_string(patch.rational) + "/threads:";
  const auto measure = [&](const char* what, auto kernel) {
    for (const int threads : thread_counts)
      benchmark::RegisterBenchmark((what + name + std::to_string(threads)).c_str(),
                                   [=](benchmark::State& state) { kernel(state, *model, threads); })
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
  };
  if (with_matrix) {
    measure("formation", formation);
    measure("product", product);
  }
  measure("apply", apply);
}

}  // namespace isopatch::verification
