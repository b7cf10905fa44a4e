#include "iga/output/interface_tractions.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/base/sparse_lu.hpp"
#include "geometry/quadrature.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsSurface;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// The coefficients of one direction that are free: begin .. end - 1 of all. The others follow from them.
struct FreeRange {
  int begin = 0;
  int end = 0;
  int size() const { return end - begin; }
};

/// The nodes of an interface's first face as a grid.
struct FaceGrid {
  std::vector<int> nodes;
  std::array<int, 2> sizes = {0, 0};

  int node(int i, int j) const { return nodes[static_cast<std::size_t>(i + sizes[0] * j)]; }
};

FaceGrid face_grid(const Discretization& d, const geometry::PatchFace& face) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  FaceGrid grid{geometry::face_control_points(d.patches[p].sizes(), face.side), {}};
  for (int& node : grid.nodes) node += d.first_node[p];
  for (int k = 0; k < 2; ++k)
    grid.sizes[static_cast<std::size_t>(k)] =
        d.patches[p].size(geometry::tangents(face.side)[static_cast<std::size_t>(k)]);
  return grid;
}

/// Per node: whether its multiplier is the force of one interface alone and of no support.
std::vector<bool> attributable_nodes(const ElasticityProblem& problem) {
  const GlobalNodes global = global_nodes(problem.discretization);
  const std::vector<SupportFrame> frames = support_frames(problem, global);
  std::vector<bool> result;
  for (const int c : global.global_of)
    result.push_back(global.nodes_of(c).size() == 2 && frames[static_cast<std::size_t>(c)].free == 3);
  return result;
}

/// Forces that multipliers exert, per node. (3, nodes), N
Eigen::Matrix3Xd nodal_forces(const std::vector<Multiplier>& multipliers, int nodes) {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, nodes);
  for (const Multiplier& multiplier : multipliers) {
    forces.col(multiplier.second_node) += multiplier.force;
    forces.col(multiplier.first_node) -= multiplier.force;
  }
  return forces;
}

/// The grid, less such edges as have nodes that are not attributable, and as few of them as possible. Empty
/// if other nodes are not either.
std::array<FreeRange, 2> free_ranges(const FaceGrid& grid, const std::vector<bool>& attributable) {
  const auto holds = [&](const std::array<FreeRange, 2>& range) {
    for (int j = range[1].begin; j < range[1].end; ++j)
      for (int i = range[0].begin; i < range[0].end; ++i)
        if (!attributable[static_cast<std::size_t>(grid.node(i, j))]) return false;
    return true;
  };
  std::array<FreeRange, 2> best;
  for (int edges = 0; edges < 16; ++edges) {
    const std::array<FreeRange, 2> range = {FreeRange{edges & 1, grid.sizes[0] - (edges >> 1 & 1)},
                                            FreeRange{edges >> 2 & 1, grid.sizes[1] - (edges >> 3 & 1)}};
    if (range[0].size() * range[1].size() > best[0].size() * best[1].size() && holds(range)) best = range;
  }
  return best;
}

/// Lagrange's polynomials of some abscissae at a place.
Eigen::VectorXd lagrange_values(const std::vector<double>& abscissae, double place) {
  Eigen::VectorXd values = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(abscissae.size()));
  for (std::size_t k = 0; k < abscissae.size(); ++k)
    for (std::size_t m = 0; m < abscissae.size(); ++m)
      if (m != k)
        values[static_cast<Eigen::Index>(k)] *= (place - abscissae[m]) / (abscissae[k] - abscissae[m]);
  return values;
}

