#include "iga/assembly/assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "geometry/base/error.hpp"
#include "iga/assembly/internal/stiffness_integrator.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/spaces/quadrature_geometry.hpp"

namespace isopatch::iga {
namespace {

using solvers::SymmetricBlockMatrix;

// Storage for one task of each thread and for the geometry at the points of some layers.
struct Buffers {
  std::vector<StiffnessIntegrator> integrators =
      std::vector<StiffnessIntegrator>(static_cast<std::size_t>(omp_get_max_threads()));
  std::vector<BlockTargets> targets = std::vector<BlockTargets>(integrators.size());  // one a thread
  std::vector<CollectedBlocks> collected;                                             // one a task
  solvers::ZeroedVector<double> points;
  std::size_t most_bytes = 0;  // of points
};

// Tasks of some layers: one for each function of w, and where these are few or lines long, several along u.
// They do not depend on the number of threads, so neither do the sums.
std::vector<StiffnessTask> tasks_of(const StiffnessTables& tables, int layer_begin, int layer_end) {
  constexpr int wanted = 64;
  constexpr int needed = 8;
  int planes = 0;
  for (const Overlap& overlap : tables.overlaps[2]) planes += overlap.empty() ? 0 : 1;
  const int functions = tables.sizes[0];
  const int span = tables.degrees[0] + 1;
  // The contraction of w is done twice where two bands meet: long bands, unless there are too few tasks.
  const int bands = std::max({1, std::min(wanted / planes, functions / (8 * span)),
                              std::min(needed / planes, functions / (2 * span))});
  std::vector<StiffnessTask> tasks;
  for (int a_w = 0; a_w < tables.sizes[2]; ++a_w) {
    if (tables.overlap(2, a_w).empty()) continue;
    for (int band = 0; band < bands; ++band)
      tasks.push_back(
          {a_w, functions * band / bands, functions * (band + 1) / bands, layer_begin, layer_end});
  }
  return tasks;
}

void evaluate_points(const QuadratureGeometry& geometry, const StiffnessTables& tables, int patch,
                     int layer_begin, int layer_end, PointData& data, Buffers& buffers) {
  constexpr int w_per_task = 64;
  const int points_v = tables.points[1];
  data.layer_begin = layer_begin;
  const int strips = (data.points_w + w_per_task - 1) / w_per_task;
  const int first_w = tables.points[2] * tables.first_layer;
  parallel_ranges(static_cast<std::int64_t>(strips) * points_v * (layer_end - layer_begin),
                  [&](std::int64_t task, int) {
                    const int v = static_cast<int>(task / strips);
                    const int begin = static_cast<int>(task % strips) * w_per_task;
                    const int end = std::min(data.points_w, begin + w_per_task);
                    double* const out = buffers.points.data() + (data.block(v, 0, begin) - data.values);
                    geometry.evaluate(layer_begin * points_v + v, first_w + begin, first_w + end, out,
                                      data.points_w, patch);
                  });
}

struct PatchAt {
  const PatchSpace* space;
  PatchLayers part;
  const int* row_of_node;
  const Material* material;
};

template <class Report>
void assemble_part(const PatchAt& at, int points, Buffers& buffers, SymmetricBlockMatrix& matrix,
                   Report report) {
  const QuadratureGeometry geometry(*at.space, points);
  const StiffnessTables tables(*at.space, at.part, geometry);
  const PatchRows rows = patch_rows(tables, at.row_of_node);
  PointData data;
  data.blocks = geometry.blocks();
  data.points_w = tables.points[2] * (tables.last_layer - tables.first_layer);
  data.components = geometry.components();
  const std::size_t per_layer = sizeof(double) * static_cast<std::size_t>(tables.points[1]) *
                                static_cast<std::size_t>(data.blocks) *
                                static_cast<std::size_t>(data.points_w) *
                                static_cast<std::size_t>(data.components * QuadratureGeometry::block_size);
  const int layers = tables.elements(1);
  constexpr std::size_t cache = std::size_t{4} << 20;  // that the points of some layers should stay in, bytes
  const std::size_t wanted =
      std::max<std::size_t>(cache / per_layer, static_cast<std::size_t>(tables.degrees[1]) + 1);
  const int at_once = static_cast<int>(std::clamp<std::size_t>(
      std::min(wanted, buffers.most_bytes / per_layer), 1, static_cast<std::size_t>(layers)));
  const int chunks = (layers + at_once - 1) / at_once;
  const std::size_t size =
      per_layer / sizeof(double) * static_cast<std::size_t>((layers + chunks - 1) / chunks);
  if (buffers.points.size() < size) buffers.points = solvers::ZeroedVector<double>(size);
  data.values = buffers.points.data();
  const PatchIntegrand integrand{tables, rows, *at.material,
                                 at.space->is_rational() ? at.space->weights.data() : nullptr};
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const int begin = static_cast<int>(static_cast<std::int64_t>(layers) * chunk / chunks);
    const int end = static_cast<int>(static_cast<std::int64_t>(layers) * (chunk + 1) / chunks);
    evaluate_points(geometry, tables, at.part.patch, begin, end, data, buffers);
    const std::vector<StiffnessTask> tasks = tasks_of(tables, begin, end);
    buffers.collected.resize(std::max(buffers.collected.size(), tasks.size()));
    parallel_for(static_cast<std::int64_t>(tasks.size()), [&](std::int64_t task, int thread) {
      const StiffnessTask& here = tasks[static_cast<std::size_t>(task)];
      CollectedBlocks& collected = buffers.collected[static_cast<std::size_t>(task)];
      BlockTargets& targets = buffers.targets[static_cast<std::size_t>(thread)];
      targets.prepare(here, tables, rows, matrix, collected);
      buffers.integrators[static_cast<std::size_t>(thread)].run(here, integrand, data, targets, collected,
                                                                matrix);
    });
    const int shares = omp_get_max_threads();
    parallel_for(shares, [&](std::int64_t share, int) {
      for (std::size_t task = 0; task < tasks.size(); ++task)
        buffers.collected[task].flush(static_cast<int>(share), shares, matrix);
    });
    report(static_cast<double>(chunk + 1) / chunks);
  }
}

}  // namespace

