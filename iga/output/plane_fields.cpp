#include "iga/output/plane_fields.hpp"

#include <omp.h>

#include <Eigen/LU>
#include <cmath>

#include "geometry/scaled_jacobian.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/material/internal/point_fields.hpp"
#include "iga/output/internal/grid_sums.hpp"
#include "iga/post/stress_measures.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using geometry::NurbsVolume;
using geometry::Parameter;

// Below this share of the middle's scaled Jacobian a map counts as folded: a gradient is divided by it.
constexpr double least_share = 0.01;
// A column this much shorter than the longest one has no direction: an edge that is one point.
constexpr double no_length = 1e-9;

struct Shape {
  double scaled = 0;
  bool collapsed = false;
};

Shape shape_of(const Matrix3d& jacobian) {
  const Vector3d lengths = jacobian.colwise().norm();
  if (lengths.minCoeff() <= no_length * lengths.maxCoeff()) return {0, true};
  return {geometry::scaled_jacobian(jacobian), false};
}

// Numerators to the value and its derivatives along the parameters.
struct Quotient {
  Vector3d value;
  Matrix3d derivatives;
};

Quotient quotient(const GridSums::Point& p, int first) {
  const double inverse = 1 / p.value[3];
  Quotient result;
  result.value = inverse * p.value.segment<3>(first).matrix();
  int column = 0;
  for (const FieldLanes<8>* d : {&p.d1, &p.d2, &p.d3})
    result.derivatives.col(column++) = inverse * (d->segment<3>(first).matrix() - (*d)[3] * result.value);
  return result;
}

Eigen::Matrix<double, 6, 1> six(const Matrix3d& t) {
  return (Eigen::Matrix<double, 6, 1>() << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)).finished();
}

// What the combinations of one node add up to.
struct NodeSums {
  Vector3d place = Vector3d::Zero();
  Vector3d displacement = Vector3d::Zero();
  Matrix3d gradient = Matrix3d::Zero();
  double scaled = 2;
  double weight = 0;
  int count = 0;
  int usable = 0;
  bool collapsed = false;
};

}  // namespace

bool is_usable(double scaled_jacobian, double typical) {
  return scaled_jacobian > least_share * typical;
}

void BorrowedStress::add(const BorrowedStress& other) {
  count += other.count;
  of += other.of;
  if (other.count == 0 || (patch >= 0 && other.scaled_jacobian >= scaled_jacobian)) return;
  patch = other.patch;
  place = other.place;
  scaled_jacobian = other.scaled_jacobian;
}

struct PlaneFields::State {
  State(const ElasticField& all, int index, const geometry::GridParameters<3>& parameters)
      : field(all),
        patch(index),
        volume(all.patches[static_cast<std::size_t>(index)]),
        material(all.materials[static_cast<std::size_t>(index)]),
        thermal(all.thermal_strain(static_cast<std::size_t>(index))),
        sums(volume, all.displacement[static_cast<std::size_t>(index)],
             {grid_line(volume.knots(0), parameters[0]), grid_line(volume.knots(1), parameters[1]),
              grid_line(volume.knots(2), parameters[2])}),
        typical(std::abs(shape_of(volume.jacobian(0.5 * (volume.low() + volume.high()))).scaled)),
        rows(static_cast<std::size_t>(omp_get_max_threads())) {}

  void resize(Eigen::Index count) {
    out.points.resize(3, count);
    out.displacement.resize(3, count);
    out.strain.resize(6, count);
    out.stress.resize(6, count);
    out.principal.resize(3, count);
    for (auto* row : {&out.von_mises, &out.tresca, &out.scaled_jacobian, &out.weights}) row->resize(count);
  }

  void add(const GridSums::Point& point, NodeSums& node) const {
    const Quotient place = quotient(point, 0);
    const Quotient displacement = quotient(point, 4);
    const Shape shape = shape_of(place.derivatives);
    node.place += place.value;
    node.displacement += displacement.value;
    node.weight += point.value[3];
    node.scaled = std::min(node.scaled, shape.scaled);
    node.collapsed = node.collapsed || shape.collapsed;
    ++node.count;
    if (!is_usable(shape.scaled, typical)) return;
    node.gradient += displacement.derivatives * place.derivatives.inverse();
    ++node.usable;
  }

  // Strain at the first good point on the way to the middle; of the point itself if there is none.
  Matrix3d strain_inside(const Parameter<3>& parameter) const {
    const Parameter<3> middle = 0.5 * (volume.low() + volume.high());
    for (double share = 1e-3; share < 1; share *= 2) {
      const Parameter<3> inside = parameter + share * (middle - parameter);
      if (is_usable(shape_of(volume.jacobian(inside)).scaled, typical))
        return evaluate(field, patch, inside).strain;
    }
    return evaluate(field, patch, middle).strain;
  }

