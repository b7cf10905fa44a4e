#include "app/internal/part_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace isopatch::app {
namespace {

using geometry::PatchFace;

std::string base64(const std::string& bytes) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

const char* kind_of(const geometry::MultiPatch& model, const PatchFace& face) {
  const auto is_among = [&](const std::vector<PatchFace>& faces) {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
  };
  return is_among(model.boundary_faces())     ? "boundary"
         : is_among(model.degenerate_faces()) ? "collapsed"
                                              : "interface";
}

Json faces_json(const geometry::MultiPatch& model, PatchId patch) {
  Json faces = Json::array();
  for (const geometry::Side side : geometry::all_sides) {
    const PatchFace face{patch, side};
    faces.push_back({{"kind", kind_of(model, face)},
                     {"label", model.label(face)},
                     {"supports", Json::array()},
                     {"loads", Json::array()}});
  }
  return faces;
}

// In the input's naming: those of a direction that was turned around decrease.
std::array<std::vector<double>, 3> named_parameters(const geometry::MultiPatch& model, PatchId patch,
                                                    const iga::PatchSamples& samples) {
  auto result = samples.parameters;
  for (int d = 0; d < 3; ++d)
    for (double& value : result[static_cast<std::size_t>(d)]) {
      geometry::Parameter<3> parameter = model.patch(patch).low();
      parameter[d] = value;
      value = model.renamed(patch, parameter)[d];
    }
  return result;
}

Json patches_json(const geometry::MultiPatch& model, const iga::PartSamples& samples) {
  Json result = Json::array();
  Eigen::Index first = 0;
  for (std::size_t p = 0; p < samples.patches.size(); ++p) {
    const iga::PatchSamples& patch = samples.patches[p];
    const PatchId id(static_cast<int>(p));
    result.push_back({{"name", std::to_string(p)},
                      {"first", first},
                      {"sizes", patch.sizes()},
                      {"parameters", named_parameters(model, id, patch)},
                      {"element_ends", patch.element_ends},
                      {"faces", faces_json(model, id)}});
    first += patch.points.cols();
  }
  return result;
}

// The values of all patches side by side.
template <class Member>
Eigen::MatrixXd joined(const iga::PartSamples& samples, Member member) {
  Eigen::Index count = 0;
  for (const iga::PatchSamples& patch : samples.patches) count += patch.points.cols();
  Eigen::MatrixXd result(member(samples.patches[0]).rows(), count);
  Eigen::Index first = 0;
  for (const iga::PatchSamples& patch : samples.patches) {
    result.middleCols(first, patch.points.cols()) = member(patch);
    first += patch.points.cols();
  }
  return result;
}

Json field_json(const char* key, const char* label, const DisplayUnit& unit, int components) {
  return {{"key", key},
          {"label", label},
          {"unit", unit.name},
          {"factor", unit.factor},
          {"components", components}};
}

}  // namespace

std::string number_block(const Eigen::MatrixXd& values) {
  static_assert(std::endian::native == std::endian::little, "blocks are little-endian");
  const Eigen::MatrixXf single = values.cast<float>();
  return base64({reinterpret_cast<const char*>(single.data()),
                 static_cast<std::size_t>(single.size()) * sizeof(float)});
}

DisplayUnit display_unit(double largest, const std::string& si_unit) {
  const std::vector<DisplayUnit> units =
      si_unit == "m" ? std::vector<DisplayUnit>{{"m", 1}, {"mm", 1e3}, {"um", 1e6}, {"nm", 1e9}}
                     : std::vector<DisplayUnit>{{"GPa", 1e-9}, {"MPa", 1e-6}, {"kPa", 1e-3}, {"Pa", 1}};
  for (const DisplayUnit& unit : units)
    if (largest * unit.factor >= 1) return unit;
  return largest > 0 ? units.back() : units[1];
}

Json part_scene(const geometry::MultiPatch& model, const iga::PartSamples& samples,
                const iga::SamplingOptions& options) {
  const Eigen::MatrixXd points = joined(samples, [](const auto& patch) { return patch.points; });
  const Eigen::MatrixXd displacements =
      joined(samples, [](const auto& patch) { return patch.displacements; });
  const Eigen::MatrixXd von_mises =
      joined(samples, [](const auto& patch) { return Eigen::RowVectorXd(patch.von_mises.transpose()); });
  const Eigen::MatrixXd jacobian = joined(
      samples, [](const auto& patch) { return Eigen::RowVectorXd(patch.scaled_jacobian.transpose()); });
  const Eigen::Vector3d low = points.rowwise().minCoeff();
  const Eigen::Vector3d high = points.rowwise().maxCoeff();
  const DisplayUnit length = (high - low).norm() < 10 ? DisplayUnit{"mm", 1e3} : DisplayUnit{"m", 1};
  return {
      {"length", {{"unit", length.name}, {"factor", length.factor}}},
      {"box", {{"min", to_json(low)}, {"max", to_json(high)}}},
      {"fields",
       {field_json("displacement", "Displacement",
                   display_unit(displacements.colwise().norm().maxCoeff(), "m"), 3),
        field_json("von_mises", "Von Mises stress", display_unit(von_mises.maxCoeff(), "Pa"), 1),
        field_json("scaled_jacobian", "Scaled Jacobian", {"", 1}, 1)}},
      {"points", number_block(points)},
      {"displacement", number_block(displacements)},
      {"von_mises", number_block(von_mises)},
      {"scaled_jacobian", number_block(jacobian)},
      {"patches", patches_json(model, samples)},
      {"supports", Json::array()},
      {"loads", Json::array()},
      {"markers", Json::array()},
      {"warnings", Json::array()},
      {"tolerance", {{"chord", options.chord}, {"field", options.field}, {"is_coarse", samples.is_coarse}}}};
}

}  // namespace isopatch::app
