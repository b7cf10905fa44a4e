#include "iga/post/face_stresses.hpp"

#include <omp.h>

#include <Eigen/LU>

#include "geometry/patch_face.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/material/internal/point_fields.hpp"
#include "iga/spaces/internal/element_tensors.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::Side;

geometry::QuadratureRule even_points(int count) {
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
  return {Eigen::VectorXd::LinSpaced(count, 0, 1), weights};
}

// The points of an element that lie on the side.
std::array<geometry::QuadratureRule, 3> points_on(const NurbsVolume& patch, Side side) {
  std::array<geometry::QuadratureRule, 3> rules;
  for (int d = 0; d < 3; ++d) rules[static_cast<std::size_t>(d)] = even_points(2 * patch.degree(d) + 1);
  auto& across = rules[static_cast<std::size_t>(direction(side))];
  across.nodes = Eigen::VectorXd::Constant(1, is_high(side) ? 1.0 : 0.0);
  across.weights = Eigen::VectorXd::Ones(1);
  return rules;
}

// The elements of a part that touch a side, in increasing order.
std::vector<std::int64_t> elements_at(const NurbsVolume& patch, const PatchLayers& part, Side side) {
  std::array<int, 3> begin = {0, 0, part.first_layer};
  std::array<int, 3> end = {patch.knots(0).element_count(), patch.knots(1).element_count(), part.last_layer};
  const auto d = static_cast<std::size_t>(direction(side));
  const int at = is_high(side) ? patch.knots(direction(side)).element_count() - 1 : 0;
  begin[d] = std::max(begin[d], at);
  end[d] = std::min(end[d], at + 1);
  const std::int64_t row = patch.knots(0).element_count();
  const std::int64_t layer = row * patch.knots(1).element_count();
  std::vector<std::int64_t> result;
  for (int k = begin[2]; k < end[2]; ++k)
    for (int j = begin[1]; j < end[1]; ++j)
      for (int i = begin[0]; i < end[0]; ++i) result.push_back(i + row * j + layer * k);
  return result;
}

// A point of a face, whatever moves there.
struct FaceGeometry {
  Eigen::Vector3d place;
  Eigen::Matrix3d inverse;
  MapState state = MapState::sound;
  double scaled = 0;
};

struct FaceScratch {
  TensorBuffers<4> geometry, displacement;
  std::vector<FaceGeometry> points;
  std::vector<StressPeaks> seen;  // of each field, by this thread, whose elements come in order
};

// The stresses of several fields on one side of a patch.
class FaceOfPatch {
 public:
  FaceOfPatch(const std::vector<const ElasticField*>& fields, int patch, Side side)
      : index_(patch),
        fields_(fields),
        patch_(fields.front()->patches[static_cast<std::size_t>(patch)]),
        material_(fields.front()->materials[static_cast<std::size_t>(patch)]),
        tensors_(patch_, points_on(patch_, side)) {}

