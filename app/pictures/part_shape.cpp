#include "app/pictures/part_shape.hpp"

#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

using geometry::PatchFace;

Eigen::VectorXd values_of(const iga::PatchSamples& samples, int patch, const ShapeOptions& options) {
  switch (options.field) {
    case PictureField::patch:
      return Eigen::VectorXd::Constant(samples.points.cols(), patch);
    case PictureField::jacobian:
      return samples.scaled_jacobian;
    case PictureField::displacement:
      if (options.component) return samples.displacements.row(*options.component).transpose();
      return samples.displacements.colwise().norm().transpose();
    case PictureField::von_mises:
      return samples.von_mises;
    default:
      return Eigen::VectorXd::Zero(samples.points.cols());
  }
}

PatchShape patch_shape(const iga::PatchSamples& samples, int patch, const ShapeOptions& options) {
  PatchShape result{samples.sizes(), samples.element_ends, samples.points, samples.points,
                    values_of(samples, patch, options)};
  if (options.deformation != 0) result.points += options.deformation * samples.displacements;
  return result;
}

/// The grid of one outer face: rows of indices of the patch's points, turned so that first x second points
/// outward.
struct FaceGrid {
  const PatchShape& patch;
  int first;
  int second;
  int fixed;
  int level;

  FaceGrid(const std::vector<PatchShape>& shape, const PatchFace& face)
      : patch(shape[static_cast<std::size_t>(face.patch.value)]),
        first((geometry::direction(face.side) + 1) % 3),
        second((geometry::direction(face.side) + 2) % 3),
        fixed(geometry::direction(face.side)),
        level(geometry::is_high(face.side) ? size(fixed) - 1 : 0) {
    if (!geometry::is_high(face.side)) std::swap(first, second);
  }
  int size(int direction) const { return patch.sizes[static_cast<std::size_t>(direction)]; }
  int count() const { return size(first) * size(second); }
  const std::vector<int>& ends(int direction) const {
    return patch.element_ends[static_cast<std::size_t>(direction)];
  }
  /// Index of a point in the patch.
  int operator()(int a, int b) const {
    std::array<int, 3> at{};
    at[static_cast<std::size_t>(first)] = a;
    at[static_cast<std::size_t>(second)] = b;
    at[static_cast<std::size_t>(fixed)] = level;
    return patch.index(at[0], at[1], at[2]);
  }
};

void add_triangle(Surface& surface, const std::array<int, 3>& triangle) {
  if (area_vector(surface, triangle).norm() > 0) surface.triangles.push_back(triangle);
}

/// @param start  where the face's points begin in the surface, which has room for them
void add_face(Surface& surface, const FaceGrid& face, int start) {
  const auto at = [&](int a, int b) { return start + a + face.size(face.first) * b; };
  for (int b = 0; b < face.size(face.second); ++b)
    for (int a = 0; a < face.size(face.first); ++a) {
      surface.points.col(at(a, b)) = face.patch.points.col(face(a, b));
      surface.undeformed.col(at(a, b)) = face.patch.undeformed.col(face(a, b));
      surface.values[at(a, b)] = face.patch.values[face(a, b)];
    }
  for (int b = 0; b + 1 < face.size(face.second); ++b)
    for (int a = 0; a + 1 < face.size(face.first); ++a) {
      add_triangle(surface, {at(a, b), at(a + 1, b), at(a + 1, b + 1)});
      add_triangle(surface, {at(a, b), at(a + 1, b + 1), at(a, b + 1)});
    }
}

/// Lines as they grow.
struct LineBuilder {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> undeformed;
  std::vector<std::array<int, 2>> segments;

  void add(const PatchShape& patch, const std::vector<int>& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto here = static_cast<int>(points.size());
      if (i > 0) segments.push_back({here - 1, here});
      points.emplace_back(patch.points.col(line[i]));
      undeformed.emplace_back(patch.undeformed.col(line[i]));
    }
  }
  Lines lines() const {
    const auto matrix = [](const std::vector<Eigen::Vector3d>& columns) {
      Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(columns.size()));
      for (std::size_t i = 0; i < columns.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = columns[i];
      return result;
    };
    return {matrix(points), matrix(undeformed), segments};
  }
};

/// Adds the grid lines of a face that lie at `positions` of its first direction, and run along the second; or
/// the other way around.
void add_grid_lines(LineBuilder& builder, const FaceGrid& face, bool along_second,
                    const std::vector<int>& positions) {
  const int length = face.size(along_second ? face.second : face.first);
  for (const int position : positions) {
    std::vector<int> line;
    for (int i = 0; i < length; ++i) line.push_back(along_second ? face(position, i) : face(i, position));
    builder.add(face.patch, line);
  }
}

std::vector<int> inner(const std::vector<int>& ends) {
  return ends.size() < 3 ? std::vector<int>{} : std::vector<int>(ends.begin() + 1, ends.end() - 1);
}

}  // namespace

std::vector<PatchShape> part_shape(const iga::PartSamples& samples, const ShapeOptions& options) {
  const bool of_solution =
      options.field == PictureField::displacement || options.field == PictureField::von_mises;
  std::vector<PatchShape> result;
  for (const iga::PatchSamples& patch : samples.patches) {
    if ((of_solution || options.deformation != 0) && patch.displacements.cols() == 0)
      throw Error(ErrorCode::invalid_argument, "a model without results has no displacement and no stress");
    result.push_back(patch_shape(patch, static_cast<int>(result.size()), options));
  }
  return result;
}

double visible_deformation(const iga::PartSamples& samples, double model_size) {
  double largest = 0;
  for (const iga::PatchSamples& patch : samples.patches)
    if (patch.displacements.cols() > 0)
      largest = std::max(largest, patch.displacements.colwise().norm().maxCoeff());
  if (!(largest > 0)) return 1;
  const double wanted = 0.1 * model_size / largest;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  const double leading = wanted / power;
  return power * (leading >= 5 ? 5 : leading >= 2 ? 2 : 1);
}

Surface outer_surface(const geometry::MultiPatch& model, const std::vector<PatchShape>& shape,
                      const std::map<PatchFace, double>& values) {
  int count = 0;
  for (const PatchFace& face : model.boundary_faces()) count += FaceGrid(shape, face).count();
  Surface surface;
  surface.points.resize(3, count);
  surface.undeformed.resize(3, count);
  surface.values.resize(count);
  int start = 0;
  for (const PatchFace& face : model.boundary_faces()) {
    const FaceGrid grid(shape, face);
    add_face(surface, grid, start);
    if (const auto found = values.find(face); found != values.end())
      surface.values.segment(start, grid.count()).setConstant(found->second);
    start += grid.count();
  }
  surface.normals = smooth_normals(surface);
  return surface;
}

Lines patch_edges(const geometry::MultiPatch& model, const std::vector<PatchShape>& shape) {
  LineBuilder builder;
  for (const PatchFace& face : model.boundary_faces()) {
    const FaceGrid grid(shape, face);
    add_grid_lines(builder, grid, true, {0, grid.size(grid.first) - 1});
    add_grid_lines(builder, grid, false, {0, grid.size(grid.second) - 1});
  }
  return builder.lines();
}

Lines element_edges(const geometry::MultiPatch& model, const std::vector<PatchShape>& shape) {
  LineBuilder builder;
  for (const PatchFace& face : model.boundary_faces()) {
    const FaceGrid grid(shape, face);
    add_grid_lines(builder, grid, true, inner(grid.ends(grid.first)));
    add_grid_lines(builder, grid, false, inner(grid.ends(grid.second)));
  }
  return builder.lines();
}

}  // namespace isopatch::app
