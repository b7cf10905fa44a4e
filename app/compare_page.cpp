#include "app/compare_page.hpp"

#include <fmt/format.h>

#include <limits>

#include "app/comparison_plots.hpp"
#include "app/internal/comparison_object.hpp"
#include "app/internal/part_scene.hpp"
#include "app/summary.hpp"

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

// Tractions at all vertices of a part, on the first patch of each interface; elsewhere not a number. Where
// interfaces meet, that of the first of them. (3, vertices), Pa
Eigen::MatrixXd vertex_tractions(const iga::Discretization& d, const iga::PartSamples& samples,
                                 const std::vector<iga::InterfaceTraction>& tractions) {
  std::vector<Eigen::Index> first = {0};
  for (const iga::PatchSamples& patch : samples.patches) first.push_back(first.back() + patch.points.cols());
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Constant(3, first.back(), std::numeric_limits<double>::quiet_NaN());
  for (const iga::InterfaceTraction& traction : tractions) {
    if (!traction.field) continue;
    const geometry::Interface& interface = d.model.interfaces()[static_cast<std::size_t>(traction.interface)];
    for (const PatchFace& face : {interface.first, interface.second}) {
      const auto p = static_cast<std::size_t>(face.patch.value);
      for (const FaceVertex& vertex : face_vertices(samples.patches[p], face.side)) {
        auto at = result.col(first[p] + vertex.index);
        if (!at.allFinite()) at = iga::traction_at(d, traction, face, vertex.parameter);
      }
    }
  }
  return result;
}

double largest_finite_norm(const Eigen::MatrixXd& columns) {
  double largest = 0;
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    if (columns.col(i).allFinite()) largest = std::max(largest, columns.col(i).norm());
  return largest;
}

// Where the couplings differ most; displacement and stress are those of the part there.
Json difference_marker(const ComparedStudy& finest, const char* name, const char* kind,
                       const iga::Extremum& extremum) {
  const auto& model = finest.built.problem.discretization.model;
  const iga::FieldValues values =
      iga::evaluate(finest.field, extremum.patch, model.renamed(PatchId(extremum.patch), extremum.parameter));
  return {{"name", name},
          {"kind", kind},
          {"patch", extremum.patch},
          {"parameter", to_json(Eigen::Vector3d(extremum.parameter))},
          {"point", to_json(extremum.place)},
          {"displacement", to_json(values.displacement)},
          {"von_mises", values.von_mises}};
}

Json markers_json(const ComparedStudy& finest) {
  const CouplingComparison& comparison = finest.comparison;
  Json markers = Json::array();
  if (comparison.largest_displacement_difference.patch >= 0)
    markers.push_back(difference_marker(finest, "largest difference in displacement",
                                        "max_displacement_difference",
                                        comparison.largest_displacement_difference));
  if (comparison.largest_stress_difference.patch >= 0)
    markers.push_back(difference_marker(finest, "largest difference in stress", "max_von_mises_difference",
                                        comparison.largest_stress_difference));
  return markers;
}

Json scene_json(const ComparedStudy& finest) {
  const iga::Discretization& d = finest.built.problem.discretization;
  const iga::SamplingOptions options;
  const iga::PartSamples samples = iga::sample_part(d.model, finest.field, options);
  Json scene = part_scene(d.model, samples, options);
  if (!d.model.interfaces().empty()) {
    const Eigen::MatrixXd tractions = vertex_tractions(d, samples, finest.tractions);
    const DisplayUnit unit = display_unit(largest_finite_norm(tractions), "Pa");
    scene["fields"].push_back({{"key", "traction"},
                               {"label", "Traction on the first patch"},
                               {"unit", unit.name},
                               {"factor", unit.factor},
                               {"components", 3},
                               {"on", "interfaces"}});
    scene["traction"] = number_block(tractions);
  }
  scene["markers"] = markers_json(finest);
  return scene;
}

}  // namespace

std::string compare_page_data(const Study& study, const ComparedStudy& finest,
                              const std::vector<CouplingComparison>& levels) {
  Json plots = Json::array();
  for (const NamedPlot& plot : comparison_plots(levels, study.options.solver.tolerance))
    plots.push_back({{"title", plot.title}, {"svg", plot.svg}});
  const Json data = {{"kind", "compare"},
                     {"program", fmt::format("isopatch {}", version())},
                     {"title", study.title},
                     {"study", study.text},
                     {"comparison", comparison_object(study, levels)},
                     {"plots", plots},
                     {"scene", scene_json(finest)}};
  return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isopatch::app
