#include "iga/multigrid/level_transfer.hpp"

#include "iga/internal/tensor_apply.hpp"

namespace isopatch::iga {
namespace {

// The values of one patch's nodes, three each.
Eigen::VectorXd gathered(const Level& level, int patch, const Eigen::VectorXd& of_rows) {
  const int first = level.first_node[static_cast<std::size_t>(patch)];
  const int last = level.first_node[static_cast<std::size_t>(patch) + 1];
  Eigen::VectorXd values(3 * static_cast<Eigen::Index>(last - first));
  for (int node = first; node < last; ++node)
    values.segment<3>(3 * static_cast<Eigen::Index>(node - first)) =
        of_rows.segment<3>(3 * static_cast<Eigen::Index>(level.row_of_node[static_cast<std::size_t>(node)]));
  return values;
}

template <class Matrices>
Eigen::VectorXd along_all(Eigen::VectorXd values, std::array<int, 3> sizes, const Matrices& matrices) {
  for (int d = 0; d < 3; ++d)
    values = apply_sparse_along(values, 3, sizes, d, matrices[static_cast<std::size_t>(d)]);
  return values;
}

// Times the weights of rational functions, or their inverses.
Eigen::VectorXd weighted(Eigen::VectorXd values, const PatchSpace& space, bool inverse) {
  if (!space.is_rational()) return values;
  for (Eigen::Index i = 0; i < space.weights.size(); ++i)
    values.segment<3>(3 * i) *= inverse ? 1 / space.weights[i] : space.weights[i];
  return values;
}

}  // namespace

LevelTransfer::LevelTransfer(const Level& coarse, const Level& fine) : coarse_(&coarse), fine_(&fine) {
  for (std::size_t p = 0; p < fine.spaces.size(); ++p) {
    Directions down;
    Directions up;
    for (std::size_t d = 0; d < 3; ++d) {
      down[d] = geometry::transfer(coarse.spaces[p].knots[d], fine.spaces[p].knots[d]);
      up[d] = down[d].transpose();
    }
    matrices_.push_back(std::move(down));
    transposed_.push_back(std::move(up));
  }
  std::vector<int> members(static_cast<std::size_t>(fine.rows.global_rows()), 0);
  for (const int c : fine.global_of) ++members[static_cast<std::size_t>(c)];
  share_.resize(fine.rows.local_rows());
  for (Eigen::Index row = 0; row < share_.size(); ++row)
    share_[row] =
        1.0 / members[static_cast<std::size_t>(fine.rows.global_of_local()[static_cast<std::size_t>(row)])];
}

Eigen::VectorXd LevelTransfer::to_finer(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd coarse = coarse_->free.to_space(x);
  Eigen::VectorXd fine = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(fine_->rows.local_rows()));
  for (const PatchLayers& part : fine_->parts) {
    const auto p = static_cast<std::size_t>(part.patch);
    const bool rational = coarse_->spaces[p].is_rational();
    Eigen::VectorXd start = gathered(*coarse_, part.patch, coarse);
    if (rational) start = weighted(std::move(start), coarse_->spaces[p], false);
    Eigen::VectorXd values = along_all(std::move(start), coarse_->spaces[p].sizes(), matrices_[p]);
    if (rational) values = weighted(std::move(values), fine_->spaces[p], true);
    const int first = fine_->first_node[p];
    for (int node = first; node < fine_->first_node[p + 1]; ++node)
      fine.segment<3>(3 * static_cast<Eigen::Index>(fine_->row_of_node[static_cast<std::size_t>(node)])) =
          values.segment<3>(3 * static_cast<Eigen::Index>(node - first));
  }
  return fine_->free.to_free(std::move(fine));
}

Eigen::VectorXd LevelTransfer::from_finer(const Eigen::VectorXd& force) const {
  Eigen::VectorXd fine = fine_->free.to_space(force);
  for (Eigen::Index row = 0; row < share_.size(); ++row) fine.segment<3>(3 * row) *= share_[row];
  Eigen::VectorXd coarse = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(coarse_->rows.local_rows()));
  for (const PatchLayers& part : fine_->parts) {
    const auto p = static_cast<std::size_t>(part.patch);
    if (!fine_->is_primary[p]) continue;
    const bool rational = coarse_->spaces[p].is_rational();
    Eigen::VectorXd start = gathered(*fine_, part.patch, fine);
    if (rational) start = weighted(std::move(start), fine_->spaces[p], true);
    Eigen::VectorXd values = along_all(std::move(start), fine_->spaces[p].sizes(), transposed_[p]);
    if (rational) values = weighted(std::move(values), coarse_->spaces[p], false);
    const int first = coarse_->first_node[p];
    for (int node = first; node < coarse_->first_node[p + 1]; ++node)
      coarse.segment<3>(3 *
                        static_cast<Eigen::Index>(coarse_->row_of_node[static_cast<std::size_t>(node)])) +=
          values.segment<3>(3 * static_cast<Eigen::Index>(node - first));
  }
  coarse_->rows.sum(coarse);
  return coarse_->free.to_free(std::move(coarse));
}

}  // namespace isopatch::iga
