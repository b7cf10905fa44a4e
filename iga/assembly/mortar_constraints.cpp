#include "iga/assembly/mortar_constraints.hpp"

#include <algorithm>
#include <array>

#include "geometry/common_refinement.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/assembly/internal/grid_traces.hpp"
#include "iga/assembly/internal/patch_side.hpp"
#include "iga/assembly/internal/side_grid.hpp"
#include "iga/spaces/multiplier_space.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Triplets = std::vector<Eigen::Triplet<double>>;

// (functions of a face, multipliers) of the products of two lines' splines.
Eigen::SparseMatrix<double> products(const Eigen::SparseMatrix<double>& first,
                                     const Eigen::SparseMatrix<double>& second) {
  Triplets entries;
  for (Index b = 0; b < second.cols(); ++b)
    for (Eigen::SparseMatrix<double>::InnerIterator j(second, b); j; ++j)
      for (Index a = 0; a < first.cols(); ++a)
        for (Eigen::SparseMatrix<double>::InnerIterator i(first, a); i; ++i)
          entries.emplace_back(static_cast<int>(i.row() + first.rows() * j.row()),
                               static_cast<int>(a + first.cols() * b), i.value() * j.value());
  Eigen::SparseMatrix<double> result(first.rows() * second.rows(), first.cols() * second.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// The splines of a face, without weights, that are not 0 on one of its elements.
class FaceSplines {
 public:
  explicit FaceSplines(const PatchSide& side) : knots_{side.knots(0), side.knots(1)} {
    for (std::size_t d = 0; d < 2; ++d) breaks_[d] = knots_[d].breaks();
  }

  // Their numbers in the face, with the first direction fastest.
  std::vector<int> functions(const ElementOfFace& element) const {
    std::vector<int> result;
    const int first = span(0, element) - knots_[0].degree(), second = span(1, element) - knots_[1].degree();
    for (int j = 0; j <= knots_[1].degree(); ++j)
      for (int i = 0; i <= knots_[0].degree(); ++i)
        result.push_back(first + i + knots_[0].size() * (second + j));
    return result;
  }
  Eigen::VectorXd values(const ElementOfFace& element, const geometry::Parameter<2>& at) const {
    const Eigen::RowVectorXd u = geometry::basis_on_span(knots_[0], span(0, element), at[0]).row(0);
    const Eigen::RowVectorXd v = geometry::basis_on_span(knots_[1], span(1, element), at[1]).row(0);
    return (u.transpose() * v).reshaped();
  }

 private:
  int span(std::size_t d, const ElementOfFace& element) const {
    const auto e = static_cast<std::size_t>(element[d]);
    return knots_[d].span(0.5 * (breaks_[d][e] + breaks_[d][e + 1]));
  }
  std::array<geometry::KnotVector, 2> knots_;
  std::array<std::vector<double>, 2> breaks_;
};

// The integrals of one slave face with its own splines in place of multipliers.
class FaceIntegrals {
 public:
  FaceIntegrals(const PatchSide& slave, const SideFunctions& functions)
      : slave_(slave), functions_(functions), splines_(slave) {}

  void add(const PatchSide& master, const SideFunctions& of_master, double same_point) {
    const auto grid = geometry::shared_grid(slave_.divided(), master.divided(),
                                            points_of_rectangle(functions_, of_master), same_point);
    if (grid) {
      const TraceIntegrals traces = grid_traces(functions_, of_master, *grid);
      of_slave_.insert(of_slave_.end(), traces.of_own.begin(), traces.of_own.end());
      for (const auto& entry : traces.of_other)
        of_masters_.emplace_back(entry.row(), entry.col(), -entry.value());
      return;
    }
    for (const geometry::SharedCell& cell : geometry::common_refinement(
             slave_.divided(), master.divided(), points_of_cell(slave_, master), same_point))
      add(master, cell);
  }
  const Triplets& of_slave() const { return of_slave_; }
  const Triplets& of_masters() const { return of_masters_; }

 private:
  // The traces of one side's functions at the points of a cell.
  struct Traces {
    std::vector<int> nodes;
    Eigen::MatrixXd values;  // (nodes, points)
  };
  static void add_point(const PatchSide::Functions& functions, Index point, Index points, Traces& traces) {
    Index row = 0;
    if (point == 0) {
      for (std::size_t f = 0; f < functions.nodes.size(); ++f)
        if (functions.is_on_side[f]) traces.nodes.push_back(functions.nodes[f]);
      traces.values.resize(static_cast<Index>(traces.nodes.size()), points);
    }
    for (std::size_t f = 0; f < functions.nodes.size(); ++f)
      if (functions.is_on_side[f]) traces.values(row++, point) = functions.values[f];
  }
  static void add_block(const std::vector<int>& rows, const std::vector<int>& columns,
                        const Eigen::MatrixXd& block, Triplets& entries) {
    for (Index j = 0; j < block.cols(); ++j)
      for (Index i = 0; i < block.rows(); ++i)
        entries.emplace_back(rows[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)],
                             block(i, j));
  }

  void add(const PatchSide& master, const geometry::SharedCell& cell) {
    const auto points = static_cast<Index>(cell.points.size());
    const std::vector<int> functions = splines_.functions(cell.first);
    Eigen::MatrixXd multipliers(static_cast<Index>(functions.size()), points);
    Eigen::RowVectorXd weights(points);
    Traces own, other;
    for (Index q = 0; q < points; ++q) {
      const geometry::SharedPoint& point = cell.points[static_cast<std::size_t>(q)];
      add_point(slave_.functions(cell.first, point.first), q, points, own);
      add_point(master.functions(cell.second, point.second), q, points, other);
      multipliers.col(q) = splines_.values(cell.first, point.first);
      weights[q] = point.weight;
    }
    const Eigen::MatrixXd weighted = multipliers * weights.asDiagonal();
    add_block(functions, own.nodes, weighted * own.values.transpose(), of_slave_);
    add_block(functions, other.nodes, -weighted * other.values.transpose(), of_masters_);
  }

  const PatchSide& slave_;
  const SideFunctions& functions_;
  FaceSplines splines_;
  Triplets of_slave_, of_masters_;
};

using Sparse = Eigen::SparseMatrix<double>;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

SparseRows matrix_of(const Triplets& entries, Index rows, Index columns) {
  SparseRows result(rows, columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Appends the entries of a matrix.
template <class Matrix>
void append(const Matrix& matrix, int first_row, int first_column, Triplets& entries) {
  for (Index k = 0; k < matrix.outerSize(); ++k)
    for (typename Matrix::InnerIterator it(matrix, k); it; ++it)
      entries.emplace_back(first_row + static_cast<int>(it.row()), first_column + static_cast<int>(it.col()),
                           it.value());
}

}  // namespace

MortarTies ties_of(const MortarTies& all, const std::vector<PatchLayers>& parts) {
  MortarTies result;
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    const int slave = all.faces[f].slave.patch.value;
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const PatchLayers& part) { return part.couples && part.patch == slave; }))
      continue;
    result.faces.push_back(all.faces[f]);
    result.edges.push_back(all.edges[f]);
  }
  return result;
}

