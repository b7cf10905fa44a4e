#include "iga/output/surface_points.hpp"

#include <utility>

#include "geometry/collapse.hpp"

namespace isopatch::iga {
namespace {

using geometry::PatchFace;
using geometry::Side;

// Edges of a patch are numbered 4 * direction + (high end of the first other direction) + 2 * (of the
// second), corners by the bits of their high ends.
geometry::PatchEdge patch_edge(int edge) {
  return {edge % 12 / 4, {edge % 2 == 1, edge / 2 % 2 == 1}};
}

int corner_of(int edge, bool high) {
  const geometry::PatchEdge e = patch_edge(edge);
  const auto others = geometry::tangents(geometry::side_of(e.along, false));
  return 8 * (edge / 12) + (high << e.along) + (e.high[0] << others[0]) + (e.high[1] << others[1]);
}

// The edge of a face along its tangent direction a, at the low or high end of the other one.
int edge_of(const PatchFace& face, std::size_t a, bool high) {
  const auto tangents = geometry::tangents(face.side);
  const int across = tangents[1 - a];
  const int normal = geometry::direction(face.side);
  const bool at_normal = geometry::is_high(face.side);
  const bool first = across < normal ? high : at_normal;
  const bool second = across < normal ? at_normal : high;
  return 12 * face.patch.value + 4 * tangents[a] + first + 2 * second;
}

std::size_t number(const PatchFace& face) {
  return static_cast<std::size_t>(6 * face.patch.value + static_cast<int>(face.side));
}

bool flips(const geometry::FaceOrientation& orientation, std::size_t parameter) {
  return parameter == 0 ? orientation.flip_first : orientation.flip_second;
}

}  // namespace

SurfacePoints::SurfacePoints(const geometry::MultiPatch& model,
                             const std::vector<geometry::NurbsVolume>& patches,
                             const std::vector<geometry::GridParameters<3>>& parameters)
    : patches_(patches),
      parameters_(parameters),
      edges_(12 * static_cast<int>(patches.size())),
      corners_(8 * static_cast<int>(patches.size())) {
  const int count = static_cast<int>(patches.size());
  for (int p = 0; p < count; ++p)
    for (const Side side : geometry::all_sides) faces_.push_back({{PatchId(p), side}, {}});
  collapsed_faces_.assign(faces_.size(), 0);
  collapsed_edges_.assign(static_cast<std::size_t>(12 * count), 0);
  for (const geometry::Interface& interface : model.interfaces()) {
    join(interface.first, interface.second, interface.orientation);
    if (interface.first < interface.second)
      faces_[number(interface.second)] = {interface.first, inverse(interface.orientation)};
    else
      faces_[number(interface.first)] = {interface.second, interface.orientation};
  }
  join_collapsed(model);
}

void SurfacePoints::join(const PatchFace& first, const PatchFace& second,
                         const geometry::FaceOrientation& orientation) {
  for (std::size_t a = 0; a < 2; ++a) {
    const std::size_t b = orientation.swapped ? 1 - a : a;
    for (const bool high : {false, true}) {
      const int here = edge_of(first, a, high);
      const int there = edge_of(second, b, high != flips(orientation, 1 - b));
      const bool turned = flips(orientation, b);
      edges_.unite(here, there, turned);
      corners_.unite(corner_of(here, false), corner_of(there, turned));
      corners_.unite(corner_of(here, true), corner_of(there, !turned));
    }
  }
}

void SurfacePoints::join_collapsed(const geometry::MultiPatch& model) {
  const double tolerance = model.tolerance().same_point * model.size();
  for (int i = 0; i < static_cast<int>(collapsed_edges_.size()); ++i)
    if (is_collapsed(model.patches()[static_cast<std::size_t>(i / 12)], patch_edge(i), tolerance)) {
      corners_.unite(corner_of(i, false), corner_of(i, true));
      collapsed_edges_[static_cast<std::size_t>(i)] = 1;
    }
  for (const PatchFace& face : model.degenerate_faces())
    for (std::size_t a = 0; a < 2; ++a) {
      if (!is_collapsed(model.patch(face.patch), face.side, geometry::tangents(face.side)[a], tolerance))
        continue;
      collapsed_faces_[number(face)] = static_cast<char>(collapsed_faces_[number(face)] | (1 << a));
      edges_.unite(edge_of(face, 1 - a, false), edge_of(face, 1 - a, true), false);
    }
  for (int i = 0; i < static_cast<int>(collapsed_edges_.size()); ++i)
    if (collapsed_edges_[static_cast<std::size_t>(i)])
      collapsed_edges_[static_cast<std::size_t>(edges_.find(i).root)] = 1;
}

Eigen::Vector3d SurfacePoints::corner(int corner) const {
  corner = corners_.find(corner);
  const geometry::NurbsVolume& patch = patches_[static_cast<std::size_t>(corner / 8)];
  const auto [m, n, o] = patch.sizes();
  return patch.control_points().col((corner & 1 ? m - 1 : 0) +
                                    m * ((corner & 2 ? n - 1 : 0) + n * (corner & 4 ? o - 1 : 0)));
}

Eigen::Matrix3Xd SurfacePoints::edge(int edge) const {
  const SignedUnionFind::Member owner = edges_.find(edge);
  const auto p = static_cast<std::size_t>(owner.root / 12);
  const geometry::NurbsVolume& patch = patches_[p];
  const geometry::PatchEdge e = patch_edge(owner.root);
  const auto along = static_cast<std::size_t>(e.along);
  const std::vector<int> indices = geometry::edge_control_points(patch.sizes(), e);
  const geometry::NurbsCurve curve({patch.knots()[along]}, patch.control_points()(Eigen::all, indices),
                                   patch.weights()(indices));
  Eigen::Matrix3Xd points = geometry::points_on_grid(curve, {parameters_[p][along]});
  if (owner.against) points = points.rowwise().reverse().eval();
  const Eigen::Vector3d low = corner(corner_of(edge, false)), high = corner(corner_of(edge, true));
  if (collapsed_edges_[static_cast<std::size_t>(owner.root)]) points.colwise() = low;
  points.leftCols<1>() = low;
  points.rightCols<1>() = high;
  return points;
}

// As the owner has them; the border is set right by `face`.
Eigen::Matrix3Xd SurfacePoints::inside(const PatchFace& face) const {
  const FaceOwner& owner = faces_[number(face)];
  const auto grid = [&](const PatchFace& f) -> std::array<const std::vector<double>*, 2> {
    const auto tangents = geometry::tangents(f.side);
    const auto& all = parameters_[static_cast<std::size_t>(f.patch.value)];
    return {&all[static_cast<std::size_t>(tangents[0])], &all[static_cast<std::size_t>(tangents[1])]};
  };
  const auto there = grid(owner.face);
  const Eigen::Matrix3Xd points = geometry::points_on_grid(
      face_surface(patches_[static_cast<std::size_t>(owner.face.patch.value)], owner.face.side),
      {*there[0], *there[1]});
  const auto here = grid(face);
  const auto m = static_cast<Eigen::Index>(here[0]->size()), n = static_cast<Eigen::Index>(here[1]->size());
  const auto rows = static_cast<Eigen::Index>(there[0]->size());
  Eigen::Matrix3Xd result(3, m * n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < m; ++i) {
      std::array<Eigen::Index, 2> at = {i, j};
      if (owner.orientation.swapped) std::swap(at[0], at[1]);
      for (std::size_t b = 0; b < 2; ++b)
        if (flips(owner.orientation, b)) at[b] = static_cast<Eigen::Index>(there[b]->size()) - 1 - at[b];
      result.col(i + m * j) = points.col(at[0] + rows * at[1]);
    }
  return result;
}

Eigen::Matrix3Xd SurfacePoints::face(int patch, Side side) const {
  const PatchFace face{PatchId(patch), side};
  const std::array<Eigen::Matrix3Xd, 4> border = {edge(edge_of(face, 0, false)), edge(edge_of(face, 0, true)),
                                                  edge(edge_of(face, 1, false)),
                                                  edge(edge_of(face, 1, true))};
  const Eigen::Index m = border[0].cols(), n = border[2].cols();
  const char collapsed = collapsed_faces_[number(face)];
  if (collapsed & 1) {
    Eigen::Matrix3Xd result(3, m * n);
    for (Eigen::Index j = 0; j < n; ++j) result.middleCols(m * j, m).colwise() = border[2].col(j);
    return result;
  }
  if (collapsed & 2) return border[0].replicate(1, n);
  Eigen::Matrix3Xd result = inside(face);
  for (Eigen::Index j = 0; j < n; ++j) {
    result.col(m * j) = border[2].col(j);
    result.col(m * j + m - 1) = border[3].col(j);
  }
  result.leftCols(m) = border[0];
  result.rightCols(m) = border[1];
  return result;
}

}  // namespace isopatch::iga
