#include "app/write_results.hpp"

#include <fmt/format.h>

#include <chrono>

#include "app/output_directory.hpp"
#include "app/report_page.hpp"
#include "app/summary.hpp"
#include "app/unfinished_results.hpp"
#include "geometry/base/error.hpp"
#include "geometry/io/vtk_bezier.hpp"
#include "geometry/patch_connections.hpp"
#include "iga/bezier_output.hpp"
#include "iga/result_file.hpp"

namespace isopatch::app {
namespace {

// Field files above this size are written in single precision unless the study says otherwise.
constexpr std::int64_t most_bytes_in_full = 1'000'000'000;

geometry::Precision chosen(FieldPrecision precision, const iga::ElasticField& field) {
  const bool full = precision == FieldPrecision::full || (precision == FieldPrecision::automatic &&
                                                          iga::bezier_bytes(field) <= most_bytes_in_full);
  return full ? geometry::Precision::full : geometry::Precision::single;
}

/// Writes all files of a run into a folder, the solution first.
std::vector<std::string> write_all(const Study& study, StudyRun& run, const std::filesystem::path& folder,
                                   const Progress& progress) {
  std::vector<std::string> written;
  const auto start = std::chrono::steady_clock::now();
  const iga::ElasticField& field = run.solution.field;
  const auto connections = geometry::connections_of(run.built.problem.discretization.model);
  const std::string summary = summary_json(study, run);
  if (study.output.hdf5) {
    progress("writing results.h5", 0);
    write_in(folder, "results.h5", [&](const geometry::ByteSink& sink) {
      iga::write_hdf5(field, run.solution.multipliers, connections, study.text, summary, sink);
    });
    written.emplace_back("results.h5");
  }
  if (study.output.fields) {
    write_fields(field, study.output.precision, folder, progress);
    written.emplace_back("results.vtm");
  }
  if (study.output.report) {
    progress("writing report.html", 0);
    const auto* solids = run.built.parameterization ? &*run.built.parameterization : nullptr;
    const geometry::MultiPatch model = geometry::connected(field.patches, connections);
    write_in(folder, "report.html", report_html(field, model, study.text, summary, solids));
    written.emplace_back("report.html");
  }
  run.timings.push_back(
      {"output", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  write_in(folder, "summary.json", with_phase(summary, run.timings.back()));
  written.emplace_back("summary.json");
  return written;
}

}  // namespace

int write_fields(const iga::ElasticField& field, FieldPrecision precision,
                 const std::filesystem::path& directory, const Progress& progress) {
  remove_earlier_fields(directory);
  const geometry::Precision digits = chosen(precision, field);
  std::vector<std::pair<std::string, std::string>> blocks;
  const int count = static_cast<int>(field.patches.size());
  for (int i = 0; i < count; ++i) {
    progress("writing the fields", static_cast<double>(i) / count);
    const std::string path = fmt::format("fields/patch_{:03d}.vtu", i);
    write_in(directory, path,
             [&](const geometry::ByteSink& sink) { iga::write_bezier_cells(field, i, sink, digits); });
    blocks.emplace_back(fmt::format("patch {}", i), path);
  }
  write_in(directory, "results.vtm", geometry::to_vtm(blocks));
  return count + 1;
}

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