MortarConstraints mortar_constraints(const MortarTies& ties, const std::vector<PatchSpace>& spaces,
                                     double same_point) {
  const std::vector<MortarFace>& faces = ties.faces;
  const std::vector<int> first_node = first_nodes(spaces);
  const auto side = [&](const geometry::PatchFace& face) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    return PatchSide(spaces[p], face.side, first_node[p]);
  };
  const auto functions = [&](const geometry::PatchFace& face) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    return SideFunctions(spaces[p], face.side, first_node[p]);
  };
  MortarConstraints result;
  result.ties = ties;
  result.first_row = {0};
  Triplets jumps;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const PatchSide slave = side(faces[f].slave);
    const SideFunctions of_slave_side = functions(faces[f].slave);
    FaceIntegrals integrals(slave, of_slave_side);
    for (const geometry::PatchFace& master : faces[f].masters)
      integrals.add(side(master), functions(master), same_point);
    const Index splines = Index{slave.knots(0).size()} * slave.knots(1).size();
    const SparseRows of_slave = matrix_of(integrals.of_slave(), splines, first_node.back());
    const SparseRows of_masters = matrix_of(integrals.of_masters(), splines, first_node.back());
    for (int c = 0; c < 3; ++c) {
      const std::optional<SharedEdges>& shared = ties.edges[f][static_cast<std::size_t>(c)];
      if (!shared) continue;
      const Sparse coefficients = products(multiplier_coefficients(slave.knots(0), (*shared)[0]),
                                           multiplier_coefficients(slave.knots(1), (*shared)[1]));
      const SparseRows own = coefficients.transpose() * of_slave;
      Eigen::VectorXd inverse(coefficients.cols());
      for (Index i = 0; i < inverse.size(); ++i) {
        result.size.push_back(own.row(i).cwiseAbs().sum());
        inverse[i] = 1 / result.size.back();
      }
      const SparseRows both = own + SparseRows(coefficients.transpose() * of_masters);
      const auto next = static_cast<int>(result.component.size());
      append(SparseRows(inverse.asDiagonal() * both), next, 0, jumps);
      result.component.insert(result.component.end(), static_cast<std::size_t>(inverse.size()), c);
    }
    result.first_row.push_back(static_cast<int>(result.component.size()));
  }
  result.jumps = matrix_of(jumps, result.rows(), first_node.back());
  return result;
}

