#include "app/problem/parameterized_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/base/engineering_units.hpp"
#include "app/problem/solid_stages.hpp"

namespace isopatch::app {
namespace {

using segmentation::FaceReport;
using segmentation::ParameterizationReport;

std::string row(const segmentation::PatchReport& patch, std::size_t index, std::size_t width) {
  const bool certified = patch.certificate.accepted();
  return fmt::format("  {:>3}  {:{}}  {:>6}  {:>9.3f}  {:>5.3f}  {}{}\n", index, patch.name, width,
                     patch.control_points, patch.quality.min_scaled_jacobian,
                     patch.quality.mean_scaled_jacobian,
                     certified ? fmt::format("det J > {:.3g}", patch.certificate.lower) : "not certified",
                     patch.moved ? (patch.certified_before ? ", improved" : ", untangled") : "");
}

std::string histogram_text(const ParameterizationReport& report) {
  std::array<long, 10> sum{};
  for (const segmentation::PatchReport& patch : report.patches)
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += patch.histogram[i];
  long all = 0;
  for (const long count : sum) all += count;
  std::string text = "  scaled Jacobian   ";
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (sum[i] > 0)
      text += fmt::format(" .{}-{}: {:.1f} %", i, i == 9 ? "1" : fmt::format(".{}", i + 1),
                          100.0 * double(sum[i]) / double(all));
  return text + "\n";
}

}  // namespace

segmentation::Parameterization parameterized(const BlocksInput& input, const Progress& progress) {
  return std::move(*staged_patches(input, Stage::patches, progress).made);
}

std::string parameterization_text(const ParameterizationReport& report) {
  std::size_t width = 4;
  for (const segmentation::PatchReport& patch : report.patches) width = std::max(width, patch.name.size());
  std::string text = fmt::format("       {:{}}  {:>6}  {:>9}  {:>5}  {}\n", "block", width, "points",
                                 "scaled J", "mean", "certificate");
  double volume = 0;
  for (std::size_t i = 0; i < report.patches.size(); ++i) {
    text += row(report.patches[i], i, width);
    volume += report.patches[i].volume;
  }
  const FaceReport& worst = report.worst_face();
  text += histogram_text(report);
  text += fmt::format("  largest deviation  {}, allowed {}, at {}\n",
                      with_unit(without_round_off(worst.deviation, report.size), "m"),
                      with_unit(report.tolerance, "m"), worst.name);
  if (report.largest_gap > 1e-3 * report.tolerance)
    text += fmt::format("  outlines differ    by up to {} in the input, {}\n",
                        with_unit(report.largest_gap, "m"), report.gap_at);
  text += fmt::format("  volume             {:.9g} m^3, size {}\n", volume, with_unit(report.size, "m"));
  text +=
      fmt::format("  time               {:.2f} s, {} rounds of knots, {} evaluations of the shape energy\n",
                  report.seconds, report.rounds, report.evaluations);
  return text;
}

}  // namespace isopatch::app
