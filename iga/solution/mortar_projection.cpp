#include "iga/solution/mortar_projection.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// The nodes of a side that lie on none of its shared edges.
std::vector<int> inner_nodes(const std::array<int, 3>& sizes, geometry::Side side,
                             const SharedEdges& shared) {
  const std::vector<int> all = geometry::face_control_points(sizes, side);
  const auto along = geometry::tangents(side);
  const int n = sizes[static_cast<std::size_t>(along[0])], m = sizes[static_cast<std::size_t>(along[1])];
  std::vector<int> result;
  for (int j = shared[1][0]; j < m - shared[1][1]; ++j)
    for (int i = shared[0][0]; i < n - shared[0][1]; ++i)
      result.push_back(all[static_cast<std::size_t>(i + n * j)]);
  return result;
}

}  // namespace

MortarProjection::MortarProjection(const MortarConstraints& constraints, const solvers::ConstraintMatrix& b,
                                   const solvers::SharedRows& rows,
                                   const std::vector<std::array<int, 3>>& sizes,
                                   const std::vector<int>& first_node, const std::vector<int>& row_of_node,
                                   const std::vector<const SupportFrame*>& frame_of_row)
    : b_(&b), rows_(rows) {
  const auto refuse = [](const char* why) {
    throw Error(ErrorCode::unsupported,
                fmt::format("faces that do not match and have multipliers {}; use method = \"auto\", "
                            "\"mumps\" or \"minres\", or halve the elements there",
                            why));
  };
  std::vector<int> place(static_cast<std::size_t>(b.cols()), -1);
  for (std::size_t f = 0; f < constraints.faces.size(); ++f) {
    const geometry::PatchFace& face = constraints.faces[f].slave;
    const auto p = static_cast<std::size_t>(face.patch.value);
    for (int c = 0; c < 3; ++c) {
      const std::optional<SharedEdges>& shared = constraints.edges[f][static_cast<std::size_t>(c)];
      if (!shared) continue;
      for (const int node : inner_nodes(sizes[p], face.side, *shared)) {
        const int row = row_of_node[static_cast<std::size_t>(first_node[p] + node)];
        const int axis = free_axis_along(*frame_of_row[static_cast<std::size_t>(row)], c);
        if (axis < 0) refuse("are held by supports inside");
        place[static_cast<std::size_t>(3 * row + axis)] = static_cast<int>(followers_.size());
        followers_.push_back(3 * Index{row} + axis);
      }
    }
  }
  const auto count = static_cast<Index>(followers_.size());
  if (count != b.rows()) refuse("have no inner nodes to follow the others");
  if (count == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < b.rows(); ++i)
    for (solvers::ConstraintMatrix::InnerIterator it(b, i); it; ++it)
      if (const int column = place[static_cast<std::size_t>(it.col())]; column >= 0)
        entries.emplace_back(static_cast<int>(i), column, it.value());
  Sparse of_followers(count, count);
  of_followers.setFromTriplets(entries.begin(), entries.end());
  factors_.emplace(of_followers);
  if (factors_->is_singular()) refuse("do not determine the nodes that follow");
}

// The displacement of this process' followers.
VectorXd MortarProjection::followers_for(const VectorXd& g) const {
  VectorXd result = VectorXd::Zero(b_->cols());
  if (!factors_) return result;
  const VectorXd values = factors_->solve(g);
  for (std::size_t i = 0; i < followers_.size(); ++i) result[followers_[i]] = values[static_cast<Index>(i)];
  return result;
}

VectorXd MortarProjection::particular(const VectorXd& g) const {
  VectorXd result = followers_for(g);
  rows_.sum(result);
  return result;
}

VectorXd MortarProjection::project(VectorXd x) const {
  x -= particular(*b_ * x);
  return x;
}

VectorXd MortarProjection::multipliers(const VectorXd& force) const {
  if (!factors_) return VectorXd(0);
  const VectorXd here = force(followers_);
  return factors_->solve_transposed(here);
}

VectorXd MortarProjection::moved_to_masters(VectorXd force) const {
  VectorXd moved = b_->transpose() * multipliers(force);
  // Nothing but round-off would be left there.
  for (const Index at : followers_) moved[at] = force[at];
  rows_.sum(moved);
  return force - moved;
}

}  // namespace isopatch::iga