  void finish(const NodeSums& node, const Parameter<3>& parameter, Eigen::Index at) {
    const double share = 1.0 / node.count;
    out.points.col(at) = share * node.place;
    out.displacement.col(at) = share * node.displacement;
    out.weights[at] = share * node.weight;
    out.scaled_jacobian[at] = node.scaled;
    const Matrix3d gradient = node.gradient / std::max(1, node.usable);
    const Matrix3d strain =
        node.usable > 0 ? Matrix3d(0.5 * (gradient + gradient.transpose())) : strain_inside(parameter);
    const Matrix3d stress = stress_of_gradient(strain, material, thermal.at(out.points.col(at)));
    out.strain.col(at) = six(strain);
    out.stress.col(at) = six(stress);
    out.von_mises[at] = von_mises(stress);
    out.principal.col(at) = principal_values(stress);
    out.tresca[at] = out.principal(0, at) - out.principal(2, at);
    out.is_borrowed[static_cast<std::size_t>(at)] = node.usable == 0 && !node.collapsed ? 1 : 0;
  }

  void row(int j, int k, GridSums::Row& buffer, std::vector<NodeSums>& nodes) {
    const auto& [first, second, third] = std::tie(sums.line(0), sums.line(1), sums.line(2));
    const auto n = static_cast<std::size_t>(first.size());
    nodes.assign(n, {});
    const auto begin = [](const GridLine& line, int node) {
      return line.begin[static_cast<std::size_t>(node)];
    };
    for (int c = 0; c < begin(third, k + 1) - begin(third, k); ++c)
      for (int b = begin(second, j); b < begin(second, j + 1); ++b) {
        sums.row(b, planes[static_cast<std::size_t>(c)], buffer);
        for (int i = 0; i < first.size(); ++i)
          for (int a = begin(first, i); a < begin(first, i + 1); ++a)
            add(sums.point(a, buffer), nodes[static_cast<std::size_t>(i)]);
      }
    for (std::size_t i = 0; i < n; ++i)
      finish(nodes[i],
             {first.nodes[i], second.nodes[static_cast<std::size_t>(j)],
              third.nodes[static_cast<std::size_t>(k)]},
             static_cast<Eigen::Index>(i) + static_cast<Eigen::Index>(n) * j);
  }

  void sum_up_borrowed() {
    out.borrowed = {};
    for (std::size_t i = 0; i < out.is_borrowed.size(); ++i) {
      BorrowedStress point{out.is_borrowed[i] ? 1 : 0, 1, patch, out.points.col(static_cast<Eigen::Index>(i)),
                           out.scaled_jacobian[static_cast<Eigen::Index>(i)]};
      out.borrowed.add(point);
    }
  }

  struct Scratch {
    GridSums::Row row;
    std::vector<NodeSums> nodes;
  };

  const ElasticField& field;
  int patch;
  const NurbsVolume& volume;
  const Material& material;
  ThermalStrain thermal;
  GridSums sums;
  double typical;
  std::vector<Scratch> rows;
  std::array<GridSums::Plane, 2> planes;
  FieldPlane out;
};

PlaneFields::PlaneFields(const ElasticField& field, int patch, const geometry::GridParameters<3>& parameters)
    : state_(std::make_unique<State>(field, patch, parameters)) {}
PlaneFields::~PlaneFields() = default;
PlaneFields::PlaneFields(PlaneFields&&) noexcept = default;

std::array<int, 3> PlaneFields::sizes() const {
  return state_->sums.sizes();
}

FieldPlane& PlaneFields::plane(int k) {
  State& s = *state_;
  const auto [m, n, o] = s.sums.sizes();
  s.resize(static_cast<Eigen::Index>(m) * n);
  s.out.is_borrowed.assign(static_cast<std::size_t>(m) * static_cast<std::size_t>(n), 0);
  const std::vector<int>& begin = s.sums.line(2).begin;
  const int first = begin[static_cast<std::size_t>(k)];
  for (int c = first; c < begin[static_cast<std::size_t>(k) + 1]; ++c)
    s.sums.plane(c, s.planes[static_cast<std::size_t>(c - first)]);
  parallel_for(n, [&](std::int64_t j, int thread) {
    State::Scratch& scratch = s.rows[static_cast<std::size_t>(thread)];
    s.row(static_cast<int>(j), k, scratch.row, scratch.nodes);
  });
  s.sum_up_borrowed();
  return s.out;
}

}  // namespace isopatch::iga
