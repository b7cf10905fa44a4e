#include "geometry/models/box.hpp"

#include <random>

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/models/reorient.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* box_model_name = "box";
constexpr std::array<std::string_view, 6> names = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
// Below 1 / sqrt(3): each column of the Jacobian matrix, in units of a patch's size, then differs so little
// from a column of the identity that the matrix, and every Bernstein coefficient of its determinant, stays
// positive.
constexpr double largest_change = 0.55;
using Index = std::array<int, 3>;

// Points on a regular lattice of the box that patches share, in units of a patch's size.
class Lattice {
 public:
  Lattice(const Index& cells, int points_per_cell) : per_cell_(points_per_cell) {
    for (std::size_t d = 0; d < 3; ++d) sizes_[d] = cells[d] * points_per_cell + 1;
    points_.resize(3, Eigen::Index{1} * sizes_[0] * sizes_[1] * sizes_[2]);
    for_each([&](const Index& i) { (*this)(i) = Eigen::Vector3d(i[0], i[1], i[2]) / per_cell_; });
  }
  template <class Visit>
  void for_each(Visit visit) const {
    for (int k = 0; k < sizes_[2]; ++k)
      for (int j = 0; j < sizes_[1]; ++j)
        for (int i = 0; i < sizes_[0]; ++i) visit(Index{i, j, k});
  }
  Eigen::Matrix3Xd::ColXpr operator()(const Index& i) { return points_.col(column(i)); }
  Eigen::Matrix3Xd::ConstColXpr operator()(const Index& i) const { return points_.col(column(i)); }
  bool on_outside(const Index& i, std::size_t d) const { return i[d] == 0 || i[d] == sizes_[d] - 1; }
  int points_per_cell() const { return per_cell_; }

 private:
  Eigen::Index column(const Index& i) const {
    return i[0] + Eigen::Index{sizes_[0]} * (i[1] + Eigen::Index{sizes_[1]} * i[2]);
  }
  int per_cell_;
  Index sizes_;
  Eigen::Matrix3Xd points_;
};

// A vector in the ball of that radius, more than half of it long so that nothing is left regular by chance.
Eigen::Vector3d random_vector(std::mt19937& random, double radius) {
  // Not the library's distributions, whose numbers differ between machines.
  const auto number = [&] { return random() / 2147483648.0 - 1; };
  while (true) {
    const double x = number();
    const double y = number();
    const double z = number();
    const Eigen::Vector3d candidate(x, y, z);
    if (candidate.norm() <= 1 && candidate.norm() >= 0.5) return radius * candidate;
  }
}

void displace(Lattice& lattice, const Index& i, const BoxOptions& options, std::mt19937& random,
              double radius) {
  Eigen::Vector3d move = random_vector(random, radius);
  bool inside = true;
  for (std::size_t d = 0; d < 3; ++d)
    if (lattice.on_outside(i, d)) {
      move[static_cast<Eigen::Index>(d)] = 0;
      inside = false;
    }
  if (inside || options.distort_faces) lattice(i) += move;
}

Lattice distorted_corners(const BoxOptions& options, std::mt19937& random) {
  Lattice corners(options.patches, 1);
  if (options.distortion > 0)
    corners.for_each(
        [&](const Index& i) { displace(corners, i, options, random, 0.5 * options.distortion); });
  return corners;
}

// The control points of the same trilinear cells in degree 2, those that are no corner displaced.
Lattice curved(const Lattice& corners, const BoxOptions& options, std::mt19937& random) {
  Lattice result(options.patches, 2);
  result.for_each([&](const Index& i) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int corner = 0; corner < 8; ++corner)
      mean += corners(
          Index{(i[0] + (corner & 1)) / 2, (i[1] + (corner >> 1 & 1)) / 2, (i[2] + (corner >> 2)) / 2});
    result(i) = mean / 8;
    if (i[0] % 2 + i[1] % 2 + i[2] % 2 > 0) displace(result, i, options, random, 0.25 * options.curvature);
  });
  return result;
}

NurbsVolume patch_of(const Lattice& lattice, const Index& cell, const BoxOptions& options) {
  const int degree = lattice.points_per_cell();
  const Eigen::Array3d cell_size =
      options.size.array() / Eigen::Array3d(options.patches[0], options.patches[1], options.patches[2]);
  Eigen::Matrix3Xd points(3, (degree + 1) * (degree + 1) * (degree + 1));
  Eigen::Index column = 0;
  for (int k = 0; k <= degree; ++k)
    for (int j = 0; j <= degree; ++j)
      for (int i = 0; i <= degree; ++i) {
        const Index at = {cell[0] * degree + i, cell[1] * degree + j, cell[2] * degree + k};
        points.col(column++) = options.origin.array() + lattice(at).array() * cell_size;
      }
  const KnotVector knots = KnotVector::bezier(degree);
  return NurbsVolume({knots, knots, knots}, points);
}

}  // namespace

void validate(const BoxOptions& options) {
  constexpr std::array axes = {"x", "y", "z"};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::string axis = std::string(" along ") + axes[d];
    check_length(box_model_name, "size" + axis, options.size[static_cast<Eigen::Index>(d)]);
    check_range(box_model_name, "origin" + axis, options.origin[static_cast<Eigen::Index>(d)], -1e100, 1e100);
    check_count(box_model_name, "patches" + axis, options.patches[d]);
  }
  check_total(box_model_name, 1.0 * options.patches[0] * options.patches[1] * options.patches[2]);
  check_range(box_model_name, "distortion", options.distortion, 0, largest_change);
  check_range(box_model_name, "curvature", options.curvature, 0, largest_change);
  check_range(box_model_name, "distortion + curvature", options.distortion + options.curvature, 0,
              largest_change);
}

PatchSet box_model(const BoxOptions& options) {
  validate(options);
  std::mt19937 random(options.seed);
  const Lattice corners = distorted_corners(options, random);
  const Lattice lattice = options.curvature > 0 ? curved(corners, options, random) : corners;
  ModelBuilder builder;
  for (int k = 0; k < options.patches[2]; ++k)
    for (int j = 0; j < options.patches[1]; ++j)
      for (int i = 0; i < options.patches[0]; ++i) {
        const Index cell = {i, j, k};
        std::vector<std::pair<Side, std::string_view>> outside;
        for (const Side side : all_sides) {
          const auto d = static_cast<std::size_t>(direction(side));
          const int last = is_high(side) ? options.patches[d] - 1 : 0;
          if (cell[d] == last) outside.emplace_back(side, names[static_cast<std::size_t>(side)]);
        }
        builder.add(patch_of(lattice, cell, options), outside);
      }
  builder.join_grid(options.patches);
  return options.orientation_seed ? randomly_reoriented(builder.patches(), *options.orientation_seed)
                                  : builder.patches();
}

}  // namespace isopatch::geometry
