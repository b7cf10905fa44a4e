#include "iga/assembly/internal/grid_interface.hpp"

#include <Eigen/Geometry>

#include "geometry/splines/grid.hpp"
#include "iga/assembly/internal/grid_integrals.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// A line's functions at the points of a grid.
struct AtPoints {
  LineTable values, slopes;
};

AtPoints at_points(const geometry::KnotVector& knots, const std::vector<double>& parameters) {
  return {geometry::collocation(knots, parameters), geometry::collocation(knots, parameters, 1)};
}

// The traction's side at a point: gradients of the parameters along it and across, outward normal, area.
struct PlaceOnSide {
  std::array<Vector3d, 3> gradients;
  Vector3d normal;
  double area = 0;
};

PlaceOnSide place_on_side(const Sheet& sheet, Index point, bool is_high) {
  const Vector3d u = sheet.along[0].col(point), v = sheet.along[1].col(point), w = sheet.across.col(point);
  const Vector3d across = u.cross(v);
  const double inverse = 1 / across.dot(w);
  PlaceOnSide at{{v.cross(w) * inverse, w.cross(u) * inverse, across * inverse}, {}, across.norm()};
  at.normal = (is_high ? 1 : -1) * at.gradients[2].normalized();
  return at;
}

// How vectors s, and the products s n^T with the normal, become fields: on a plane n is one for all points
// and s is enough.
class NormalFields {
 public:
  explicit NormalFields(const std::vector<PlaceOnSide>& places) : normal_(places.front().normal) {
    for (const PlaceOnSide& at : places) is_plane_ = is_plane_ && (at.normal - normal_).norm() <= 1e-13;
  }
  Index of_products() const { return is_plane_ ? 3 : 9; }
  Index of_squares() const { return is_plane_ ? 1 : 6; }

  // s n^T into fields from `first` on.
  void set_product(GridFields& fields, Index first, Index i, Index j, const Vector3d& s,
                   const Vector3d& n) const {
    for (Index d = 0; d < 3; ++d) {
      if (is_plane_) fields.at(first + d, i, j) = s[d];
      for (Index e = 0; !is_plane_ && e < 3; ++e) fields.at(first + d + 3 * e, i, j) = s[d] * n[e];
    }
  }
  // scale n n^T.
  void set_square(GridFields& fields, Index first, Index i, Index j, double scale, const Vector3d& n) const {
    if (is_plane_) {
      fields.at(first, i, j) = scale;
      return;
    }
    for (Index e = 0, k = 0; e < 3; ++e)
      for (Index d = 0; d <= e; ++d) fields.at(first + k++, i, j) = scale * n[d] * n[e];
  }
  // The integrals back again, by the number of the field.
  template <class Value>
  Matrix3d product(Value value) const {
    Matrix3d result;
    if (is_plane_) return Vector3d(value(0), value(1), value(2)) * normal_.transpose();
    for (Index k = 0; k < 9; ++k) result(k) = value(k);
    return result;
  }
  template <class Value>
  Matrix3d square(Value value) const {
    if (is_plane_) return value(0) * normal_ * normal_.transpose();
    Matrix3d result;
    for (Index e = 0, k = 0; e < 3; ++e)
      for (Index d = 0; d <= e; ++d) result(d, e) = result(e, d) = value(k++);
    return result;
  }

 private:
  bool is_plane_ = true;
  Vector3d normal_;
};

