#include "iga/spaces/quadrature_geometry.hpp"

#include <algorithm>

#include "geometry/splines/basis.hpp"
#include "iga/internal/native_lanes.hpp"
#include "iga/spaces/internal/folded_patch.hpp"

namespace isopatch::iga {
namespace {

using Lane = Eigen::Array<double, native_lane_count, 1>;
using Lanes = Eigen::Array<double, 8, 1>;

Eigen::Map<const Lane, Eigen::Unaligned> at(const double* from) {
  return Eigen::Map<const Lane, Eigen::Unaligned>(from);
}

// Sum over the functions of direction 3 of factor times line.
inline Lane along_third(const double* line, std::ptrdiff_t plane_step, const double* factors, int count) {
  Lane sum = factors[0] * at(line);
  for (int k = 1; k < count; ++k) sum += factors[k] * at(line + k * plane_step);
  return sum;
}

using Derived = std::array<Lane, 4>;  // value and three derivatives

// Of one component of a spline, from V V, D V, V D of directions 1 and 2: a third of the fields each.
inline Derived derived(const double* from, std::ptrdiff_t width, int fields, const double* values,
                       const double* derivatives, int functions) {
  const std::ptrdiff_t step = fields * width;
  const std::ptrdiff_t kind = step / 3;
  return {along_third(from, step, values, functions), along_third(from + kind, step, values, functions),
          along_third(from + 2 * kind, step, values, functions),
          along_third(from, step, derivatives, functions)};
}

// With 1 as the value at those places of the last block where there is no point.
inline Derived filled(Derived spline, int used) {
  for (int lane = used; lane < native_lane_count; ++lane) spline[0][lane] = 1;
  return spline;
}

inline void divide(std::array<Derived, 3>& x, const Derived& total) {
  const Lane inverse = 1 / total[0];
  for (Derived& coordinate : x) {
    coordinate[0] *= inverse;
    for (std::size_t d = 1; d < 4; ++d) coordinate[d] = inverse * (coordinate[d] - coordinate[0] * total[d]);
  }
}

struct PointMap {
  std::array<Lane, 9> cofactors;  // det J times J^-1, [parameter][coordinate]
  Lane determinant;
};

inline PointMap map_at(const std::array<Derived, 3>& x, int used) {
  PointMap map;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t c1 = (c + 1) % 3, c2 = (c + 2) % 3, d1 = (d + 1) % 3 + 1, d2 = (d + 2) % 3 + 1;
      map.cofactors[3 * d + c] = x[c1][d1] * x[c2][d2] - x[c1][d2] * x[c2][d1];
    }
  map.determinant = x[0][1] * map.cofactors[0] + x[1][1] * map.cofactors[1] + x[2][1] * map.cofactors[2];
  for (int lane = used; lane < native_lane_count; ++lane) map.determinant[lane] = 1;
  return map;
}

inline void write_scaled(const PointMap& map, const Lane& scale, double* to) {
  for (int k = 0; k < 9; ++k)
    Eigen::Map<Lane, Eigen::Unaligned>(to + k * native_lane_count) =
        scale * map.cofactors[static_cast<std::size_t>(k)];
}

inline void write_rational(const PointMap& map, const Lane& weight, const Derived& total, double* to) {
  const Lane inverse = 1 / total[0];
  const Lane scale = inverse * (weight / map.determinant).sqrt();
  write_scaled(map, scale, to);
  const std::array<Lane, 9>& g = map.cofactors;
  for (std::size_t c = 0; c < 3; ++c)
    Eigen::Map<Lane, Eigen::Unaligned>(to + (9 + static_cast<int>(c)) * native_lane_count) =
        -scale * inverse * (g[c] * total[1] + g[3 + c] * total[2] + g[6 + c] * total[3]);
}

}  // namespace

const int QuadratureGeometry::block_size = native_lane_count;

