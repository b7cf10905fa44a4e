#include "app/pages/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/pages/internal/base64.hpp"
#include "app/pages/internal/point_json.hpp"

namespace isopatch::app {
namespace {

// One field of all patches, sample by sample.
std::string block(const std::vector<Eigen::MatrixXd>& values) {
  std::vector<float> numbers;
  for (const Eigen::MatrixXd& of_patch : values)
    for (Eigen::Index i = 0; i < of_patch.size(); ++i)
      numbers.push_back(static_cast<float>(of_patch.data()[i]));
  return to_base64(numbers);
}

// What one unit of a short field's numbers is.
double step_of(const std::vector<Eigen::MatrixXd>& values) {
  double largest = 0;
  for (const Eigen::MatrixXd& of_patch : values)
    for (Eigen::Index i = 0; i < of_patch.size(); ++i)
      if (const double size = std::abs(of_patch.data()[i]); std::isfinite(size) && size > largest)
        largest = size;
  return largest > 0 ? largest / std::numeric_limits<std::int16_t>::max() : 1;
}

// The same in units of `step`; the least number there is where there is no finite value.
std::string short_block(const std::vector<Eigen::MatrixXd>& values, double step) {
  std::vector<std::int16_t> numbers;
  for (const Eigen::MatrixXd& of_patch : values)
    for (Eigen::Index i = 0; i < of_patch.size(); ++i) {
      const double value = of_patch.data()[i];
      numbers.push_back(std::isfinite(value) ? static_cast<std::int16_t>(std::lround(value / step))
                                             : std::numeric_limits<std::int16_t>::min());
    }
  return short_to_base64(numbers);
}

std::string points_block(const iga::PartSamples& samples) {
  std::vector<Eigen::MatrixXd> points;
  for (const iga::PatchSamples& patch : samples.patches) points.emplace_back(patch.points);
  return block(points);
}

const char* kind_of(const geometry::MultiPatch& model, const geometry::PatchFace& face) {
  const auto in = [&](const std::vector<geometry::PatchFace>& faces) {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
  };
  return in(model.boundary_faces()) ? "boundary" : in(model.degenerate_faces()) ? "collapsed" : "interface";
}

// Indices of the regions that a face belongs to.
Json regions_with(const std::vector<SceneRegion>& regions, const std::string& face) {
  Json result = Json::array();
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (std::find(regions[i].faces.begin(), regions[i].faces.end(), face) != regions[i].faces.end())
      result.push_back(i);
  return result;
}

Json patch_json(const Scene& scene, std::size_t p, Eigen::Index first) {
  const iga::PatchSamples& samples = scene.samples.patches[p];
  const ScenePatch& names = scene.patches[p];
  Json faces = Json::array();
  for (const geometry::Side side : geometry::all_sides) {
    const std::string& label = names.faces[static_cast<std::size_t>(side)];
    faces.push_back({{"kind", kind_of(*scene.model, {PatchId(static_cast<int>(p)), side})},
                     {"label", label},
                     {"supports", regions_with(scene.supports, label)},
                     {"loads", regions_with(scene.loads, label)}});
  }
  return {{"name", names.name},
          {"first", first},
          {"sizes", samples.sizes()},
          {"parameters", names.parameters},
          {"element_ends", samples.element_ends},
          {"faces", faces}};
}

Json regions_json(const std::vector<SceneRegion>& regions, const char* force) {
  Json result = Json::array();
  for (const SceneRegion& region : regions)
    result.push_back({{"name", region.name}, {"kind", region.kind}, {force, to_json(region.force)}});
  return result;
}

Json markers_json(const std::vector<SceneMarker>& markers) {
  Json result = Json::array();
  for (const SceneMarker& marker : markers)
    result.push_back({{"name", marker.name},
                      {"kind", marker.kind},
                      {"patch", marker.patch},
                      {"parameter", to_json(marker.parameter)},
                      {"point", to_json(marker.place)},
                      {"displacement", to_json(marker.displacement)},
                      {"von_mises", marker.von_mises}});
  return result;
}

Json warnings_json(const std::vector<SceneWarning>& warnings) {
  Json result = Json::array();
  for (const SceneWarning& warning : warnings)
    result.push_back({{"text", warning.text},
                      {"patch", warning.patch ? Json(*warning.patch) : Json()},
                      {"point", warning.place ? to_json(*warning.place) : Json()}});
  return result;
}

}  // namespace

std::string scene_json(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const iga::PatchSamples& patch : scene.samples.patches)
    box.extend(Eigen::AlignedBox3d(patch.points.rowwise().minCoeff(), patch.points.rowwise().maxCoeff()));
  Json json = {{"length", {{"unit", scene.length.unit}, {"factor", scene.length.factor}}},
               {"box", {{"min", to_json(box.min())}, {"max", to_json(box.max())}}},
               {"fields", Json::array()},
               {"points", points_block(scene.samples)},
               {"patches", Json::array()},
               {"supports", regions_json(scene.supports, "reaction")},
               {"loads", regions_json(scene.loads, "total")},
               {"markers", markers_json(scene.markers)},
               {"warnings", warnings_json(scene.warnings)},
               {"tolerance",
                {{"chord", scene.sampling.chord},
                 {"field", scene.sampling.field},
                 {"is_coarse", scene.samples.is_coarse}}}};
  for (const SceneField& field : scene.fields) {
    Json described = {{"key", field.key},
                      {"label", field.label},
                      {"unit", field.unit.unit},
                      {"factor", field.unit.factor},
                      {"components", field.values.empty() ? 1 : field.values[0].rows()}};
    if (!field.on.empty()) described["on"] = field.on;
    if (field.is_short) {
      const double step = step_of(field.values);
      described["step"] = step;
      json[field.key] = short_block(field.values, step);
    } else {
      json[field.key] = block(field.values);
    }
    json["fields"].push_back(described);
  }
  Eigen::Index first = 0;
  for (std::size_t p = 0; p < scene.samples.patches.size(); ++p) {
    json["patches"].push_back(patch_json(scene, p, first));
    first += scene.samples.patches[p].points.cols();
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isopatch::app
