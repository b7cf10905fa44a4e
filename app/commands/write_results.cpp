#include "app/commands/write_results.hpp"

#include <fmt/format.h>

#include "app/reports/report_page.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/run_summary.hpp"
#include "app/results/summary.hpp"
#include "app/results/unfinished_results.hpp"
#include "app/results/write_fields.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/patch_connections.hpp"
#include "iga/output/result_file.hpp"

namespace isopatch::app {
namespace {

/// What is wrong with the fields becomes a warning of the run.
WrittenFields write_run_fields(const Study& study, StudyRun& run, const std::filesystem::path& folder,
                               const Progress& progress) {
  const geometry::MultiPatch& model = run.built.problem.discretization.model;
  WrittenFields fields = write_fields(run.solution.field, model, face_groups(model, summarized(study, run)),
                                      study.output.field_options, folder, progress);
  if (const auto warning = borrowed_warning(fields.borrowed, model.size()))
    run.built.warnings.push_back(*warning);
  return fields;
}

void write_run_report(const Study& study, const StudyRun& run, const geometry::PatchConnections& connections,
                      const std::filesystem::path& folder) {
  const iga::ElasticField& field = run.solution.field;
  const geometry::MultiPatch model = geometry::connected(field.patches, connections);
  const auto& solids = run.built.parameterization;
  write_in(folder, "report.html",
           report_html({field, model, study.text, summary_json(study, run), summarized(study, run),
                        solids ? &*solids : nullptr}));
}

/// Writes all files of a run into a folder, the solution first.
std::vector<std::string> write_all(const Study& study, StudyRun& run, const std::filesystem::path& folder,
                                   const Progress& progress) {
  std::vector<std::string> written;
  const Stopwatch watch;
  const auto connections = geometry::connections_of(run.built.problem.discretization.model);
  if (study.output.hdf5) {
    progress("writing results.h5", 0);
    write_in(folder, "results.h5", [&](const geometry::ByteSink& sink) {
      iga::write_hdf5(run.solution.field, run.solution.multipliers, connections, study.text,
                      summary_json(study, run), sink);
    });
    written.emplace_back("results.h5");
  }
  if (study.output.fields) {
    const WrittenFields fields = write_run_fields(study, run, folder, progress);
    written.insert(written.end(), fields.collections.begin(), fields.collections.end());
  }
  if (study.output.report) {
    progress("writing report.html", 0);
    write_run_report(study, run, connections, folder);
    written.emplace_back("report.html");
  }
  run.timings.push_back({"output", watch.seconds()});
  write_in(folder, "summary.json", summary_json(study, run));
  written.emplace_back("summary.json");
  return written;
}

}  // namespace

std::vector<std::string> write_results(const Study& study, StudyRun& run, const Progress& progress) {
  UnfinishedResults unfinished(study.output.directory);
  try {
    std::vector<std::string> written = write_all(study, run, unfinished.folder(), progress);
    unfinished.replace_earlier();
    return written;
  } catch (const Error& error) {
    if (!unfinished.keep_solution()) throw;
    const std::string solution = (unfinished.folder() / "results.h5").string();
    throw Error(
        error.code(),
        fmt::format("{}. The solution is kept in {}; `isopatch report`, `fields` and `probe` work from it",
                    error.what(), solution));
  }
}

}  // namespace isopatch::app