QuadratureGeometry::QuadratureGeometry(const PatchSpace& space, int points) : space_(&space) {
  for (int d = 0; d < 3; ++d) {
    const auto k = static_cast<std::size_t>(d);
    tables_[k] = direction_table(space.knots[k], geometry::gauss_legendre(space.points_along(d, points)));
    for (const DirectionTable::Element& element : tables_[k].elements) {
      nodes_[k].insert(nodes_[k].end(), element.nodes.begin(), element.nodes.end());
      weights_[k].insert(weights_[k].end(), element.weights.begin(), element.weights.end());
    }
    geometry_at_[k] = tabulate(space.geometry->knots()[k], d);
    if (space.is_rational()) functions_at_[k] = tabulate_own(d);
  }
  homogeneous_ = space.geometry->homogeneous();
  if (space.is_rational()) {
    function_weights_.setZero(4, space.weights.size());
    function_weights_.row(0) = space.weights.transpose();
  }
}

int QuadratureGeometry::points_per_element(int d) const {
  return static_cast<int>(table(d).elements.front().nodes.size());
}

int QuadratureGeometry::points(int d) const {
  return static_cast<int>(nodes_[static_cast<std::size_t>(d)].size());
}

// The span of the geometry at a point of an element of the functions never lies outside that element, even
// where rounding puts the point on the element's end.
QuadratureGeometry::AtPoints QuadratureGeometry::tabulate(const geometry::KnotVector& knots, int d) const {
  const std::vector<double> breaks = space_->knots[static_cast<std::size_t>(d)].breaks();
  const std::vector<double> own_breaks = knots.breaks();
  AtPoints result;
  result.functions = knots.degree() + 1;
  const DirectionTable& table = tables_[static_cast<std::size_t>(d)];
  for (std::size_t e = 0; e < table.elements.size(); ++e) {
    const auto above = std::lower_bound(own_breaks.begin(), own_breaks.end(), breaks[e + 1]);
    const double last_break = std::max(breaks[e], above == own_breaks.begin() ? breaks[e] : *(above - 1));
    const int low = knots.span(breaks[e]);
    const int high = std::max(low, knots.span(0.5 * (last_break + breaks[e + 1])));
    for (const double node : table.elements[e].nodes) {
      const int span = std::clamp(knots.span(node), low, high);
      const Eigen::MatrixXd rows = geometry::basis_on_span(knots, span, node, 1);
      result.first.push_back(span - knots.degree());
      for (Eigen::Index k = 0; k < rows.cols(); ++k) {
        result.values.push_back(rows(0, k));
        result.derivatives.push_back(rows(1, k));
      }
    }
  }
  return result;
}

QuadratureGeometry::AtPoints QuadratureGeometry::tabulate_own(int d) const {
  AtPoints result;
  result.functions = space_->knots[static_cast<std::size_t>(d)].degree() + 1;
  for (const DirectionTable::Element& element : table(d).elements) {
    for (Eigen::Index q = 0; q < element.values.rows(); ++q) {
      result.first.push_back(element.first);
      for (Eigen::Index k = 0; k < element.values.cols(); ++k) {
        result.values.push_back(element.values(q, k));
        result.derivatives.push_back(element.derivatives(q, k));
      }
    }
  }
  return result;
}

// Directions 2 and 1 of a spline with up to four components, for the planes that the points begin .. end - 1
// of direction 3 need.
QuadratureGeometry::Lines QuadratureGeometry::lines(const Eigen::Matrix4Xd& coefficients,
                                                    const std::array<AtPoints, 3>& at_points,
                                                    const std::array<int, 2>& sizes, int components, int j,
                                                    int begin, int end) const {
  const auto& [u, v, w] = at_points;
  Lines result;
  result.first_plane = w.first[static_cast<std::size_t>(begin)];
  result.fields = 3 * components;
  const int planes = w.first[static_cast<std::size_t>(end - 1)] + w.functions - result.first_plane;
  const int width = blocks() * block_size;
  result.values.assign(static_cast<std::size_t>(planes) * static_cast<std::size_t>(result.fields * width),
                       0.0);
  std::vector<Lanes> line(static_cast<std::size_t>(sizes[0]));  // values, then derivatives along direction 2
  const double* const value2 = &v.values[static_cast<std::size_t>(j * v.functions)];
  const double* const derivative2 = &v.derivatives[static_cast<std::size_t>(j * v.functions)];
  for (int plane = 0; plane < planes; ++plane) {
    const Eigen::Index row = static_cast<Eigen::Index>(sizes[1]) * (result.first_plane + plane) +
                             v.first[static_cast<std::size_t>(j)];
    for (int i = 0; i < sizes[0]; ++i) {
      Lanes& here = line[static_cast<std::size_t>(i)];
      here.setZero();
      for (int k = 0; k < v.functions; ++k) {
        const auto c = coefficients.col(sizes[0] * (row + k) + i).array();
        here.head<4>() += value2[k] * c;
        here.tail<4>() += derivative2[k] * c;
      }
    }
    double* out =
        &result.values[static_cast<std::size_t>(plane) * static_cast<std::size_t>(result.fields * width)];
    for (int q = 0; q < points(0); ++q, ++out) {
      const auto point = static_cast<std::size_t>(q);
      const double* const value1 = &u.values[point * static_cast<std::size_t>(u.functions)];
      const double* const derivative1 = &u.derivatives[point * static_cast<std::size_t>(u.functions)];
      const Lanes* const from = &line[static_cast<std::size_t>(u.first[point])];
      Lanes plain = value1[0] * from[0];
      Eigen::Array4d along = derivative1[0] * from[0].head<4>();
      for (int k = 1; k < u.functions; ++k) {
        plain += value1[k] * from[k];
        along += derivative1[k] * from[k].head<4>();
      }
      for (int c = 0; c < components; ++c) {
        out[c * width] = plain[c];
        out[(components + c) * width] = along[c];
        out[(2 * components + c) * width] = plain[4 + c];
      }
    }
  }
  return result;
}

