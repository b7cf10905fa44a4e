#include "segmentation/parameterization/internal/face_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geometry/splines/grid.hpp"
#include "segmentation/parameterization/internal/outline.hpp"

namespace isopatch::segmentation {
namespace {

std::vector<double> equal_steps(int cells) {
  std::vector<double> result;
  for (int i = 0; i <= cells; ++i) result.push_back(double(i) / cells);
  return result;
}

}  // namespace

const char* name(FaceMapKind kind) {
  return kind == FaceMapKind::coons ? "coons" : "mean_value";
}

FaceMap::FaceMap(QuadFace face) : FaceMap(std::move(face), {}) {}

FaceMap::FaceMap(QuadFace face, std::array<SidePace, 4> paces)
    : face_(std::move(face)), paces_(std::move(paces)) {
  Eigen::AlignedBox2d box;
  for (const DomainCurve& side : face_.sides) {
    arcs_.emplace_back([&](double t) { return face_.surface(side(t)); });
    for (const double t : {0.0, 0.5, 1.0}) box.extend(side(t));
  }
  domain_size_ = box.diagonal().norm();
}

double FaceMap::side_parameter(int side, double share) const {
  const auto k = static_cast<std::size_t>(side);
  return paces_[k] ? paces_[k](share) : arcs_[k].parameter(share);
}

double FaceMap::side_share(int side, double t) const {
  double low = 0, high = 1;
  if (t <= low || t >= high) return std::clamp(t, low, high);
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (side_parameter(side, middle) < t ? low : high) = middle;
  }
  return (low + high) / 2;
}

Eigen::Matrix2Xd FaceMap::side_domain(int side, const std::vector<double>& shares) const {
  const auto k = static_cast<std::size_t>(side);
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(shares.size()));
  for (std::size_t i = 0; i < shares.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = face_.sides[k](side_parameter(side, shares[i]));
  return result;
}

Eigen::Matrix3Xd FaceMap::side_points(int side, const std::vector<double>& shares) const {
  return on_surface(side_domain(side, shares));
}

Eigen::Matrix3Xd FaceMap::on_surface(const Eigen::Matrix2Xd& domain) const {
  Eigen::Matrix3Xd result(3, domain.cols());
  for (Eigen::Index i = 0; i < domain.cols(); ++i) result.col(i) = face_.surface(domain.col(i));
  return result;
}

Eigen::Matrix2Xd FaceMap::domain_grid(const std::vector<double>& s, const std::vector<double>& t) const {
  const auto n = static_cast<Eigen::Index>(s.size());
  const auto m = static_cast<Eigen::Index>(t.size());
  const Eigen::Matrix2Xd low = side_domain(0, s), high = side_domain(1, s);
  const Eigen::Matrix2Xd left = side_domain(2, t), right = side_domain(3, t);
  const Eigen::Vector2d a = face_.sides[0](0), b = face_.sides[0](1), c = face_.sides[1](0),
                        d = face_.sides[1](1);
  Eigen::Matrix2Xd result(2, n * m);
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = s[static_cast<std::size_t>(i)], y = t[static_cast<std::size_t>(j)];
      result.col(i + n * j) = (1 - y) * low.col(i) + y * high.col(i) + (1 - x) * left.col(j) +
                              x * right.col(j) - (1 - y) * ((1 - x) * a + x * b) - y * ((1 - x) * c + x * d);
    }
  for (const geometry::NurbsSurface& displacement : displacements_)
    result += geometry::points_on_grid(displacement, {s, t}).topRows<2>();
  return result;
}

Eigen::Vector2d FaceMap::domain_point(double s, double t) const {
  return domain_grid({s}, {t});
}

Eigen::Matrix3Xd FaceMap::grid(const std::vector<double>& s, const std::vector<double>& t) const {
  return on_surface(domain_grid(s, t));
}

FaceMap FaceMap::moved(const geometry::NurbsSurface& displacement, FaceMapKind kind) const {
  FaceMap result = *this;
  result.kind_ = kind;
  result.displacements_.push_back(displacement);
  return result;
}

double smallest_sine(const FaceMap& map) {
  constexpr int cells = 24;
  constexpr Eigen::Index n = cells + 1;
  const std::vector<double> at = equal_steps(cells);
  const Eigen::Matrix2Xd domain = map.domain_grid(at, at);
  const Eigen::Matrix3Xd points = map.grid(at, at);
  double outline = 0;
  const auto add = [&](Eigen::Index a, Eigen::Index b) {
    outline += doubled_area(domain.col(0), domain.col(a), domain.col(b));
  };
  for (Eigen::Index i = 0; i < cells; ++i) {
    add(i, i + 1);
    add(n * i + cells, n * (i + 1) + cells);
    add(n * cells + i + 1, n * cells + i);
    add(n * (i + 1), n * i);
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < cells; ++j)
    for (Eigen::Index i = 0; i < cells; ++i)
      for (int corner = 0; corner < 4; ++corner) {
        const Eigen::Index di = corner % 2, dj = corner / 2;
        const Eigen::Index here = i + di + n * (j + dj);
        const Eigen::Index beside = i + 1 - di + n * (j + dj);
        const Eigen::Index above = i + di + n * (j + 1 - dj);
        const double turn = (di == dj ? 1 : -1) * (outline > 0 ? 1 : -1);
        const Eigen::Vector3d x = points.col(beside) - points.col(here),
                              y = points.col(above) - points.col(here);
        const double lengths = x.norm() * y.norm();
        const double sine = lengths > 0 ? x.cross(y).norm() / lengths : 0.0;
        const bool folded =
            !(turn * doubled_area(domain.col(here), domain.col(beside), domain.col(above)) > 0);
        smallest = std::min(smallest, folded ? -sine : sine);
      }
  return smallest;
}

}  // namespace isopatch::segmentation
