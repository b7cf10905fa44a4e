// Time and memory of every phase of a study but assembly and solve, over several refinements, with the
// exponent of each phase's growth. The displacement is a made-up one, so no equations are solved.
//
//   isopatch_phases examples/link/study.toml 3 4 5 [key=value ...]

#include <fmt/format.h>
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/results/write_fields.hpp"
#include "app/run/run_study.hpp"
#include "app/study/parse_study.hpp"
#include "geometry/base/atomic_writer.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/coupling/rigid_motions.hpp"
#include "iga/coupling/supported_system.hpp"
#include "iga/output/result_file.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/post/results.hpp"
#include "iga/problem/loads.hpp"

namespace isopatch {
namespace {

// "VmRSS" or "VmHWM" of this process, bytes.
double memory(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(what + ":")) return 1024 * std::stod(line.substr(what.size() + 1));
  return 0;
}

struct Measured {
  double seconds = 0;
  double held = 0;  // bytes that stay
  double peak = 0;  // bytes above what was held before
};

class Phases {
 public:
  template <class Work>
  auto operator()(const std::string& name, Work work) {
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the high-water mark starts anew
    const double before = memory("VmRSS");
    const Stopwatch watch;
    auto result = work();
    Measured m;
    m.seconds = watch.seconds();
    m.peak = memory("VmHWM") - before;
    ::malloc_trim(0);
    m.held = memory("VmRSS") - before;
    order.push_back(name);
    found[name] = m;
    return result;
  }
  std::vector<std::string> order;
  std::map<std::string, Measured> found;
  double dofs = 0;
};

Phases measure(const std::string& path, const std::vector<std::string>& overrides,
               const std::filesystem::path& directory) {
  Phases phase;
  app::Study study = app::read_study(path, overrides);
  const auto model = phase("connect", [&] { return app::load_model(study.model); }).model;
  phase("report, certificate", [&] { return app::report(model); });
  auto discretization = phase("discretize", [&] { return iga::discretize(model, study.discretization); });
  const app::BuiltProblem built = phase("whole build", [&] { return app::build_problem(study); });
  discretization = {model, {}, {0}, {}};
  const iga::ElasticityProblem& problem = built.problem;
  const iga::Discretization& d = problem.discretization;
  const auto global = phase("global nodes", [&] { return iga::global_nodes(d); });
  phase.dofs = 3.0 * global.count();
  const auto frames = phase("support frames", [&] { return iga::support_frames(problem, global); });
  phase("rigid motions", [&] { return iga::free_bodies(problem, global, frames); });
  const auto load = phase("surface loads", [&] { return iga::load_vector(problem); });
  {
    iga::ElasticityProblem heavy{d, problem.materials, {}, {}, {}};
    std::vector<PatchId> all;
    for (int i = 0; i < d.patch_count(); ++i) all.emplace_back(i);
    heavy.volume_loads = iga::gravity("weight", all, {0, 0, -9.81}, problem.materials);
    phase("body force", [&] { return iga::load_vector(heavy); });
  }
  const auto rows = phase("multiplier rows", [&] { return iga::multiplier_rows(global, frames); });

  Eigen::Matrix3Xd displacement(3, d.node_count());
  for (int p = 0; p < d.patch_count(); ++p) {
    const auto& patch = d.patches[static_cast<std::size_t>(p)];
    displacement.middleCols(d.first_node[static_cast<std::size_t>(p)], patch.size()) =
        1e-3 * (patch.control_points() * (7 / d.model.size())).array().sin().matrix() * d.model.size();
  }
  app::StudyRun run{built, {}, {}, {}};
  run.solution.field = phase("field", [&] {
    iga::ElasticField field{d.patches, {}, problem.materials};
    for (std::size_t p = 0; p < d.patches.size(); ++p)
      field.displacement.push_back(displacement.middleCols(d.first_node[p], d.patches[p].size()));
    return field;
  });
  const auto internal =
      phase("internal forces", [&] { return iga::internal_forces(d, problem.materials, displacement); });
  const Eigen::Matrix3Xd unbalanced = internal.forces - load;
  phase("recovered multipliers",
        [&] { return iga::recovered_multipliers(rows, global, frames, unbalanced); });
  phase("largest displacement", [&] { return iga::max_displacement(run.solution.field); });
  phase("reactions", [&] { return iga::support_reactions(problem, global, frames, unbalanced); });
  study.output.directory = directory;
  phase("fields", [&] {
    app::write_fields(run.solution.field, d.model, {}, study.output.field_options, directory);
    return 0;
  });
  phase("results.h5", [&] {
    const auto connections = geometry::connections_of(problem.discretization.model);
    AtomicWriter file(directory / "results.h5");
    iga::write_hdf5({{"", run.solution.field, run.solution.multipliers}}, connections, study.text, "{}",
                    [&](std::string_view bytes) { file.write(bytes); });
    file.finish();
    return 0;
  });
  const auto stored = phase("read results.h5", [&] { return iga::read_result(directory / "results.h5"); });
  const Eigen::Vector3d place = stored.field.patches.back().point(stored.field.patches.back().low());
  phase("locate", [&] { return iga::locate(stored.field, place); });
  return phase;
}

void print(const std::vector<Phases>& levels) {
  fmt::print("us/DOF and bytes/DOF (held, peak above what was held), exponents of the time's growth\n{:<24}",
             "DOFs");
  for (const Phases& level : levels) fmt::print("{:>26.0f}     ", level.dofs);
  fmt::print("\n");
  for (const std::string& name : levels[0].order) {
    fmt::print("{:<24}", name);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const Measured& m = levels[i].found.at(name);
      const double n = levels[i].dofs;
      fmt::print("{:>9.3f} {:>7.0f} {:>8.0f}", 1e6 * m.seconds / n, m.held / n, m.peak / n);
      if (i == 0) fmt::print("     ");
      if (i > 0)
        fmt::print("{:>5.2f}", std::log(m.seconds / levels[i - 1].found.at(name).seconds) /
                                   std::log(n / levels[i - 1].dofs));
    }
    fmt::print("\n");
  }
}

int run(int count, char** arguments) {
  std::vector<std::string> levels;
  std::vector<std::string> overrides;
  for (int i = 2; i < count; ++i) {
    const std::string argument = arguments[i];
    (argument.find('=') == std::string::npos ? levels : overrides).push_back(argument);
  }
  if (levels.empty()) {
    fmt::print("isopatch_phases STUDY REFINE... [key=value...]\n");
    return 2;
  }
  const auto directory = std::filesystem::temp_directory_path() / "isopatch_phases";
  std::vector<Phases> found;
  for (const std::string& level : levels) {
    std::vector<std::string> all = overrides;
    all.push_back("discretization.refine=" + level);
    found.push_back(measure(arguments[1], all, directory));
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
      if (entry.is_regular_file()) bytes += entry.file_size();
    fmt::print("refine {}: {:.0f} DOFs, files of {:.0f} bytes/DOF\n", level, found.back().dofs,
               static_cast<double>(bytes) / found.back().dofs);
    std::fflush(stdout);
    std::filesystem::remove_all(directory);
  }
  print(found);
  return 0;
}

}  // namespace
}  // namespace isopatch

int main(int count, char** arguments) {
  try {
    return isopatch::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "isopatch_phases: {}\n", error.what());
    return 1;
  }
}
