// Measures how cells are cut by their graphs alone: loops, least numbers of hexahedra, searches. Seeded.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "segmentation/decomposition/combinatorics/decomposition_search.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/combinatorics/tests/random_graphs.hpp"
#include "segmentation/decomposition/combinatorics/tests/sample_graphs.hpp"

namespace isopatch::verification {
namespace {

void loops(benchmark::State& state, const segmentation::CellGraph& graph) {
  std::size_t count = 0;
  for (auto _ : state) {
    const segmentation::LoopList list = segmentation::valid_loops(graph);
    count = list.loops.size();
  }
  state.counters["loops"] = static_cast<double>(count);
}

void least_hexahedra(benchmark::State& state, const segmentation::CellGraph& graph) {
  int least = 0;
  for (auto _ : state) {
    segmentation::HexahedraCount count;
    least = count.minimum(graph);
  }
  state.counters["hexahedra"] = least;
}

void search(benchmark::State& state, const segmentation::CellGraph& graph,
            const segmentation::SearchOptions& options) {
  segmentation::SearchCell cell;
  cell.graph = graph;
  segmentation::CutTree tree;
  for (auto _ : state) tree = segmentation::search_cuts(cell, segmentation::combinatorial_oracle(), options);
  state.counters["hexahedra"] = tree.hexahedra;
  state.counters["evaluations"] = tree.evaluations;
}

void register_all() {
  using segmentation::test::RandomKind;
  const auto park = segmentation::test::science_park();
  benchmark::RegisterBenchmark("loops/science_park", loops, park)->Unit(benchmark::kMillisecond);
  const segmentation::SearchOptions usual;
  segmentation::SearchOptions
      more_exact;  // least numbers of larger cells: fewer hexahedra, four times as long
  more_exact.cost.exact_up_to = 12;
  benchmark::RegisterBenchmark("search/science_park", search, park, usual)->Unit(benchmark::kMillisecond);
  const auto octagon = segmentation::test::prism(8);
  benchmark::RegisterBenchmark("least/octagonal_prism", least_hexahedra, octagon)
      ->Unit(benchmark::kMillisecond);
  for (const RandomKind kind : {RandomKind::simple, RandomKind::mixed})
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      const auto map = segmentation::test::random_map(seed, 60, kind);
      const std::string name =
          (kind == RandomKind::simple ? "simple_60/" : "mixed_60/") + std::to_string(seed);
      benchmark::RegisterBenchmark(("loops/" + name).c_str(), loops, map)->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(("search/" + name).c_str(), search, map, usual)
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(("search_exact_12/" + name).c_str(), search, map, more_exact)
          ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace
}  // namespace isopatch::verification

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  isopatch::verification::register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
