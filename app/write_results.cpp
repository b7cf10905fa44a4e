#include "app/write_results.hpp"

#include <chrono>

#include "app/output_directory.hpp"
#include "app/report_page.hpp"
#include "app/summary.hpp"
#include "app/write_fields.hpp"
#include "iga/result_file.hpp"

namespace isopatch::app {
std::vector<std::string> write_results(const Study& study, StudyRun& run, const Progress& progress) {
  const std::filesystem::path& directory = study.output.directory;
  std::vector<std::string> written;
  remove_earlier_results(directory);
  const auto start = std::chrono::steady_clock::now();
  if (study.output.fields) {
    const geometry::MultiPatch& model = run.built.problem.discretization.model;
    const auto groups = face_groups(run.built.supports, run.built.loads, model);
    const WrittenFields fields =
        write_fields(run.solution.field, model, groups, study.output.field_options, directory, progress);
    written = fields.collections;
    if (const auto warning = left_out_warning(fields.left_out, model.size()))
      run.built.warnings.push_back(*warning);
  }
  run.timings.push_back(
      {"output", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  const std::string summary = summary_json(study, run);
  if (study.output.hdf5) {
    progress("writing results.h5", 0);
    write_in(directory, "results.h5", [&](const geometry::ByteSink& sink) {
      iga::write_hdf5(run.solution.field, run.solution.multipliers, study.text, summary, sink);
    });
    written.emplace_back("results.h5");
  }
  if (study.output.report) {
    progress("writing report.html", 0);
    const auto* solids = run.built.parameterization ? &*run.built.parameterization : nullptr;
    write_in(directory, "report.html", report_html(run.solution.field, study.text, summary, solids));
    written.emplace_back("report.html");
  }
  write_in(directory, "summary.json", summary);
  written.emplace_back("summary.json");
  return written;
}

}  // namespace isopatch::app