// The traction's side with the other one.
class GridInterface {
 public:
  GridInterface(const SideFunctions& own, const SideFunctions& other, const geometry::SharedGrid& grid,
                const Eigen::MatrixXd& penalties, const Material& material)
      : own_(own), other_(other), grid_(grid), penalties_(penalties), material_(material) {
    const auto& [u, v] = grid.lines;
    const std::array<std::vector<double>, 2> parameters = {u.first, v.first};
    const auto across = static_cast<std::size_t>(geometry::direction(own.side()));
    const geometry::KnotVector& through = own.space().knots[across];
    const bool is_high = geometry::is_high(own.side());
    const Sheet at =
        sheet(*own.space().geometry, own.side(), is_high ? through.last() : through.first(), parameters);
    for (Index q = 0; q < at.across.cols(); ++q) places_.push_back(place_on_side(at, q, is_high));
    if (own.space().is_rational()) own_weights_ = weight_sums(own, parameters, true);
    std::array<std::vector<double>, 2> of_other;
    for (int d = 0; d < 2; ++d) {
      const auto k = static_cast<std::size_t>(d);
      of_other[static_cast<std::size_t>(grid.second_direction(d))] = grid.lines[k].second;
      own_at_[k] = at_points(own.knots(d), grid.lines[k].first);
      other_at_[k] = at_points(other.knots(grid.second_direction(d)), grid.lines[k].second);
    }
    if (other.space().is_rational()) other_weights_ = weight_sums(other, of_other, false);
  }

  NodeBlocks blocks() {
    const NormalFields normals(places_);
    NodeBlocks result;
    add_own(normals, result);
    add_between(normals, result);
    add_others(normals, result);
    return result;
  }

 private:
  Index points(std::size_t d) const { return static_cast<Index>(grid_.lines[d].size()); }

  // 1 / W of the other side at a point.
  double other_inverse(Index i, Index j) const {
    if (other_weights_.size() == 0) return 1;
    return 1 / other_weights_(0, grid_.swapped ? j + points(1) * i : i + points(0) * j);
  }

  // Integrals with the gradient of a function of the traction's side and the value of another function.
  struct Tractions {
    std::array<Rows, 2> slopes;  // with the derivative along direction 0, 1 in place of the value
    Rows values;                 // for layer 0, layer 1, and the penalty
  };

  // @param jump_scale  of the point (i, j): what the other function's value is multiplied by
  template <class Scale>
  Tractions integrals(const NormalFields& normals, const std::array<FunctionPairs, 2>& pairs,
                      const std::array<AtPoints, 2>& jumps, Scale jump_scale) const {
    const Index p = normals.of_products();
    std::array<GridFields, 2> along = {GridFields(points(0), points(1), p),
                                       GridFields(points(0), points(1), p)};
    GridFields values(points(0), points(1), 2 * p + normals.of_squares());
    for (Index j = 0; j < points(1); ++j)
      for (Index i = 0; i < points(0); ++i) {
        const Index q = i + points(0) * j;
        const PlaceOnSide& at = places_[static_cast<std::size_t>(q)];
        const double inverse = own_weights_.size() == 0 ? 1 : 1 / own_weights_(0, q);
        const double scale = at.area * weight(i, j) * inverse * jump_scale(i, j);
        const auto& g = at.gradients;
        normals.set_product(along[0], 0, i, j, scale * g[0], at.normal);
        normals.set_product(along[1], 0, i, j, scale * g[1], at.normal);
        Vector3d of_value = own_.slope()[0] * g[2];
        if (own_weights_.size() > 0)
          of_value -=
              inverse * (own_weights_(1, q) * g[0] + own_weights_(2, q) * g[1] + own_weights_(3, q) * g[2]);
        normals.set_product(values, 0, i, j, scale * of_value, at.normal);
        normals.set_product(values, p, i, j, scale * own_.slope()[1] * g[2], at.normal);
        normals.set_square(values, 2 * p, i, j, scale * penalty(i, j), at.normal);
      }
    std::array<LineTable, 2> plain, sloped;
    for (std::size_t d = 0; d < 2; ++d) {
      plain[d] = pairs[d].products(own_at_[d].values, jumps[d].values);
      sloped[d] = pairs[d].products(own_at_[d].slopes, jumps[d].values);
    }
    return {{grid_integrals(sloped[0], plain[1], along[0]), grid_integrals(plain[0], sloped[1], along[1])},
            grid_integrals(plain[0], plain[1], values)};
  }