solvers::ConstraintMatrix mortar_matrix(const MortarConstraints& constraints, const RowNumbering& numbering,
                                        const std::vector<const SupportFrame*>& frame_of_row) {
  Triplets entries;
  for (int i = 0; i < constraints.rows(); ++i) {
    const int c = constraints.component[static_cast<std::size_t>(i)];
    for (SparseRows::InnerIterator it(constraints.jumps, i); it; ++it) {
      const int row = numbering.row_of_node[static_cast<std::size_t>(it.col())];
      const SupportFrame& frame = *frame_of_row[static_cast<std::size_t>(row)];
      for (int k = 0; k < frame.free; ++k)
        if (frame.axes(c, k) != 0) entries.emplace_back(i, 3 * row + k, it.value() * frame.axes(c, k));
    }
  }
  solvers::ConstraintMatrix result(constraints.rows(), 3 * Index{numbering.rows});
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::VectorXd mortar_right_side(const MortarConstraints& constraints, const RowNumbering& numbering,
                                  const Eigen::VectorXd& prescribed) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(constraints.rows());
  for (int i = 0; i < constraints.rows(); ++i)
    for (SparseRows::InnerIterator it(constraints.jumps, i); it; ++it)
      result[i] -= it.value() * prescribed[3 * numbering.row_of_node[static_cast<std::size_t>(it.col())] +
                                           constraints.component[static_cast<std::size_t>(i)]];
  return result;
}

Eigen::Matrix3Xd mortar_forces(const MortarConstraints& constraints, const Eigen::VectorXd& multipliers) {
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, constraints.jumps.cols());
  for (int i = 0; i < constraints.rows(); ++i)
    for (SparseRows::InnerIterator it(constraints.jumps, i); it; ++it)
      result(constraints.component[static_cast<std::size_t>(i)], it.col()) += it.value() * multipliers[i];
  return result;
}

std::vector<Eigen::Vector3d> forces_on_slaves(const MortarConstraints& constraints,
                                              const std::vector<PatchSpace>& spaces,
                                              const Eigen::VectorXd& multipliers) {
  const std::vector<int> first_node = first_nodes(spaces);
  std::vector<Eigen::Vector3d> result;
  for (std::size_t f = 0; f < constraints.ties.faces.size(); ++f) {
    const auto p = static_cast<std::size_t>(constraints.ties.faces[f].slave.patch.value);
    const int first = first_node[p], end = first_node[p + 1];
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (int i = constraints.first_row[f]; i < constraints.first_row[f + 1]; ++i)
      for (SparseRows::InnerIterator it(constraints.jumps, i); it; ++it)
        if (it.col() >= first && it.col() < end)
          force[constraints.component[static_cast<std::size_t>(i)]] -= it.value() * multipliers[i];
    result.push_back(force);
  }
  return result;
}

}  // namespace isopatch::iga
