#include "iga/coupling/supported_system.hpp"

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"

namespace isopatch::iga {
namespace {

using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

bool is_identity(const SupportFrame& frame) {
  return frame.free == 3;
}

// A block in the axes of its frames, with rows and columns of fixed components set to 0.
Block turned(const Block& block, const SupportFrame& row, const SupportFrame& column) {
  Block result = row.axes.transpose() * block * column.axes;
  for (int k = row.free; k < 3; ++k) result.row(k).setZero();
  for (int k = column.free; k < 3; ++k) result.col(k).setZero();
  return result;
}

}  // namespace

void apply_supports(solvers::SymmetricBlockMatrix& k, const solvers::SharedRows& rows,
                    const std::vector<const SupportFrame*>& frame_of_row, std::vector<LoadOfRows>& loads) {
  const double diagonal = solvers::mean_diagonal(k, rows);
  // Entries of the processes are summed, so only a row's owner has what must be there once.
  std::vector<bool> is_owned(static_cast<std::size_t>(k.block_rows()), !rows.is_distributed());
  if (rows.is_distributed())
    for (const int row : rows.owned()) is_owned[static_cast<std::size_t>(row)] = true;
  std::vector<Eigen::VectorXd> moved(loads.size(), Eigen::VectorXd::Zero(k.rows()));
  for (int row = 0; row < k.block_rows(); ++row) {
    const SupportFrame& of_row = *frame_of_row[static_cast<std::size_t>(row)];
    for (std::int64_t position = k.row_start[static_cast<std::size_t>(row)];
         position < k.row_start[static_cast<std::size_t>(row) + 1]; ++position) {
      const int column = k.columns[static_cast<std::size_t>(position)];
      const SupportFrame& of_column = *frame_of_row[static_cast<std::size_t>(column)];
      if (is_identity(of_row) && is_identity(of_column)) continue;
      Eigen::Map<Block> block(&k.values[static_cast<std::size_t>(9 * position)]);
      for (std::size_t i = 0; i < loads.size(); ++i) {
        moved[i].segment<3>(3 * row) += block * loads[i].prescribed.segment<3>(3 * column);
        if (column != row)
          moved[i].segment<3>(3 * column) += block.transpose() * loads[i].prescribed.segment<3>(3 * row);
      }
      block = turned(block, of_row, of_column);
      if (column == row && is_owned[static_cast<std::size_t>(row)])
        for (int i = of_row.free; i < 3; ++i) block(i, i) = diagonal;
    }
  }
  for (std::size_t i = 0; i < loads.size(); ++i) {
    Eigen::VectorXd& load = loads[i].load;
    rows.sum(moved[i]);
    load -= moved[i];
    for (int row = 0; row < k.block_rows(); ++row) {
      const SupportFrame& frame = *frame_of_row[static_cast<std::size_t>(row)];
      if (is_identity(frame)) continue;
      Eigen::Vector3d in_axes = frame.axes.transpose() * load.segment<3>(3 * row);
      in_axes.tail(3 - frame.free).setZero();
      load.segment<3>(3 * row) = in_axes;
    }
  }
}

void apply_supports(solvers::SymmetricBlockMatrix& stiffness, const FreeDirections& free,
                    const solvers::SharedRows& rows) {
  const std::vector<SupportFrame> frames = free.frames(stiffness.block_rows());
  std::vector<const SupportFrame*> of_rows;
  for (const SupportFrame& frame : frames) of_rows.push_back(&frame);
  std::vector<LoadOfRows> no_loads;
  apply_supports(stiffness, rows, of_rows, no_loads);
}

Eigen::Matrix3Xd displacement_of_rows(const Eigen::VectorXd& x,
                                      const std::vector<const SupportFrame*>& frame_of_row,
                                      const Eigen::VectorXd& prescribed) {
  Eigen::Matrix3Xd u(3, x.size() / 3);
  for (Eigen::Index row = 0; row < u.cols(); ++row) {
    const SupportFrame& frame = *frame_of_row[static_cast<std::size_t>(row)];
    u.col(row) =
        prescribed.segment<3>(3 * row) + frame.axes.leftCols(frame.free) * x.segment(3 * row, frame.free);
  }
  return u;
}

std::vector<MultiplierRow> multiplier_rows(const GlobalNodes& global,
                                           const std::vector<SupportFrame>& frames) {
  std::vector<MultiplierRow> rows;
  for (int c = 0; c < global.count(); ++c) {
    const auto members = global.nodes_of(c);
    for (std::size_t i = 1; i < members.size(); ++i)
      for (int axis = 0; axis < frames[static_cast<std::size_t>(c)].free; ++axis)
        rows.push_back({c, members[0], members[i], axis});
  }
  return rows;
}

solvers::ConstraintMatrix multiplier_matrix(const std::vector<MultiplierRow>& rows, int nodes) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    entries.emplace_back(static_cast<int>(r), 3 * rows[r].first + rows[r].axis, 1.0);
    entries.emplace_back(static_cast<int>(r), 3 * rows[r].second + rows[r].axis, -1.0);
  }
  solvers::ConstraintMatrix b(static_cast<Eigen::Index>(rows.size()), 3 * nodes);
  b.setFromTriplets(entries.begin(), entries.end());
  // Rows are edges of a graph on the components of the nodes; they are independent exactly if it has no
  // circle.
  UnionFind components(3 * nodes);
  for (const MultiplierRow& row : rows)
    if (!components.unite(3 * row.first + row.axis, 3 * row.second + row.axis))
      throw Error(ErrorCode::internal, "the multiplier rows are linearly dependent");
  return b;
}

Eigen::VectorXd recovered_multipliers(const std::vector<MultiplierRow>& rows, const GlobalNodes& global,
                                      const std::vector<SupportFrame>& frames,
                                      const Eigen::Matrix3Xd& residual) {
  const auto component = [&](const MultiplierRow& row, int node) {
    return frames[static_cast<std::size_t>(row.global_node)].axes.col(row.axis).dot(residual.col(node));
  };
  Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    // (I + 1 1^T)^-1 = I - 1 1^T / m applied to the rows r_first - r_second leaves the global node's mean
    // less r_second.
    const auto members = global.nodes_of(rows[r].global_node);
    double sum = 0;
    for (const int node : members) sum += component(rows[r], node);
    result[static_cast<Eigen::Index>(r)] =
        sum / static_cast<double>(members.size()) - component(rows[r], rows[r].second);
  }
  return result;
}

}  // namespace isopatch::iga
