#include "app/reports/compare_page.hpp"

#include <fmt/format.h>

#include <limits>

#include "app/base/engineering_units.hpp"
#include "app/base/provenance.hpp"
#include "app/reports/comparison_plots.hpp"
#include "app/reports/comparison_report.hpp"
#include "app/reports/report_scene.hpp"
#include "app/results/run_summary.hpp"
#include "app/results/summary.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/patch_connections.hpp"

namespace isopatch::app {
namespace {

using geometry::PatchFace;

// The vertices of one side of a patch's grid, with their parameters on the face.
struct FaceVertex {
  Eigen::Index index = 0;
  geometry::Parameter<2> parameter;
};

std::vector<FaceVertex> face_vertices(const iga::PatchSamples& samples, geometry::Side side) {
  const auto [first, second] = geometry::tangents(side);
  const auto& u = samples.parameters[static_cast<std::size_t>(first)];
  const auto& v = samples.parameters[static_cast<std::size_t>(second)];
  const std::vector<int> indices = geometry::face_control_points(samples.sizes(), side);
  std::vector<FaceVertex> result;
  for (std::size_t i = 0; i < indices.size(); ++i)
    result.push_back({indices[i], {u[i % u.size()], v[i / u.size()]}});
  return result;
}

// Tractions at the samples, on the first patch of each interface and seen from both sides; elsewhere not a
// number. Where interfaces of a patch meet, that of the first of them.
SceneField traction_field(const iga::Discretization& d, const iga::PartSamples& samples,
                          const std::vector<iga::InterfaceTraction>& tractions) {
  SceneField field{"traction", "Traction on the first patch", {}, "interfaces", {}};
  for (const iga::PatchSamples& patch : samples.patches)
    field.values.push_back(
        Eigen::MatrixXd::Constant(3, patch.points.cols(), std::numeric_limits<double>::quiet_NaN()));
  double largest = 0;
  for (const iga::InterfaceTraction& traction : tractions) {
    if (!traction.field) continue;
    const geometry::Interface& interface = d.model.interfaces()[static_cast<std::size_t>(traction.interface)];
    for (const PatchFace& face : {interface.first, interface.second}) {
      const auto p = static_cast<std::size_t>(face.patch.value);
      for (const FaceVertex& vertex : face_vertices(samples.patches[p], face.side)) {
        auto at = field.values[p].col(vertex.index);
        if (at.allFinite()) continue;
        at = iga::traction_at(d, traction, face, vertex.parameter);
        largest = larger(largest, at.norm());
      }
    }
  }
  field.unit = display_unit(largest, "Pa");
  return field;
}

// Where the couplings differ most; displacement and stress are those of the part there.
void add_marker(const ComparedStudy& finest, const char* name, const iga::Extremum& extremum,
                std::vector<SceneMarker>& markers) {
  if (extremum.patch < 0) return;
  const auto& model = finest.run.built.problem.discretization.model;
  const iga::FieldValues values =
      iga::evaluate(finest.run.solution.field, extremum.patch,
                    model.from_input(PatchId(extremum.patch), extremum.parameter));
  markers.push_back({name, "difference", extremum.patch, extremum.parameter, extremum.place,
                     values.displacement, values.von_mises});
}

}  // namespace

std::string compare_html(const Study& study, const ComparedStudy& finest,
                         const std::vector<CouplingComparison>& levels, const std::string& json) {
  const iga::ElasticField& field = finest.run.solution.field;
  const geometry::MultiPatch model = geometry::connected(
      field.patches, geometry::connections_of(finest.run.built.problem.discretization.model));
  Scene scene = report_scene(field, model, summarized(study, finest.run));
  if (!finest.tractions.empty())
    scene.fields.push_back(
        traction_field(finest.run.built.problem.discretization, scene.samples, finest.tractions));
  add_marker(finest, "largest difference in displacement", finest.comparison.largest_displacement_difference,
             scene.markers);
  add_marker(finest, "largest difference in stress", finest.comparison.largest_stress_difference,
             scene.markers);
  Page page;
  page.kind = "compare";
  page.program = fmt::format("isopatch {}", version());
  page.title = study.title;
  page.study = study.text;
  page.summary_json = json;
  page.plots = comparison_plots(levels, study.options.solver.tolerance);
  page.scene = std::move(scene);
  return to_html(page);
}

}  // namespace isopatch::app
