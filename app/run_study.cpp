#include "app/run_study.hpp"

#include <fmt/format.h>

#include <chrono>

#include "app/summary.hpp"
#include "geometry/io/vtk_bezier.hpp"
#include "iga/bezier_output.hpp"
#include "iga/result_file.hpp"

namespace isopatch::app {
namespace {

class Watch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

StudyRun run_study(const Study& study, const Progress& progress) {
  const Watch building;
  StudyRun run{build_problem(study, progress), {}, {}, {}};
  run.timings.push_back({"model", building.seconds()});
  run.solution = iga::solve_elasticity(run.built.problem, study.options, progress);
  for (const iga::PhaseTime& time : run.solution.timings) run.timings.push_back(time);
  const auto& model = run.built.problem.discretization.model;
  for (const LocatedProbe& probe : run.built.probes)
    run.probes.push_back({probe.name, probe.patch, model.renamed(PatchId(probe.patch), probe.parameter),
                          iga::evaluate(run.solution.field, probe.patch, probe.parameter)});
  return run;
}

std::vector<OutputFile> field_files(const iga::ElasticField& field, const Progress& progress) {
  std::vector<OutputFile> files;
  std::vector<std::pair<std::string, std::string>> blocks;
  const int count = static_cast<int>(field.patches.size());
  for (int i = 0; i < count; ++i) {
    progress("preparing the fields", static_cast<double>(i) / count);
    const std::string path = fmt::format("fields/patch_{:03d}.vtu", i);
    files.push_back({path, geometry::to_vtu(iga::bezier_cells(field, i))});
    blocks.emplace_back(fmt::format("patch {}", i), path);
  }
  files.push_back({"results.vtm", geometry::to_vtm(blocks)});
  return files;
}

std::vector<OutputFile> output_files(const Study& study, StudyRun& run, const Progress& progress) {
  std::vector<OutputFile> files;
  const Watch preparing;
  if (study.output.fields) files = field_files(run.solution.field, progress);
  run.timings.push_back({"output", preparing.seconds()});
  const std::string summary = summary_json(study, run);
  if (study.output.hdf5) {
    progress("preparing results.h5", 0);
    files.push_back(
        {"results.h5", iga::to_hdf5({run.solution.field, run.solution.multipliers, study.text, summary})});
  }
  files.push_back({"summary.json", summary});
  return files;
}

}  // namespace isopatch::app
