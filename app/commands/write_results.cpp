#include "app/commands/write_results.hpp"

#include <fmt/format.h>

#include "app/reports/report_page.hpp"
#include "app/results/output_directory.hpp"
#include "app/results/read_summary.hpp"
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

/// Where a case has its files: where all is, in a study without cases.
std::filesystem::path folder_of(const CaseView& one) {
  return one.name.name.empty() ? std::filesystem::path() : std::filesystem::path(case_folder) / one.name.name;
}

/// What is wrong with the fields becomes a warning of the run.
std::vector<std::string> write_run_fields(const Study& study, StudyRun& run,
                                          const std::filesystem::path& folder, const Progress& progress) {
  const geometry::MultiPatch& model = run.built.problem.discretization.model;
  std::vector<std::string> written;
  WrittenFields worst;
  for (const CaseView& one : cases_of(run)) {
    const WrittenFields fields =
        write_fields(one.solution.field, model, face_groups(model, summarized(study, run, one)),
                     study.output.field_options, folder / folder_of(one), progress);
    if (run.has_cases())
      written.push_back((folder_of(one) / fields.collections.front()).string());
    else
      written = fields.collections;
    if (worst.borrowed.count == 0) worst.borrowed = fields.borrowed;  // the same points in all cases
    if (!worst.fit || (fields.fit && fields.fit->off > worst.fit->off)) worst.fit = fields.fit;
  }
  for (const auto& warning :
       {borrowed_warning(worst.borrowed, model.size()), fit_warning(worst.fit, model.size())})
    if (warning) run.built.warnings.push_back(*warning);
  return written;
}

/// The pages of all cases as seen from one of them.
std::vector<PageLink> links_from(const StudyRun& run, const CaseView& from, bool at_top) {
  std::vector<PageLink> links;
  if (!run.has_cases()) return links;
  for (const CaseView& one : cases_of(run)) {
    const std::string name = one.name.name;
    links.push_back({name,
                     (at_top ? std::string(case_folder) + "/" : std::string("../")) + name + "/report.html",
                     name == from.name.name});
  }
  return links;
}

/// A page for each case, with links to the others; the first case's is at the top as well.
void write_run_reports(const Study& study, const StudyRun& run, const geometry::PatchConnections& connections,
                       const std::filesystem::path& folder) {
  const geometry::MultiPatch model = geometry::connected(run.solution.field.patches, connections);
  const auto& solids = run.built.parameterization;
  const std::string json = summary_json(study, run);
  const auto write = [&](const std::filesystem::path& file, const CaseView& one, bool at_top) {
    write_in(folder, file,
             report_html({one.solution.field, model, study.text, summary_of_case(json, one.name.name),
                          summarized(study, run, one), solids ? &*solids : nullptr,
                          links_from(run, one, at_top), run.built.stages}));
  };
  const std::vector<CaseView> cases = cases_of(run);
  write("report.html", cases.front(), true);
  if (run.has_cases())
    for (const CaseView& one : cases) write(folder_of(one) / "report.html", one, false);
}

/// Writes all files of a run into a folder, the solution first.
std::vector<std::string> write_all(const Study& study, StudyRun& run, const std::filesystem::path& folder,
                                   const Progress& progress) {
  std::vector<std::string> written;
  const Stopwatch watch;
  const auto connections = geometry::connections_of(run.built.problem.discretization.model);
  if (study.output.hdf5) {
    progress("writing results.h5", 0);
    std::vector<iga::CaseToStore> cases;
    for (const CaseView& one : cases_of(run))
      cases.push_back({one.name.name, one.solution.field, one.solution.multipliers});
    write_in(folder, "results.h5", [&](const geometry::ByteSink& sink) {
      iga::write_hdf5(cases, connections, study.text, summary_json(study, run), sink);
    });
    written.emplace_back("results.h5");
  }
  if (study.output.fields) {
    const std::vector<std::string> fields = write_run_fields(study, run, folder, progress);
    written.insert(written.end(), fields.begin(), fields.end());
  }
  if (study.output.report) {
    progress("writing report.html", 0);
    write_run_reports(study, run, connections, folder);
    written.emplace_back("report.html");
  }
  run.timings.push_back({"output", watch.seconds()});
  write_in(folder, "summary.json", summary_json(study, run));
  written.emplace_back("summary.json");
  return written;
}

}  // namespace

std::vector<std::string> write_results(const Study& study, StudyRun& run, const Progress& progress) {
  UnfinishedResults unfinished(run_results, study.output.directory);
  try {
    std::vector<std::string> written = write_all(study, run, unfinished.folder(), progress);
    unfinished.replace_earlier();
    return written;
  } catch (const Error& error) {
    if (!unfinished.keep_essence()) throw;
    const std::string solution = (unfinished.folder() / "results.h5").string();
    throw Error(
        error.code(),
        fmt::format("{}. The solution is kept in {}; `isopatch report`, `fields` and `probe` work from it",
                    error.what(), solution));
  }
}

}  // namespace isopatch::app