  std::vector<FaceStresses> on_element(std::int64_t element, FaceScratch& scratch) const {
    evaluate_geometry(element, scratch);
    scratch.seen.resize(fields_.size());
    std::vector<FaceStresses> result(fields_.size());
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const auto p = static_cast<std::size_t>(index_);
      result[i].max_von_mises.value = -1;
      gather(tensors_, element, fields_[i]->displacement[p], patch_.weights(),
             scratch.displacement.coefficients);
      tensors_.gradients(element, scratch.displacement);
      const ThermalStrain thermal = fields_[i]->thermal_strain(p);
      for (Eigen::Index point = 0; point < tensors_.point_count(); ++point)
        at_point(element, point, scratch, thermal, scratch.seen[i], result[i]);
    }
    return result;
  }

 private:
  void evaluate_geometry(std::int64_t element, FaceScratch& scratch) const {
    gather(tensors_, element, patch_.control_points(), patch_.weights(), scratch.geometry.coefficients);
    tensors_.gradients(element, scratch.geometry);
    scratch.points.resize(static_cast<std::size_t>(tensors_.point_count()));
    for (std::size_t q = 0; q < scratch.points.size(); ++q) {
      const RationalPoint place = rational_point(scratch.geometry, q);
      FaceGeometry& at = scratch.points[q];
      at.place = place.value;
      at.state = map_state(place.derivatives, at.scaled);
      if (at.state == MapState::sound) at.inverse = place.derivatives.inverse();
    }
  }
  void at_point(std::int64_t element, Eigen::Index point, const FaceScratch& scratch,
                const ThermalStrain& thermal, StressPeaks& seen, FaceStresses& result) const {
    const auto q = static_cast<std::size_t>(point);
    const FaceGeometry& at = scratch.points[q];
    if (at.state == MapState::collapsed) {
      ++result.left_out.collapsed;
    } else if (at.state == MapState::folded) {
      ++result.left_out.folded;
      if (is_larger(-at.scaled, result.left_out.worst.value))
        result.left_out.worst = {-at.scaled, at.place, index_, tensors_.parameter(element, point)};
    } else {
      const Eigen::Matrix3d gradient = rational_point(scratch.displacement, q).derivatives * at.inverse;
      const Eigen::Matrix3d sigma = stress_of_gradient(gradient, material_, thermal.at(at.place));
      const double stress = von_mises(sigma);
      require_finite(stress, index_, at.place);
      if (is_larger(stress, result.max_von_mises.value))
        result.max_von_mises = {stress, at.place, index_, tensors_.parameter(element, point)};
      take(
          StressPoint{sigma, stress, material_.yield},
          [&]() -> Extremum {
            return {0, at.place, index_, tensors_.parameter(element, point)};
          },
          seen, result.peaks);
    }
  }

  int index_;
  const std::vector<const ElasticField*>& fields_;
  const NurbsVolume& patch_;
  const Material& material_;
  ElementTensors tensors_;
};

FaceStresses together(const FaceStresses& a, const FaceStresses& b) {
  return {larger(a.max_von_mises, b.max_von_mises), together(a.left_out, b.left_out),
          together(a.peaks, b.peaks)};
}

}  // namespace

std::vector<FaceStresses> stresses_on_faces(const std::vector<const ElasticField*>& fields,
                                            const std::vector<PatchLayers>& parts) {
  std::vector<FaceStresses> result(fields.size());
  for (FaceStresses& one : result) one.max_von_mises.value = -1;
  std::vector<FaceScratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
  for (const PatchLayers& part : parts)
    for (const Side side : geometry::all_sides) {
      const NurbsVolume& patch = fields.front()->patches[static_cast<std::size_t>(part.patch)];
      const std::vector<std::int64_t> elements = elements_at(patch, part, side);
      const FaceOfPatch face(fields, part.patch, side);
      std::vector<std::vector<FaceStresses>> found(elements.size());
      parallel_for(static_cast<std::int64_t>(elements.size()), [&](std::int64_t i, int thread) {
        const auto e = static_cast<std::size_t>(i);
        found[e] = face.on_element(elements[e], scratch[static_cast<std::size_t>(thread)]);
      });
      for (const std::vector<FaceStresses>& of_element : found)
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = together(result[i], of_element[i]);
    }
  return result;
}

FaceStresses stresses_on_faces(const ElasticField& field, const std::vector<PatchLayers>& parts) {
  return stresses_on_faces(std::vector<const ElasticField*>{&field}, parts).front();
}

FaceStresses stresses_on_faces(const ElasticField& field) {
  std::vector<PatchLayers> parts;
  for (std::size_t p = 0; p < field.patches.size(); ++p)
    parts.push_back({static_cast<int>(p), 0, field.patches[p].knots(2).element_count()});
  return stresses_on_faces(field, parts);
}

FaceStresses summed(const FaceStresses& share, const solvers::Processes& processes) {
  if (processes.count() == 1) return share;
  return {largest(share.max_von_mises, processes), summed(share.left_out, processes),
          largest(share.peaks, processes)};
}

}  // namespace isopatch::iga
