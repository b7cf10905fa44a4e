#include "verification/performance/interfaces.hpp"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <memory>
#include <numeric>
#include <set>
#include <string>

#include "geometry/models/link.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/assembly/interface_stiffness.hpp"
#include "iga/assembly/mortar_constraints.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::verification {
namespace {

// Elements that each patch has beyond the others, along every direction: different where patches meet.
std::vector<int> more_elements(const geometry::MultiPatch& model) {
  std::vector<std::set<int>> taken(model.patches().size());
  std::vector<int> result;
  for (std::size_t patch = 0; patch < model.patches().size(); ++patch) {
    int more = 0;
    while (taken[patch].count(more) > 0) ++more;
    result.push_back(more);
    for (const geometry::Interface& interface : model.interfaces()) {
      const auto first = static_cast<std::size_t>(interface.first.patch.value);
      const auto second = static_cast<std::size_t>(interface.second.patch.value);
      if (first == patch) taken[second].insert(more);
      if (second == patch) taken[first].insert(more);
    }
  }
  return result;
}

struct LinkApart {
  int degree = 0;
  int spans = 0;
  iga::Discretization discretization;
  std::vector<iga::Material> materials;
  iga::RowNumbering numbering;
  std::vector<iga::PatchSpace> spaces;
  double same_point = 0;
};

LinkApart link_apart(int degree, int spans) {
  const geometry::MultiPatch model = geometry::connect(geometry::link_model());
  iga::DiscretizationOptions options{.degree = {degree, degree, degree}, .spread = false};
  const std::vector<int> more = more_elements(model);
  for (std::size_t patch = 0; patch < more.size(); ++patch) {
    const int elements = spans + more[patch];
    options.patches.push_back(
        {.patches = {static_cast<int>(patch)}, .elements_per_direction = {elements, elements, elements}});
  }
  LinkApart link{degree, spans, iga::discretize(model, options), {}, {}, {}, 0};
  link.materials.assign(more.size(), iga::isotropic(210e9, 0.3));
  link.numbering.rows = link.discretization.node_count();
  link.numbering.row_of_node.resize(static_cast<std::size_t>(link.numbering.rows));
  std::iota(link.numbering.row_of_node.begin(), link.numbering.row_of_node.end(), 0);
  link.spaces = iga::isoparametric_spaces(link.discretization);
  const geometry::MultiPatch& apart = link.discretization.model;
  link.same_point = apart.tolerance().same_point * apart.size();
  return link;
}

void count(benchmark::State& state, const LinkApart& link, int threads) {
  if (!link.discretization.model.interfaces().empty()) state.SkipWithError("interfaces match");
  state.counters["p"] = link.degree;
  state.counters["spans"] = link.spans;
  state.counters["rational"] = 1;
  state.counters["omp_threads"] = threads;
  state.counters["dofs"] = 3.0 * link.numbering.rows;
  state.counters["elements"] = static_cast<double>(link.discretization.element_count());
}

void volume(benchmark::State& state, const LinkApart& link, int threads) {
  omp_set_num_threads(threads);
  const auto assembled = [&] {
    return iga::assemble_stiffness(link.discretization, link.materials, link.numbering);
  };
  assembled();  // once before, as `formation` does
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(assembled().values.data());
  count(state, link, threads);
}

void nitsche(benchmark::State& state, const LinkApart& link, int threads) {
  omp_set_num_threads(threads);
  const std::vector<iga::CoupledFaces> faces = iga::coupled_faces(link.discretization, link.materials);
  for ([[maybe_unused]] auto _ : state) {
    const iga::NodeBlocks blocks =
        iga::interface_stiffness(faces, link.spaces, link.materials, link.same_point);
    benchmark::DoNotOptimize(&blocks);
  }
  count(state, link, threads);
}

void mortar(benchmark::State& state, const LinkApart& link, int threads) {
  omp_set_num_threads(threads);
  iga::MortarTies ties{iga::mortar_faces(link.discretization, link.materials), {}};
  ties.edges.assign(ties.faces.size(), {iga::SharedEdges{}, iga::SharedEdges{}, iga::SharedEdges{}});
  for ([[maybe_unused]] auto _ : state) {
    const iga::MortarConstraints constraints = iga::mortar_constraints(ties, link.spaces, link.same_point);
    benchmark::DoNotOptimize(&constraints);
  }
  count(state, link, threads);
}

}  // namespace

void register_interfaces(int degree, int spans, const std::vector<int>& thread_counts) {
  const auto link = std::make_shared<const LinkApart>(link_apart(degree, spans));
  const std::string name =
      "/p:" + std::to_string(degree) + "/spans:" + std::to_string(spans) + "/rational:1/threads:";
  const auto measure = [&](const char* what, auto kernel) {
    for (const int threads : thread_counts)
      benchmark::RegisterBenchmark((what + name + std::to_string(threads)).c_str(),
                                   [=](benchmark::State& state) { kernel(state, *link, threads); })
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
  };
  measure("link", volume);
  measure("interfaces", nitsche);
  measure("jumps", mortar);
}

}  // namespace isopatch::verification