  double weight(Index i, Index j) const {
    return grid_.lines[0].weights[static_cast<std::size_t>(i)] *
           grid_.lines[1].weights[static_cast<std::size_t>(j)];
  }
  double penalty(Index i, Index j) const {
    return penalties_(grid_.lines[0].first_element[static_cast<std::size_t>(i)],
                      grid_.lines[1].first_element[static_cast<std::size_t>(j)]);
  }

  // The transposed traction on n of a function's displacements: a row for each of its components.
  Matrix3d traction(const Matrix3d& gradient_normal) const {
    return material_.lambda * gradient_normal +
           material_.mu * (gradient_normal.trace() * Matrix3d::Identity() + gradient_normal.transpose());
  }
  Matrix3d penalty_block(const Matrix3d& squares) const {
    return material_.mu * squares.trace() * Matrix3d::Identity() +
           (material_.lambda + material_.mu) * squares;
  }

  // The blocks of pairs of functions, the first of the traction's side.
  class PairBlocks {
   public:
    PairBlocks(const GridInterface& of, const NormalFields& normals, const Tractions& all, Index pairs_0)
        : of_(of), normals_(normals), all_(all), pairs_0_(pairs_0) {}

    // With the first function of layer 0, of layer 1 behind it, and of the penalty.
    Matrix3d traction(Index pair_0, Index pair_1) const {
      return of_.traction(normals_.product([&](Index field) {
        return at(all_.slopes[0], field, pair_0, pair_1) + at(all_.slopes[1], field, pair_0, pair_1) +
               at(all_.values, field, pair_0, pair_1);
      }));
    }
    Matrix3d traction_behind(Index pair_0, Index pair_1) const {
      return of_.traction(normals_.product(
          [&](Index field) { return at(all_.values, normals_.of_products() + field, pair_0, pair_1); }));
    }
    Matrix3d penalty(Index pair_0, Index pair_1) const {
      return of_.penalty_block(normals_.square(
          [&](Index field) { return at(all_.values, 2 * normals_.of_products() + field, pair_0, pair_1); }));
    }

   private:
    double at(const Rows& sums, Index field, Index pair_0, Index pair_1) const {
      return sums(pair_1, field * pairs_0_ + pair_0);
    }
    const GridInterface& of_;
    const NormalFields& normals_;
    const Tractions& all_;
    Index pairs_0_;
  };

  void add_own(const NormalFields& normals, NodeBlocks& result) const {
    const std::array<FunctionPairs, 2> pairs = {FunctionPairs(own_at_[0].values, own_at_[0].values),
                                                FunctionPairs(own_at_[1].values, own_at_[1].values)};
    const Tractions all = integrals(normals, pairs, own_at_, [&](Index i, Index j) {
      return own_weights_.size() == 0 ? 1 : 1 / own_weights_(0, i + points(0) * j);
    });
    const PairBlocks blocks(*this, normals, all, static_cast<Index>(pairs[0].size()));
    result.reserve(2 * pairs[0].size() * pairs[1].size());
    for (std::size_t q = 0; q < pairs[1].size(); ++q)
      for (std::size_t p = 0; p < pairs[0].size(); ++p) {
        const auto [i, k] = pairs[0][p];
        const auto [j, l] = pairs[1][q];
        const auto of_0 = static_cast<Index>(p), of_1 = static_cast<Index>(q);
        const int a = own_.node(i, j, 0), b = own_.node(k, l, 0);
        const double of_b = own_.weight(k, l, 0), both = own_.weight(i, j, 0) * of_b;
        if (a <= b) {
          const Matrix3d tractions = blocks.traction(of_0, of_1) +
                                     blocks.traction(pairs[0].find(k, i), pairs[1].find(l, j)).transpose();
          result.add(a, b, both * (blocks.penalty(of_0, of_1) - tractions));
        }
        result.add(own_.node(i, j, 1), b, -own_.weight(i, j, 1) * of_b * blocks.traction_behind(of_0, of_1));
      }
  }

