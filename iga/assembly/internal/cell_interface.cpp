#include "iga/assembly/internal/cell_interface.hpp"

#include "geometry/common_refinement.hpp"

namespace isopatch::iga {
namespace {

// What all points of one cell add to the blocks of its functions: those of the traction's side, and those of
// either side that are not 0 there, which make the jump. With g the gradients, n the normal and J the jumps
// everything follows from the sums over the points of J_b g_a n^T and J_a J_b n n^T.
class CellBlocks {
 public:
  CellBlocks(const PatchSide& own, const PatchSide& other, const geometry::SharedCell& cell) {
    const auto points = static_cast<Eigen::Index>(cell.points.size());
    normals_.resize(3, points);
    weights_.resize(points);
    for (Eigen::Index q = 0; q < points; ++q) {
      const geometry::SharedPoint& point = cell.points[static_cast<std::size_t>(q)];
      const PatchSide::Functions of_own = own.functions(cell.first, point.first);
      const PatchSide::Functions of_other = other.functions(cell.second, point.second);
      if (q == 0) begin(of_own, of_other, points);
      for (Eigen::Index d = 0; d < 3; ++d)
        for (std::size_t f = 0; f < nodes_.size(); ++f)
          gradients_[static_cast<std::size_t>(d)](static_cast<Eigen::Index>(f), q) = of_own.gradients[f][d];
      Eigen::Index b = 0;
      for (const std::size_t f : own_jumps_) jumps_(b++, q) = of_own.values[f];
      for (const std::size_t f : other_jumps_) jumps_(b++, q) = -of_other.values[f];
      normals_.col(q) = of_own.normal;
      weights_[q] = point.weight;
    }
  }

  void add_to(BlockSums& blocks, const Material& material, double penalty) const {
    add_tractions(blocks, material);
    add_penalty(blocks, material, penalty);
  }

 private:
  void begin(const PatchSide::Functions& own, const PatchSide::Functions& other, Eigen::Index points) {
    nodes_ = own.nodes;
    for (std::size_t f = 0; f < own.nodes.size(); ++f) {
      if (!own.is_on_side[f]) continue;
      own_jumps_.push_back(f);
      jump_nodes_.push_back(own.nodes[f]);
    }
    for (std::size_t f = 0; f < other.nodes.size(); ++f) {
      if (!other.is_on_side[f]) continue;
      other_jumps_.push_back(f);
      jump_nodes_.push_back(other.nodes[f]);
    }
    for (Eigen::MatrixXd& gradients : gradients_)
      gradients.resize(static_cast<Eigen::Index>(nodes_.size()), points);
    jumps_.resize(static_cast<Eigen::Index>(jump_nodes_.size()), points);
  }

  // Minus the traction of N_a e_i times the jump of N_b e_j, and its transpose.
  void add_tractions(BlockSums& blocks, const Material& material) const {
    std::array<Eigen::MatrixXd, 9> sums;  // of J_b g_d n_e at d + 3 e
    for (Eigen::Index e = 0; e < 3; ++e) {
      const Eigen::MatrixXd scaled = jumps_ * (weights_.cwiseProduct(normals_.row(e))).asDiagonal();
      for (Eigen::Index d = 0; d < 3; ++d)
        sums[static_cast<std::size_t>(d + 3 * e)].noalias() =
            gradients_[static_cast<std::size_t>(d)] * scaled.transpose();
    }
    for (Eigen::Index b = 0; b < jumps_.rows(); ++b)
      for (Eigen::Index a = 0; a < gradients_[0].rows(); ++a) {
        Eigen::Matrix3d of_pair;  // gradient times normal
        for (std::size_t k = 0; k < 9; ++k) of_pair(static_cast<Eigen::Index>(k)) = sums[k](a, b);
        const Eigen::Matrix3d transposed_traction =
            material.lambda * of_pair +
            material.mu * (of_pair.trace() * Eigen::Matrix3d::Identity() + of_pair.transpose());
        const int first = nodes_[static_cast<std::size_t>(a)],
                  second = jump_nodes_[static_cast<std::size_t>(b)];
        if (first == second)
          blocks.add(first, second, -(transposed_traction + transposed_traction.transpose()));
        else
          blocks.add(first, second, -transposed_traction);
      }
  }

  void add_penalty(BlockSums& blocks, const Material& material, double penalty) const {
    const Eigen::MatrixXd plain = jumps_ * weights_.asDiagonal() * jumps_.transpose();
    std::array<Eigen::MatrixXd, 9> sums;
    for (Eigen::Index e = 0; e < 3; ++e)
      for (Eigen::Index d = 0; d <= e; ++d) {
        const Eigen::RowVectorXd scale = weights_.cwiseProduct(normals_.row(e)).cwiseProduct(normals_.row(d));
        sums[static_cast<std::size_t>(d + 3 * e)] = jumps_ * scale.asDiagonal() * jumps_.transpose();
        sums[static_cast<std::size_t>(e + 3 * d)] = sums[static_cast<std::size_t>(d + 3 * e)];
      }
    for (Eigen::Index b = 0; b < jumps_.rows(); ++b)
      for (Eigen::Index a = 0; a <= b; ++a) {
        Eigen::Matrix3d value = material.mu * plain(a, b) * Eigen::Matrix3d::Identity();
        for (std::size_t k = 0; k < 9; ++k)
          value(static_cast<Eigen::Index>(k)) += (material.lambda + material.mu) * sums[k](a, b);
        const int first = jump_nodes_[static_cast<std::size_t>(a)];
        const int second = jump_nodes_[static_cast<std::size_t>(b)];
        // A patch that meets itself may have one node on both sides.
        const double copies = a != b && first == second ? 2 : 1;
        blocks.add(first, second, copies * penalty * value);
      }
  }

  std::vector<int> nodes_;                    // of the functions on the traction's side
  std::vector<int> jump_nodes_;               // of those in the jump
  std::vector<std::size_t> own_jumps_;        // among the functions of the traction's side
  std::vector<std::size_t> other_jumps_;      // among those of the other side
  std::array<Eigen::MatrixXd, 3> gradients_;  // (functions, points) per direction
  Eigen::MatrixXd jumps_;                     // (functions in the jump, points)
  Eigen::Matrix3Xd normals_;
  Eigen::RowVectorXd weights_;
};

}  // namespace

NodeBlocks cell_stiffness(const PatchSide& own, const PatchSide& other, const Eigen::MatrixXd& penalties,
                          const Material& material, int points, double same_point) {
  BlockSums sums;
  for (const geometry::SharedCell& cell :
       geometry::common_refinement(own.divided(), other.divided(), points, same_point))
    CellBlocks(own, other, cell).add_to(sums, material, penalties(cell.first[0], cell.first[1]));
  return sums.blocks();
}

}  // namespace isopatch::iga
