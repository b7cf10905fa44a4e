#include "iga/assembly/internal/patch_side.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "geometry/quadrature.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::iga {

using geometry::Side;

PatchSide::PatchSide(const PatchSpace& space, Side side, int first_node)
    : space_(space),
      side_(side),
      first_node_(first_node),
      surface_(geometry::face_surface(*space.geometry, side)),
      along_(geometry::tangents(side)) {
  for (int d = 0; d < 3; ++d)
    breaks_[static_cast<std::size_t>(d)] = space.knots[static_cast<std::size_t>(d)].breaks();
}

geometry::DividedSurface PatchSide::divided() const {
  return {&surface_,
          {breaks_[static_cast<std::size_t>(along_[0])], breaks_[static_cast<std::size_t>(along_[1])]}};
}

int PatchSide::degree() const {
  return std::max({space_.knots[0].degree(), space_.knots[1].degree(), space_.knots[2].degree()});
}

const geometry::KnotVector& PatchSide::knots(int along) const {
  return space_.knots[static_cast<std::size_t>(along_[static_cast<std::size_t>(along)])];
}

std::array<int, 3> PatchSide::element(const ElementOfFace& of_face) const {
  std::array<int, 3> result;
  result[static_cast<std::size_t>(along_[0])] = of_face[0];
  result[static_cast<std::size_t>(along_[1])] = of_face[1];
  const int d = geometry::direction(side_);
  result[static_cast<std::size_t>(d)] =
      geometry::is_high(side_) ? static_cast<int>(breaks_[static_cast<std::size_t>(d)].size()) - 2 : 0;
  return result;
}

PatchSide::Functions PatchSide::functions(const ElementOfFace& of_face,
                                          const geometry::Parameter<2>& on_side) const {
  // Neither values nor slopes of what is behind the second layer reach the side.
  return functions_of_layers(of_face, geometry::on_side(*space_.geometry, side_, on_side), 2);
}

PatchSide::Functions PatchSide::functions_behind(const ElementOfFace& of_face,
                                                 const geometry::Parameter<3>& at) const {
  return functions_of_layers(of_face, at, degree() + 1);
}

std::array<geometry::Parameter<3>, 2> PatchSide::box_behind(const ElementOfFace& of_face) const {
  const std::array<int, 3> element = this->element(of_face);
  std::array<geometry::Parameter<3>, 2> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto e = static_cast<std::size_t>(element[d]);
    result[0][static_cast<Eigen::Index>(d)] = breaks_[d][e];
    result[1][static_cast<Eigen::Index>(d)] = breaks_[d][e + 1] - breaks_[d][e];
  }
  return result;
}

PatchSide::Functions PatchSide::functions_of_layers(const ElementOfFace& of_face,
                                                    const geometry::Parameter<3>& at, int layers) const {
  const std::array<int, 3> element = this->element(of_face);
  std::array<Eigen::MatrixXd, 3> bases;
  std::array<int, 3> first;
  for (std::size_t d = 0; d < 3; ++d) {
    const geometry::KnotVector& knots = space_.knots[d];
    const auto e = static_cast<std::size_t>(element[d]);
    const int span = knots.span(0.5 * (breaks_[d][e] + breaks_[d][e + 1]));
    first[d] = span - knots.degree();
    bases[d] = geometry::basis_on_span(knots, span, at[static_cast<Eigen::Index>(d)], 1);
  }
  const Eigen::Matrix3d inverse = space_.geometry->jacobian(at).inverse();
  Functions result;
  // Along the gradient of the parameter that is constant on the side.
  result.normal =
      (geometry::is_high(side_) ? 1 : -1) * inverse.row(geometry::direction(side_)).transpose().normalized();
  add_functions(bases, first, layers, result);
  for (Eigen::Vector3d& gradient : result.gradients) gradient = inverse.transpose() * gradient;
  return result;
}

void PatchSide::add_functions(const std::array<Eigen::MatrixXd, 3>& bases, const std::array<int, 3>& first,
                              int layers, Functions& result) const {
  const auto sizes = space_.sizes();
  const int across = geometry::direction(side_);
  const int on_side = geometry::is_high(side_) ? sizes[static_cast<std::size_t>(across)] - 1 : 0;
  // The layers are the first or the last functions of the direction across.
  std::array<int, 3> begin = {0, 0, 0}, end;
  for (std::size_t d = 0; d < 3; ++d) end[d] = static_cast<int>(bases[d].cols());
  const auto a = static_cast<std::size_t>(across);
  if (geometry::is_high(side_))
    begin[a] = std::max(0, end[a] - layers);
  else
    end[a] = std::min(end[a], layers);
  const auto count =
      static_cast<std::size_t>((end[0] - begin[0]) * (end[1] - begin[1]) * (end[2] - begin[2]));
  result.nodes.reserve(count);
  result.values.reserve(count);
  result.gradients.reserve(count);
  double denominator = 0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (int k = begin[2]; k < end[2]; ++k)
    for (int j = begin[1]; j < end[1]; ++j)
      for (int i = begin[0]; i < end[0]; ++i) {
        const std::array<int, 3> index = {first[0] + i, first[1] + j, first[2] + k};
        const int node = index[0] + sizes[0] * (index[1] + sizes[1] * index[2]);
        const double weight = space_.is_rational() ? space_.weights[node] : 1.0;
        result.nodes.push_back(first_node_ + node);
        result.is_on_side.push_back(index[static_cast<std::size_t>(across)] == on_side);
        result.values.push_back(weight * bases[0](0, i) * bases[1](0, j) * bases[2](0, k));
        result.gradients.emplace_back(weight * bases[0](1, i) * bases[1](0, j) * bases[2](0, k),
                                      weight * bases[0](0, i) * bases[1](1, j) * bases[2](0, k),
                                      weight * bases[0](0, i) * bases[1](0, j) * bases[2](1, k));
        denominator += result.values.back();
        slope += result.gradients.back();
      }
  for (std::size_t f = 0; f < result.nodes.size(); ++f) {
    result.values[f] /= denominator;
    result.gradients[f] = (result.gradients[f] - result.values[f] * slope) / denominator;
  }
}

int points_of_cell(const PatchSide& first, const PatchSide& second) {
  constexpr int beyond_degree = 3;
  return std::max(first.degree(), second.degree()) + beyond_degree;
}

}  // namespace isopatch::iga
