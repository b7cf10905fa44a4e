#include "iga/distribution/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isopatch::iga {
namespace {

constexpr double allowed_imbalance = 1.1;

// Operations of one layer of elements, up to a factor: sum factorization takes (p + 1)^4 per element.
double work_of_layer(const PatchSpace& space) {
  double work = space.knots[0].element_count() * static_cast<double>(space.knots[1].element_count());
  int highest = 0;
  for (const geometry::KnotVector& knots : space.knots) {
    work *= knots.degree() + 1;
    highest = std::max(highest, knots.degree());
  }
  return work * (highest + 1);
}

std::vector<double> work_of_patches(const std::vector<PatchSpace>& spaces) {
  std::vector<double> work;
  for (const PatchSpace& space : spaces)
    work.push_back(space.knots[2].element_count() * work_of_layer(space));
  return work;
}

Distribution assigned(const std::vector<int>& process_of_patch, int processes) {
  Distribution result(static_cast<std::size_t>(processes));
  for (std::size_t p = 0; p < process_of_patch.size(); ++p)
    result[static_cast<std::size_t>(process_of_patch[p])].push_back({static_cast<int>(p), 0, 1});
  return result;
}

// Each patch to the process in whose stretch of the total its middle lies.
Distribution in_order(const std::vector<double>& work, int processes) {
  const double total = std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<int> process;
  double before = 0;
  for (const double w : work) {
    process.push_back(std::min(processes - 1, static_cast<int>(processes * (before + 0.5 * w) / total)));
    before += w;
  }
  return assigned(process, processes);
}

// The largest patch left to the process with the least work.
Distribution largest_first(const std::vector<double>& work, int processes) {
  std::vector<int> order(work.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return work[static_cast<std::size_t>(a)] > work[static_cast<std::size_t>(b)];
  });
  std::vector<double> load(static_cast<std::size_t>(processes), 0);
  std::vector<int> process(work.size());
  for (const int p : order) {
    const auto least = std::min_element(load.begin(), load.end());
    process[static_cast<std::size_t>(p)] = static_cast<int>(least - load.begin());
    *least += work[static_cast<std::size_t>(p)];
  }
  return assigned(process, processes);
}

// All layers of all patches in a row, cut into intervals as equal as layers allow.
Distribution between_layers(const std::vector<PatchSpace>& spaces, const std::vector<double>& work,
                            int processes) {
  const double total = std::accumulate(work.begin(), work.end(), 0.0);
  Distribution result(static_cast<std::size_t>(processes));
  double before = 0;
  for (std::size_t p = 0; p < spaces.size(); ++p) {
    const int layers = spaces[p].knots[2].element_count();
    const auto cut = [&](int process) {
      const double share = (total * process / processes - before) / work[p];
      return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * layers));
    };
    for (int process = 0; process < processes; ++process) {
      const int begin = process == 0 ? 0 : cut(process);
      const int end = process == processes - 1 ? layers : cut(process + 1);
      if (begin < end)
        result[static_cast<std::size_t>(process)].push_back(
            {static_cast<int>(p), static_cast<double>(begin) / layers, static_cast<double>(end) / layers});
    }
    before += work[p];
  }
  return result;
}

double largest_load(const Distribution& distribution, const std::vector<double>& work) {
  double largest = 0;
  for (const auto& shares : distribution) {
    double load = 0;
    for (const PatchShare& share : shares)
      load += (share.end - share.begin) * work[static_cast<std::size_t>(share.patch)];
    largest = std::max(largest, load);
  }
  return largest;
}

}  // namespace

Distribution distribute(const std::vector<PatchSpace>& spaces, int processes) {
  const std::vector<double> work = work_of_patches(spaces);
  const double mean = std::accumulate(work.begin(), work.end(), 0.0) / processes;
  const Distribution choices[] = {in_order(work, processes), largest_first(work, processes),
                                  between_layers(spaces, work, processes)};
  const Distribution* best = nullptr;
  for (const Distribution& choice : choices) {
    if (largest_load(choice, work) <= allowed_imbalance * mean) return choice;
    if (!best || largest_load(choice, work) < largest_load(*best, work)) best = &choice;
  }
  return *best;
}

std::vector<PatchLayers> layers_of(const Distribution& distribution, const std::vector<PatchSpace>& spaces,
                                   int process) {
  std::vector<PatchLayers> parts;
  for (const PatchShare& share : distribution[static_cast<std::size_t>(process)]) {
    const int layers = spaces[static_cast<std::size_t>(share.patch)].knots[2].element_count();
    parts.push_back({share.patch, static_cast<int>(std::lround(share.begin * layers)),
                     static_cast<int>(std::lround(share.end * layers)), share.couples});
  }
  return parts;
}

std::vector<std::vector<int>> processes_of_patches(const Distribution& distribution, int patches) {
  std::vector<std::vector<int>> result(static_cast<std::size_t>(patches));
  for (const bool empty : {false, true})
    for (std::size_t process = 0; process < distribution.size(); ++process)
      for (const PatchShare& share : distribution[process])
        if (share.is_empty() == empty)
          result[static_cast<std::size_t>(share.patch)].push_back(static_cast<int>(process));
  return result;
}

std::vector<std::vector<int>> processes_of_rows(const RowNumbering& whole, const std::vector<int>& first_node,
                                                const Distribution& distribution) {
  const auto of_patch = processes_of_patches(distribution, static_cast<int>(first_node.size()) - 1);
  std::vector<std::vector<int>> of_row(static_cast<std::size_t>(whole.rows));
  for (std::size_t p = 0; p < of_patch.size(); ++p)
    for (int node = first_node[p]; node < first_node[p + 1]; ++node) {
      auto& row = of_row[static_cast<std::size_t>(whole.row_of_node[static_cast<std::size_t>(node)])];
      for (const int process : of_patch[p])
        if (std::find(row.begin(), row.end(), process) == row.end()) row.push_back(process);
    }
  for (auto& row : of_row) std::sort(row.begin(), row.end());
  return of_row;
}

LocalRows local_rows(const RowNumbering& whole, const std::vector<int>& first_node,
                     const Distribution& distribution, const solvers::Processes& processes) {
  if (processes.count() == 1) return {solvers::SharedRows(whole.rows), whole};
  LocalRows result;
  result.rows = solvers::SharedRows(processes_of_rows(whole, first_node, distribution), processes);
  result.numbering.rows = result.rows.local_rows();
  std::vector<int> local(static_cast<std::size_t>(whole.rows), -1);
  for (int row = 0; row < result.rows.local_rows(); ++row)
    local[static_cast<std::size_t>(result.rows.global_of_local()[static_cast<std::size_t>(row)])] = row;
  for (const int row : whole.row_of_node)
    result.numbering.row_of_node.push_back(local[static_cast<std::size_t>(row)]);
  return result;
}

}  // namespace isopatch::iga