/// All coefficients of one direction from the free ones; one that is left out continues the nearest three
/// (two at degree 1) as a polynomial over the Greville abscissae. (all, free)
Eigen::MatrixXd extension(const geometry::KnotVector& knots, const FreeRange& range) {
  const std::vector<double> greville = knots.greville();
  const int used = std::min(1 + std::min(knots.degree(), 2), range.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(knots.size(), range.size());
  result.middleRows(range.begin, range.size()).setIdentity();
  const auto continue_to = [&](int target, int first) {
    const std::vector<double> near(greville.begin() + first, greville.begin() + first + used);
    result.row(target).segment(first - range.begin, used) =
        lagrange_values(near, greville[static_cast<std::size_t>(target)]).transpose();
  };
  if (range.begin > 0) continue_to(0, range.begin);
  if (range.end < knots.size()) continue_to(knots.size() - 1, range.end - used);
  return result;
}

SparseMatrix extension(const NurbsSurface& surface, const std::array<FreeRange, 2>& range) {
  const Eigen::MatrixXd u = extension(surface.knots(0), range[0]);
  const Eigen::MatrixXd v = extension(surface.knots(1), range[1]);
  std::vector<Eigen::Triplet<double>> entries;
  const auto near = [](const Eigen::MatrixXd& e, Eigen::Index row, Eigen::Index column) {
    return e(row, column) != 0;
  };
  for (Eigen::Index l = 0; l < v.cols(); ++l)
    for (Eigen::Index j = 0; j < v.rows(); ++j)
      for (Eigen::Index k = 0; near(v, j, l) && k < u.cols(); ++k)
        for (Eigen::Index i = 0; i < u.rows(); ++i)
          if (near(u, i, k)) entries.emplace_back(i + u.rows() * j, k + u.cols() * l, u(i, k) * v(j, l));
  SparseMatrix result(u.rows() * v.rows(), u.cols() * v.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The values of a rational surface's functions at one point, times their knot tables' places.
struct PointValues {
  Eigen::VectorXd values;  // of the functions of one element, first direction fastest
  double measure = 0;      // quadrature weight times area
};

PointValues point_values(const NurbsSurface& surface, const DirectionTable::Element& u,
                         const DirectionTable::Element& v, Eigen::Index qu, Eigen::Index qv) {
  const auto tangents = surface.jacobian({u.nodes[qu], v.nodes[qv]});
  const double area = Eigen::Vector3d(tangents.col(0)).cross(Eigen::Vector3d(tangents.col(1))).norm();
  PointValues result{Eigen::VectorXd(u.values.cols() * v.values.cols()),
                     u.weights[qu] * v.weights[qv] * area};
  for (Eigen::Index j = 0; j < v.values.cols(); ++j)
    for (Eigen::Index i = 0; i < u.values.cols(); ++i)
      result.values[i + u.values.cols() * j] =
          u.values(qu, i) * v.values(qv, j) *
          surface.weights()[u.first + i + surface.size(0) * (v.first + j)];
  result.values /= result.values.sum();
  return result;
}

SparseMatrix mass_matrix(const NurbsSurface& surface) {
  std::array<DirectionTable, 2> tables;
  for (int d = 0; d < 2; ++d)
    tables[static_cast<std::size_t>(d)] =
        direction_table(surface.knots(d), geometry::gauss_legendre(surface.degree(d) + 2));
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& v : tables[1].elements) {
    for (const auto& u : tables[0].elements) {
      const Eigen::Index functions = u.values.cols() * v.values.cols();
      Eigen::MatrixXd local = Eigen::MatrixXd::Zero(functions, functions);
      for (Eigen::Index qv = 0; qv < v.nodes.size(); ++qv) {
        for (Eigen::Index qu = 0; qu < u.nodes.size(); ++qu) {
          const PointValues point = point_values(surface, u, v, qu, qv);
          local.noalias() += point.measure * point.values * point.values.transpose();
        }
      }
      const auto index = [&](Eigen::Index a) {
        return u.first + a % u.values.cols() + surface.size(0) * (v.first + a / u.values.cols());
      };
      for (Eigen::Index b = 0; b < functions; ++b)
        for (Eigen::Index a = 0; a < functions; ++a) entries.emplace_back(index(a), index(b), local(a, b));
    }
  }
  SparseMatrix result(surface.size(), surface.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Picks the free ones of all coefficients. (free, all)
SparseMatrix selection(const std::array<int, 2>& sizes, const std::array<FreeRange, 2>& range) {
  const int rows = range[0].size() * range[1].size();
  const int columns = sizes[0] * sizes[1];
  SparseMatrix result(rows, columns);
  int row = 0;
  for (int j = range[1].begin; j < range[1].end; ++j)
    for (int i = range[0].begin; i < range[0].end; ++i) result.insert(row++, i + sizes[0] * j) = 1;
  return result;
}

/// Coefficients of the traction on all functions of a face, from the forces on its nodes. (functions, 3), or
/// nothing if these do not determine it
std::optional<Eigen::MatrixXd> traction_coefficients(const NurbsSurface& surface, const SparseMatrix& mass,
                                                     const std::array<FreeRange, 2>& range,
                                                     const Eigen::MatrixXd& forces) {
  if (range[0].size() == 0) return std::nullopt;
  const SparseMatrix extended = extension(surface, range);
  const SparseMatrix tested = selection(surface.sizes(), range);
  const SparseMatrix system = tested * mass * extended;
  const std::optional<Eigen::MatrixXd> solution = solve_by_lu(system, tested * forces);
  if (!solution) return std::nullopt;
  return extended * *solution;
}

InterfaceTraction traction_of(const Discretization& d, int index, const std::vector<bool>& attributable,
                              const Eigen::Matrix3Xd& forces) {
  const geometry::PatchFace& face = d.model.interfaces()[static_cast<std::size_t>(index)].first;
  const NurbsSurface surface =
      geometry::face_surface(d.patches[static_cast<std::size_t>(face.patch.value)], face.side);
  const FaceGrid grid = face_grid(d, face);
  Eigen::MatrixXd on_face(surface.size(), 3);
  for (int i = 0; i < surface.size(); ++i)
    on_face.row(i) = forces.col(grid.nodes[static_cast<std::size_t>(i)]).transpose();
  const SparseMatrix mass = mass_matrix(surface);
  InterfaceTraction result{.interface = index, .field = {}, .area = mass.sum()};
  const auto coefficients = traction_coefficients(surface, mass, free_ranges(grid, attributable), on_face);
  if (!coefficients) return result;
  result.field = NurbsSurface(surface.knots(), coefficients->transpose(), surface.weights());
  result.force = (mass * *coefficients).colwise().sum();
  return result;
}

}  // namespace

std::vector<InterfaceTraction> interface_tractions(const ElasticityProblem& problem,
                                                   const std::vector<Multiplier>& multipliers) {
  const Discretization& d = problem.discretization;
  const std::vector<bool> attributable = attributable_nodes(problem);
  const Eigen::Matrix3Xd forces = nodal_forces(multipliers, d.node_count());
  std::vector<InterfaceTraction> result;
  result.reserve(d.model.interfaces().size());
  for (int i = 0; i < static_cast<int>(d.model.interfaces().size()); ++i)
    result.push_back(traction_of(d, i, attributable, forces));
  return result;
}

Eigen::Vector3d traction_at(const Discretization& d, const InterfaceTraction& traction,
                            const geometry::PatchFace& face, const geometry::Parameter<2>& parameter) {
  const geometry::Interface& interface = d.model.interfaces()[static_cast<std::size_t>(traction.interface)];
  const NurbsSurface& field = traction.field.value();
  if (face == interface.first) return field.point(parameter);
  const auto& patch = d.patches[static_cast<std::size_t>(face.patch.value)];
  geometry::Parameter<2> scaled;
  for (int k = 0; k < 2; ++k) {
    const auto& knots = patch.knots(geometry::tangents(face.side)[static_cast<std::size_t>(k)]);
    scaled[k] = (parameter[k] - knots.first()) / knots.length();
  }
  const geometry::Parameter<2> on_first = geometry::inverse(interface.orientation)(scaled);
  return field.point(field.low() + on_first.cwiseProduct(field.high() - field.low()));
}

}  // namespace isopatch::iga
