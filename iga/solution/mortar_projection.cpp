#include "iga/solution/mortar_projection.hpp"

#include <fmt/format.h>

#include <Eigen/SparseLU>
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

// Of the scalar matrix (functions, inner nodes), which is the same for all three components.
struct MortarProjection::Factors {
  Eigen::SparseLU<Sparse> of_inner;
};

MortarProjection::MortarProjection(const MortarConstraints& constraints, const solvers::ConstraintMatrix& b,
                                   const std::vector<std::array<int, 3>>& sizes,
                                   const std::vector<int>& first_node, const std::vector<int>& row_of_node,
                                   const std::vector<const SupportFrame*>& frame_of_row)
    : b_(&b), factors_(std::make_unique<Factors>()) {
  const auto refuse = [](const char* why) {
    throw Error(ErrorCode::unsupported,
                fmt::format("faces that do not match and have multipliers {}; use method = \"auto\", "
                            "\"mumps\" or \"minres\", or halve the elements there",
                            why));
  };
  std::vector<int> place(frame_of_row.size(), -1);
  for (std::size_t f = 0; f < constraints.faces.size(); ++f) {
    const geometry::PatchFace& face = constraints.faces[f].slave;
    const auto p = static_cast<std::size_t>(face.patch.value);
    const std::vector<int> nodes = inner_nodes(sizes[p], face.side, constraints.edges[f]);
    if (static_cast<int>(nodes.size()) != constraints.first_function[f + 1] - constraints.first_function[f])
      refuse("have no inner nodes to follow the others");
    for (const int node : nodes) {
      const int row = row_of_node[static_cast<std::size_t>(first_node[p] + node)];
      if (frame_of_row[static_cast<std::size_t>(row)]->free < 3) refuse("are held by supports inside");
      place[static_cast<std::size_t>(row)] = static_cast<int>(inner_.size());
      inner_.push_back(row);
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < b.rows(); i += 3)
    for (solvers::ConstraintMatrix::InnerIterator it(b, i); it; ++it)
      if (it.col() % 3 == 0 && place[static_cast<std::size_t>(it.col() / 3)] >= 0)
        entries.emplace_back(static_cast<int>(i / 3), place[static_cast<std::size_t>(it.col() / 3)],
                             it.value());
  const auto count = static_cast<Index>(inner_.size());
  Sparse of_inner(count, count);
  of_inner.setFromTriplets(entries.begin(), entries.end());
  factors_->of_inner.compute(of_inner);
  if (factors_->of_inner.info() != Eigen::Success) refuse("do not determine their inner nodes");
}

MortarProjection::~MortarProjection() = default;

VectorXd MortarProjection::on_inner(const VectorXd& x) const {
  VectorXd result(3 * static_cast<Index>(inner_.size()));
  for (std::size_t i = 0; i < inner_.size(); ++i)
    result.segment<3>(3 * static_cast<Index>(i)) = x.segment<3>(3 * static_cast<Index>(inner_[i]));
  return result;
}

void MortarProjection::add_to_inner(const VectorXd& values, VectorXd& x) const {
  for (std::size_t i = 0; i < inner_.size(); ++i)
    x.segment<3>(3 * static_cast<Index>(inner_[i])) += values.segment<3>(3 * static_cast<Index>(i));
}

VectorXd MortarProjection::particular(const VectorXd& g) const {
  const Eigen::MatrixX3d of_components = g.reshaped(3, g.size() / 3).transpose();
  const Eigen::Matrix3Xd solved = factors_->of_inner.solve(of_components).transpose();
  VectorXd result = VectorXd::Zero(b_->cols());
  add_to_inner(solved.reshaped(), result);
  return result;
}

VectorXd MortarProjection::project(VectorXd x) const {
  x -= particular(*b_ * x);
  return x;
}

VectorXd MortarProjection::multipliers(const VectorXd& force) const {
  const VectorXd here = on_inner(force);
  const Eigen::MatrixX3d of_components = here.reshaped(3, here.size() / 3).transpose();
  const Eigen::MatrixX3d solved = factors_->of_inner.transpose().solve(of_components);
  return Eigen::Matrix3Xd(solved.transpose()).reshaped();
}

VectorXd MortarProjection::moved_to_masters(VectorXd force) const {
  force -= b_->transpose() * multipliers(force);
  // Nothing but round-off is left there.
  for (const int row : inner_) force.segment<3>(3 * static_cast<Index>(row)).setZero();
  return force;
}

}  // namespace isopatch::iga
