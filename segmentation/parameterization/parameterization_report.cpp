#include "segmentation/parameterization/parameterization_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isopatch::segmentation {
namespace {

std::string short_place(const Eigen::Vector3d& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0], p[1], p[2]);
}

std::string complaint(const PatchReport& patch) {
  const std::string what =
      fmt::format("patch '{}' is {}: det J is {:.3g} at parameter {}, point {}", patch.name,
                  patch.certificate.sign == geometry::JacobianSign::negative ? "folded" : "not certified",
                  patch.certificate.smallest, short_place(patch.certificate.parameter),
                  short_place(patch.certificate.place));
  if (!patch.folded_edge) return what + "; optimization found no better map: divide the block";
  return fmt::format(
      "{}; its faces meet at 180 degrees or more on the edge at {}, where no regular patch has an edge: "
      "divide the block there",
      what, short_place(patch.folded_edge->place));
}

/// The least number with two digits that is not below x.
double rounded_up(double x) {
  const double step = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::ceil(x / step) * step;
}

std::string complaint(const FaceReport& face, const ParameterizationReport& report) {
  if (face.off_edges > report.tolerance)
    return fmt::format(
        "face {}: its surface lies {:.3g} off its own edges, more than {:.3g}, so nobody can say where the "
        "solid ends; mend the solid where it was drawn",
        face.name, face.off_edges, report.tolerance);
  const std::string what = fmt::format("face {} deviates by {:.3g} from its surface, more than {:.3g}",
                                       face.name, face.deviation, report.tolerance);
  if (face.gap > report.tolerance)
    return fmt::format("{}; its two blocks are {:.3g} apart there", what, face.gap);
  const double enough = rounded_up(face.deviation / report.size);
  if (report.max_spans == 0)
    return fmt::format("{}; method \"shared\" keeps the tolerance, or raise {} to {:.2g}", what,
                       report.names.tolerance, enough);
  return fmt::format("{}; raise {} above {}, or {} to {:.2g}", what, report.names.max_spans, report.max_spans,
                     report.names.tolerance, enough);
}

}  // namespace

bool ParameterizationReport::certified() const {
  return std::all_of(patches.begin(), patches.end(),
                     [](const PatchReport& patch) { return patch.certificate.accepted(); });
}

const FaceReport& ParameterizationReport::worst_face() const {
  return *std::max_element(faces.begin(), faces.end(), [](const FaceReport& a, const FaceReport& b) {
    return a.deviation < b.deviation;
  });
}

bool ParameterizationReport::usable() const {
  return certified() && worst_face().deviation <= tolerance;
}

std::vector<std::string> ParameterizationReport::complaints() const {
  std::vector<std::string> result = warnings;
  for (const PatchReport& patch : patches)
    if (!patch.certificate.accepted()) result.push_back(complaint(patch));
  for (const FaceReport& face : faces)
    if (face.deviation > tolerance) result.push_back(complaint(face, *this));
  return result;
}

}  // namespace isopatch::segmentation
