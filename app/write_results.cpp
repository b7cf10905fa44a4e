#include "app/write_results.hpp"

#include <fmt/format.h>

#include <chrono>

#include "app/output_directory.hpp"
#include "app/report_page.hpp"
#include "app/summary.hpp"
#include "geometry/io/vtk_bezier.hpp"
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
  const std::filesystem::path& directory = study.output.directory;
  std::vector<std::string> written;
  remove_earlier_results(directory);
  const auto start = std::chrono::steady_clock::now();
  if (study.output.fields) {
    write_fields(run.solution.field, study.output.precision, directory, progress);
    written.emplace_back("results.vtm");
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