void QuadratureGeometry::evaluate(int j, int begin, int end, double* out, int stride, int patch) const {
  const geometry::NurbsVolume& volume = *space_->geometry;
  const bool rational = space_->is_rational();
  const Lines places = lines(homogeneous_, geometry_at_, {volume.size(0), volume.size(1)},
                             volume.is_rational() ? 4 : 3, j, begin, end);
  Lines weights;
  if (rational)
    weights = lines(function_weights_, functions_at_, {space_->knots[0].size(), space_->knots[1].size()}, 1,
                    j, begin, end);
  bool folded = false;
  for (int block = 0; block < blocks(); ++block) {
    const int used = std::min(block_size, points(0) - block * block_size);
    Lane weight1 = Lane::Zero();
    for (int lane = 0; lane < used; ++lane)
      weight1[lane] = weights_[0][static_cast<std::size_t>(block * block_size + lane)];
    double* to = out + static_cast<std::ptrdiff_t>(block) * stride * components() * block_size;
    for (int q = begin; q < end; ++q, to += components() * block_size) {
      const auto k = static_cast<std::size_t>(q);
      const Lane weight = weight1 * (weights_[1][static_cast<std::size_t>(j)] * weights_[2][k]);
      const auto derive = [&](const Lines& spline, const AtPoints& w, int component) {
        const double* const from = spline.values.data() +
                                   static_cast<std::ptrdiff_t>(w.first[k] - spline.first_plane) *
                                       spline.fields * blocks() * block_size +
                                   (component * blocks() + block) * block_size;
        const auto at_point = k * static_cast<std::size_t>(w.functions);
        return derived(from, blocks() * block_size, spline.fields, &w.values[at_point],
                       &w.derivatives[at_point], w.functions);
      };
      std::array<Derived, 3> x;
      for (int c = 0; c < 3; ++c) x[static_cast<std::size_t>(c)] = derive(places, geometry_at_[2], c);
      if (volume.is_rational()) divide(x, filled(derive(places, geometry_at_[2], 3), used));
      const PointMap map = map_at(x, used);
      folded = folded || !(map.determinant > 0).all();
      if (rational)
        write_rational(map, weight, filled(derive(weights, functions_at_[2], 0), used), to);
      else
        write_scaled(map, (weight / map.determinant).sqrt(), to);
    }
  }
  if (folded) refuse_fold(j, begin, end, patch);
}

void QuadratureGeometry::refuse_fold(int j, int begin, int end, int patch) const {
  const auto at_w = nodes_[2].begin();
  const std::array<std::vector<double>, 3> grid = {
      nodes_[0], std::vector<double>(1, nodes_[1][static_cast<std::size_t>(j)]),
      std::vector<double>(at_w + begin, at_w + end)};
  refuse_folded(patch, *space_->geometry, space_->reversed, grid);
}

}  // namespace isopatch::iga