SymmetricBlockMatrix assemble_stiffness(const std::vector<PatchSpace>& spaces,
                                        const std::vector<PatchLayers>& parts,
                                        const std::vector<Material>& materials, const RowNumbering& numbering,
                                        int points, const Progress& progress) {
  constexpr std::size_t least_bytes = std::size_t{64} << 20;
  if (materials.size() != spaces.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} materials for {} patches", materials.size(), spaces.size()));
  SymmetricBlockMatrix matrix = stiffness_pattern(spaces, parts, numbering);
  Buffers buffers;
  buffers.most_bytes = std::max(least_bytes, static_cast<std::size_t>(matrix.bytes() / 32));
  std::vector<std::ptrdiff_t> first_node = {0};
  for (const PatchSpace& space : spaces) first_node.push_back(first_node.back() + space.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].first_layer == parts[p].last_layer) continue;
    const auto patch = static_cast<std::size_t>(parts[p].patch);
    assemble_part(
        {&spaces[patch], parts[p], numbering.row_of_node.data() + first_node[patch], &materials[patch]},
        points, buffers, matrix, [&](double share) {
          progress("assembly", (static_cast<double>(p) + share) / static_cast<double>(parts.size()));
        });
  }
  return matrix;
}

SymmetricBlockMatrix assemble_stiffness(const Discretization& discretization,
                                        const std::vector<Material>& materials, const RowNumbering& numbering,
                                        int points, const Progress& progress) {
  const std::vector<PatchSpace> spaces = isoparametric_spaces(discretization);
  return assemble_stiffness(spaces, whole_patches(spaces), materials, numbering, points, progress);
}

SymmetricBlockMatrix stiffness_pattern(const Discretization& discretization, const RowNumbering& numbering) {
  const std::vector<PatchSpace> spaces = isoparametric_spaces(discretization);
  return stiffness_pattern(spaces, whole_patches(spaces), numbering);
}

}  // namespace isopatch::iga
