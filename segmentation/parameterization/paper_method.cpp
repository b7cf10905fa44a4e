#include "segmentation/parameterization/internal/paper_method.hpp"

#include <algorithm>
#include <map>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/tensor.hpp"
#include "segmentation/parameterization/internal/coons.hpp"

namespace isopatch::segmentation {
namespace {

constexpr int samples = 10;

const geometry::KnotVector& paper_knots() {
  static const auto knots = geometry::KnotVector::uniform(3, 4);
  return knots;
}

std::vector<double> equal_shares(int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(double(i) / (count - 1));
  return result;
}

/// Points of a block on a grid of 10 x 10 x 10: the faces' blends, then the blend of the faces.
Eigen::Matrix3Xd sampled(const Hexahedron& block) {
  const std::array<int, 3> sizes{samples, samples, samples};
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, samples * samples * samples);
  for (const Side side : geometry::all_sides) {
    const Eigen::Matrix3Xd face =
        FaceMap(block.face(side)).grid(equal_shares(samples), equal_shares(samples));
    const std::vector<int> where = geometry::face_control_points(sizes, side);
    for (std::size_t i = 0; i < where.size(); ++i)
      points.col(where[i]) = face.col(static_cast<Eigen::Index>(i));
  }
  // A net over knots of degree 1 blends at equal steps.
  const auto steps = geometry::KnotVector::uniform(1, samples - 1);
  return coons_net({steps, steps, steps}, points);
}

Eigen::Matrix3Xd fitted(Eigen::Matrix3Xd points) {
  const Eigen::MatrixXd basis(geometry::collocation(paper_knots(), equal_shares(samples)));
  const Eigen::MatrixXd inverse = pseudo_inverse(basis);
  std::array<int, 3> sizes{samples, samples, samples};
  for (int d = 0; d < 3; ++d) {
    points = geometry::apply_along<3>(points, sizes, d, inverse);
    sizes[static_cast<std::size_t>(d)] = paper_knots().size();
  }
  return points;
}

/// Where the points of a face, in its frame, lie in the net of the block that uses it.
std::vector<int> points_of(const HexFaceUse& use) {
  const int n = paper_knots().size();
  const std::vector<int> on_side = geometry::face_control_points({n, n, n}, use.side.side);
  std::vector<int> result;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      int a = use.orientation.swapped ? j : i, b = use.orientation.swapped ? i : j;
      if (use.orientation.flip_first) a = n - 1 - a;
      if (use.orientation.flip_second) b = n - 1 - b;
      result.push_back(on_side[static_cast<std::size_t>(a + n * b)]);
    }
  return result;
}

/// Replaces control points that are one by their mean; which are one is transitive around edges and vertices.
void average(const HexComplex& complex, std::vector<Eigen::Matrix3Xd>& nets) {
  const auto n = static_cast<int>(nets.front().cols());
  const int count = n * static_cast<int>(nets.size());
  UnionFind same(count);
  for (const HexFace& face : complex.topology.faces) {
    if (face.uses.size() < 2) continue;
    const std::vector<int> first = points_of(face.uses[0]), second = points_of(face.uses[1]);
    for (std::size_t i = 0; i < first.size(); ++i)
      same.unite(n * face.uses[0].side.block.value + first[i], n * face.uses[1].side.block.value + second[i]);
  }
  std::map<int, std::pair<Eigen::Vector3d, int>> sums;
  const auto point = [&](int i) { return nets[static_cast<std::size_t>(i / n)].col(i % n); };
  for (int i = 0; i < count; ++i) {
    auto& [sum, members] = sums.try_emplace(same.find(i), Eigen::Vector3d::Zero(), 0).first->second;
    sum += point(i);
    ++members;
  }
  for (int i = 0; i < count; ++i) {
    const auto& [sum, members] = sums.at(same.find(i));
    if (members > 1) point(i) = sum / members;
  }
}

DeviationGrid deviations(const HexComplex& complex, const HexFace& face, const geometry::NurbsVolume& patch) {
  const BlockSide side = face.uses[0].side;
  const Hexahedron& block = complex.block(side.block);
  const std::vector<double> at = equal_shares(33);
  const Eigen::Matrix3Xd points =
      geometry::points_on_grid(geometry::face_surface(patch, side.side), {at, at});
  return {at, at, (points - FaceMap(block.face(side.side)).grid(at, at)).colwise().norm()};
}

}  // namespace

PaperPatches paper_patches(const HexComplex& complex) {
  std::vector<Eigen::Matrix3Xd> nets;
  for (const Hexahedron& block : complex.blocks) nets.push_back(fitted(sampled(block)));
  average(complex, nets);
  PaperPatches result;
  for (const Eigen::Matrix3Xd& net : nets)
    result.patches.emplace_back(
        geometry::NurbsVolume::KnotVectors{paper_knots(), paper_knots(), paper_knots()}, net);
  for (const HexFace& face : complex.topology.faces)
    result.face_deviations.push_back(
        deviations(complex, face, result.patches[static_cast<std::size_t>(face.uses[0].side.block.value)]));
  return result;
}

}  // namespace isopatch::segmentation
