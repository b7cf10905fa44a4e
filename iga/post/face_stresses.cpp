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

class FaceOfPatch {
 public:
  FaceOfPatch(const ElasticField& field, int patch, Side side)
      : index_(patch),
        patch_(field.patches[static_cast<std::size_t>(patch)]),
        displacement_(field.displacement[static_cast<std::size_t>(patch)].data()),
        material_(field.materials[static_cast<std::size_t>(patch)]),
        thermal_(field.thermal_strain(static_cast<std::size_t>(patch))),
        tensors_(patch_, points_on(patch_, side)) {}

  FaceStresses on_element(std::int64_t element, TensorBuffers<8>& buffers) const {
    FaceStresses result;
    result.max_von_mises.value = -1;
    gather(tensors_, element, patch_, displacement_, buffers.coefficients);
    tensors_.gradients(element, buffers);
    for (Eigen::Index point = 0; point < tensors_.point_count(); ++point)
      at_point(element, point, buffers, result);
    return result;
  }

 private:
  void at_point(std::int64_t element, Eigen::Index point, const TensorBuffers<8>& buffers,
                FaceStresses& result) const {
    const auto q = static_cast<std::size_t>(point);
    const RationalPoint place = rational_point(buffers, q);
    double scaled = 0;
    const MapState state = map_state(place.derivatives, scaled);
    if (state == MapState::collapsed) {
      ++result.left_out.collapsed;
    } else if (state == MapState::folded) {
      ++result.left_out.folded;
      if (is_larger(-scaled, result.left_out.worst.value))
        result.left_out.worst = {-scaled, place.value, index_, tensors_.parameter(element, point)};
    } else {
      const Eigen::Matrix3d gradient =
          rational_point(buffers, q, 4).derivatives * place.derivatives.inverse();
      const Eigen::Matrix3d sigma = stress_of_gradient(gradient, material_, thermal_.at(place.value));
      const double stress = von_mises(sigma);
      require_finite(stress, index_, place.value);
      if (is_larger(stress, result.max_von_mises.value))
        result.max_von_mises = {stress, place.value, index_, tensors_.parameter(element, point)};
      take(
          StressPoint{sigma, stress, material_.yield},
          [&]() -> Extremum {
            return {0, place.value, index_, tensors_.parameter(element, point)};
          },
          result.peaks);
    }
  }

  int index_;
  const NurbsVolume& patch_;
  const double* displacement_;
  const Material& material_;
  ThermalStrain thermal_;
  ElementTensors tensors_;
};

FaceStresses together(const FaceStresses& a, const FaceStresses& b) {
  return {larger(a.max_von_mises, b.max_von_mises), together(a.left_out, b.left_out),
          together(a.peaks, b.peaks)};
}

}  // namespace

FaceStresses stresses_on_faces(const ElasticField& field, const std::vector<PatchLayers>& parts) {
  FaceStresses result;
  result.max_von_mises.value = -1;
  std::vector<TensorBuffers<8>> buffers(static_cast<std::size_t>(omp_get_max_threads()));
  for (const PatchLayers& part : parts)
    for (const Side side : geometry::all_sides) {
      const NurbsVolume& patch = field.patches[static_cast<std::size_t>(part.patch)];
      const std::vector<std::int64_t> elements = elements_at(patch, part, side);
      const FaceOfPatch face(field, part.patch, side);
      std::vector<FaceStresses> found(elements.size());
      parallel_for(static_cast<std::int64_t>(elements.size()), [&](std::int64_t i, int thread) {
        const auto e = static_cast<std::size_t>(i);
        found[e] = face.on_element(elements[e], buffers[static_cast<std::size_t>(thread)]);
      });
      for (const FaceStresses& of_element : found) result = together(result, of_element);
    }
  return result;
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