  void add_between(const NormalFields& normals, NodeBlocks& result) const {
    const std::array<FunctionPairs, 2> pairs = {FunctionPairs(own_at_[0].values, other_at_[0].values),
                                                FunctionPairs(own_at_[1].values, other_at_[1].values)};
    const Tractions all =
        integrals(normals, pairs, other_at_, [&](Index i, Index j) { return other_inverse(i, j); });
    const PairBlocks blocks(*this, normals, all, static_cast<Index>(pairs[0].size()));
    result.reserve(2 * pairs[0].size() * pairs[1].size());
    const auto add = [&](int first, int second, const Matrix3d& value) {
      // A patch that meets itself may have one node on both sides.
      if (first == second)
        result.add(first, second, value + value.transpose());
      else
        result.add(first, second, value);
    };
    for (std::size_t q = 0; q < pairs[1].size(); ++q)
      for (std::size_t p = 0; p < pairs[0].size(); ++p) {
        const auto [i, k] = pairs[0][p];
        const auto [j, l] = pairs[1][q];
        const int b = other_node(k, l);
        const double of_b = other_weight(k, l), both = own_.weight(i, j, 0) * of_b;
        const auto of_0 = static_cast<Index>(p), of_1 = static_cast<Index>(q);
        add(own_.node(i, j, 0), b, both * (blocks.traction(of_0, of_1) - blocks.penalty(of_0, of_1)));
        add(own_.node(i, j, 1), b, own_.weight(i, j, 1) * of_b * blocks.traction_behind(of_0, of_1));
      }
  }

  void add_others(const NormalFields& normals, NodeBlocks& result) const {
    GridFields fields(points(0), points(1), normals.of_squares());
    for (Index j = 0; j < points(1); ++j)
      for (Index i = 0; i < points(0); ++i) {
        const PlaceOnSide& at = places_[static_cast<std::size_t>(i + points(0) * j)];
        const double inverse = other_inverse(i, j);
        normals.set_square(fields, 0, i, j, at.area * weight(i, j) * penalty(i, j) * inverse * inverse,
                           at.normal);
      }
    const std::array<FunctionPairs, 2> pairs = {FunctionPairs(other_at_[0].values, other_at_[0].values),
                                                FunctionPairs(other_at_[1].values, other_at_[1].values)};
    const Rows sums = grid_integrals(pairs[0].products(other_at_[0].values, other_at_[0].values),
                                     pairs[1].products(other_at_[1].values, other_at_[1].values), fields);
    const auto count = static_cast<Index>(pairs[0].size());
    for (std::size_t q = 0; q < pairs[1].size(); ++q)
      for (std::size_t p = 0; p < pairs[0].size(); ++p) {
        const auto [i, k] = pairs[0][p];
        const auto [j, l] = pairs[1][q];
        const int a = other_node(i, j), b = other_node(k, l);
        if (a > b) continue;
        const Matrix3d squares = normals.square(
            [&](Index field) { return sums(static_cast<Index>(q), field * count + static_cast<Index>(p)); });
        result.add(a, b, other_weight(i, j) * other_weight(k, l) * penalty_block(squares));
      }
  }

  // Of functions numbered along the directions of the traction's side.
  int other_node(int i, int j) const { return grid_.swapped ? other_.node(j, i, 0) : other_.node(i, j, 0); }
  double other_weight(int i, int j) const {
    return grid_.swapped ? other_.weight(j, i, 0) : other_.weight(i, j, 0);
  }

  const SideFunctions& own_;
  const SideFunctions& other_;
  const geometry::SharedGrid& grid_;
  const Eigen::MatrixXd& penalties_;
  const Material& material_;
  std::vector<PlaceOnSide> places_;
  Eigen::MatrixXd own_weights_;    // W and its derivatives; empty: 1
  Eigen::MatrixXd other_weights_;  // W
  std::array<AtPoints, 2> own_at_, other_at_;
};

}  // namespace

NodeBlocks grid_stiffness(const SideFunctions& own, const SideFunctions& other,
                          const geometry::SharedGrid& grid, const Eigen::MatrixXd& penalties,
                          const Material& material) {
  return GridInterface(own, other, grid, penalties, material).blocks();
}

}  // namespace isopatch::iga
