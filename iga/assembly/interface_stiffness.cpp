#include "iga/assembly/interface_stiffness.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "geometry/common_refinement.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::iga {
namespace {

using geometry::Side;
using ElementOfFace = std::array<int, 2>;

// Gauss points per direction of a cell beyond the degree: what is integrated has twice the degree, and areas
// are no polynomials.
constexpr int points_beyond_degree = 3;

// A side of a patch with the functions that are not 0, or have no gradient 0, on its elements.
class SideOfPatch {
 public:
  SideOfPatch(const PatchSpace& space, Side side, int first_node)
      : space_(space),
        side_(side),
        first_node_(first_node),
        surface_(geometry::face_surface(*space.geometry, side)),
        along_(geometry::tangents(side)) {
    for (int d = 0; d < 3; ++d)
      breaks_[static_cast<std::size_t>(d)] = space.knots[static_cast<std::size_t>(d)].breaks();
  }

  geometry::DividedSurface divided() const {
    return {&surface_,
            {breaks_[static_cast<std::size_t>(along_[0])], breaks_[static_cast<std::size_t>(along_[1])]}};
  }
  int degree() const {
    return std::max({space_.knots[0].degree(), space_.knots[1].degree(), space_.knots[2].degree()});
  }

  // The volume's element behind an element of the side, per direction.
  std::array<int, 3> element(const ElementOfFace& of_face) const {
    std::array<int, 3> result;
    result[static_cast<std::size_t>(along_[0])] = of_face[0];
    result[static_cast<std::size_t>(along_[1])] = of_face[1];
    const int d = geometry::direction(side_);
    result[static_cast<std::size_t>(d)] =
        geometry::is_high(side_) ? static_cast<int>(breaks_[static_cast<std::size_t>(d)].size()) - 2 : 0;
    return result;
  }

  // The functions of an element at a parameter of the side.
  struct Functions {
    std::vector<int> nodes;        ///< of all patches
    std::vector<bool> is_on_side;  ///< whether the function is not 0 on the side
    std::vector<double> values;
    std::vector<Eigen::Vector3d> gradients;  ///< in space
    Eigen::Vector3d normal;                  ///< outward
  };
  Functions functions(const ElementOfFace& of_face, const geometry::Parameter<2>& on_side) const {
    const geometry::Parameter<3> at = geometry::on_side(*space_.geometry, side_, on_side);
    const std::array<int, 3> element = this->element(of_face);
    std::array<Eigen::MatrixXd, 3> bases;
    std::array<int, 3> first;
    for (std::size_t d = 0; d < 3; ++d) {
      const geometry::KnotVector& knots = space_.knots[d];
      const auto e = static_cast<std::size_t>(element[d]);
      const int span = knots.span(0.5 * (breaks_[d][e] + breaks_[d][e + 1]));
      first[d] = span - knots.degree();
      bases[d] = geometry::basis_on_span(knots, span, at[static_cast<Eigen::Index>(d)], 1);
    }
    const Eigen::Matrix3d inverse = space_.geometry->jacobian(at).inverse();
    Functions result;
    // Along the gradient of the parameter that is constant on the side.
    result.normal = (geometry::is_high(side_) ? 1 : -1) *
                    inverse.row(geometry::direction(side_)).transpose().normalized();
    add_functions(bases, first, result);
    for (Eigen::Vector3d& gradient : result.gradients) gradient = inverse.transpose() * gradient;
    return result;
  }

  // (degree + 1)^2 / thickness, the largest over the side of an element: for strains that are polynomials
  // along the lines across it, the most that their square on the side is of their square in the element.
  double trace_constant(const ElementOfFace& of_face) const {
    const std::array<int, 3> element = this->element(of_face);
    const auto across = static_cast<std::size_t>(geometry::direction(side_));
    const int degree = space_.knots[across].degree();
    const geometry::QuadratureRule rule = geometry::gauss_legendre(degree + 2);
    const auto at = [&](std::size_t d, double share) {
      const auto e = static_cast<std::size_t>(element[d]);
      return breaks_[d][e] + share * (breaks_[d][e + 1] - breaks_[d][e]);
    };
    const auto u = static_cast<std::size_t>(along_[0]), v = static_cast<std::size_t>(along_[1]);
    const double length = at(across, 1) - at(across, 0);
    double thinnest = std::numeric_limits<double>::infinity();
    for (const double s : rule.nodes)
      for (const double t : rule.nodes) {
        const geometry::Parameter<2> on_side(at(u, s), at(v, t));
        const auto tangents = surface_.jacobian(on_side);
        const double area = Eigen::Vector3d(tangents.col(0)).cross(Eigen::Vector3d(tangents.col(1))).norm();
        geometry::Parameter<3> parameter = geometry::on_side(*space_.geometry, side_, on_side);
        for (const double w : rule.nodes) {
          parameter[static_cast<Eigen::Index>(across)] = at(across, w);
          const double volume = std::abs(space_.geometry->jacobian(parameter).determinant());
          thinnest = std::min(thinnest, volume * length / area);
        }
      }
    return (degree + 1) * (degree + 1) / thinnest;
  }

 private:
  void add_functions(const std::array<Eigen::MatrixXd, 3>& bases, const std::array<int, 3>& first,
                     Functions& result) const {
    const auto sizes = space_.sizes();
    const int across = geometry::direction(side_);
    const int on_side = geometry::is_high(side_) ? sizes[static_cast<std::size_t>(across)] - 1 : 0;
    double denominator = 0;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (int k = 0; k < bases[2].cols(); ++k)
      for (int j = 0; j < bases[1].cols(); ++j)
        for (int i = 0; i < bases[0].cols(); ++i) {
          const std::array<int, 3> index = {first[0] + i, first[1] + j, first[2] + k};
          const int node = index[0] + sizes[0] * (index[1] + sizes[1] * index[2]);
          const double weight = space_.is_rational() ? space_.weights[node] : 1.0;
          result.nodes.push_back(first_node_ + node);
          result.is_on_side.push_back(index[static_cast<std::size_t>(across)] == on_side);
          result.values.push_back(weight * bases[0](0, i) * bases[1](0, j) * bases[2](0, k));
          result.gradients.emplace_back(weight * bases[0](1, i) * bases[1](0, j) * bases[2](0, k),
                                        weight * bases[0](0, i) * bases[1](1, j) * bases[2](0, k),
                                        weight * bases[0](0, i) * bases[1](0, j) * bases[2](1, k));
          denominator += result.values.back();
          slope += result.gradients.back();
        }
    for (std::size_t a = 0; a < result.nodes.size(); ++a) {
      result.values[a] /= denominator;
      result.gradients[a] = (result.gradients[a] - result.values[a] * slope) / denominator;
    }
  }

  const PatchSpace& space_;
  Side side_;
  int first_node_;
  geometry::NurbsSurface surface_;
  std::array<int, 2> along_;
  std::array<std::vector<double>, 3> breaks_;
};

// What all points of one cell add to the blocks of its functions: those of the traction's side, and those of
// either side that are not 0 there, which make the jump. With g the gradients, n the normal and J the jumps
// everything follows from the sums over the points of J_b g_a n^T and J_a J_b n n^T.
class CellBlocks {
 public:
  CellBlocks(const SideOfPatch& own, const SideOfPatch& other, const geometry::SharedCell& cell) {
    const auto points = static_cast<Eigen::Index>(cell.points.size());
    normals_.resize(3, points);
    weights_.resize(points);
    for (Eigen::Index q = 0; q < points; ++q) {
      const geometry::SharedPoint& point = cell.points[static_cast<std::size_t>(q)];
      const SideOfPatch::Functions of_own = own.functions(cell.first, point.first);
      const SideOfPatch::Functions of_other = other.functions(cell.second, point.second);
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

  void add_to(NodeBlocks& blocks, const Material& material, double penalty) const {
    add_tractions(blocks, material);
    add_penalty(blocks, material, penalty);
  }

 private:
  void begin(const SideOfPatch::Functions& own, const SideOfPatch::Functions& other, Eigen::Index points) {
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
  void add_tractions(NodeBlocks& blocks, const Material& material) const {
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

  void add_penalty(NodeBlocks& blocks, const Material& material, double penalty) const {
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

// How many sides of an element of a patch carry tractions.
int loaded_sides(const PatchSpace& space, const std::array<int, 3>& element, const std::vector<Side>& sides) {
  return static_cast<int>(std::count_if(sides.begin(), sides.end(), [&](Side side) {
    const auto d = static_cast<std::size_t>(geometry::direction(side));
    return element[d] == (geometry::is_high(side) ? space.knots[d].element_count() - 1 : 0);
  }));
}

// Of elements of a side, as the square of a diagonal over their number: for comparison only.
double element_size(const geometry::NurbsVolume& patch, Side side) {
  const geometry::NurbsSurface surface = geometry::face_surface(patch, side);
  return (surface.control_points().rightCols<1>() - surface.control_points().leftCols<1>()).squaredNorm() /
         (surface.knots(0).element_count() * surface.knots(1).element_count());
}

}  // namespace

std::vector<CoupledFaces> coupled_faces(const Discretization& discretization,
                                        const std::vector<Material>& materials) {
  const auto measure = [&](const geometry::PatchFace& face) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    return std::pair(young(materials[p]), element_size(discretization.patches[p], face.side));
  };
  std::vector<CoupledFaces> result;
  for (const geometry::NonMatchingInterface& interface : discretization.model.non_matching()) {
    const auto [stiffness, size] = measure(interface.first);
    const auto [other_stiffness, other_size] = measure(interface.second);
    const bool is_first =
        stiffness != other_stiffness ? stiffness < other_stiffness : size <= other_size * (1 + 1e-9);
    result.push_back(is_first ? CoupledFaces{interface.first, interface.second}
                              : CoupledFaces{interface.second, interface.first});
  }
  return result;
}

NodeBlocks interface_stiffness(const std::vector<CoupledFaces>& interfaces,
                               const std::vector<PatchSpace>& spaces, const std::vector<Material>& materials,
                               double same_point) {
  NodeBlocks result;
  if (interfaces.empty()) return result;
  std::vector<int> first_node = {0};
  for (const PatchSpace& space : spaces) first_node.push_back(first_node.back() + space.size());
  std::vector<std::vector<Side>> traction_sides(spaces.size());
  for (const CoupledFaces& faces : interfaces) {
    std::vector<Side>& sides = traction_sides[static_cast<std::size_t>(faces.traction.patch.value)];
    if (std::find(sides.begin(), sides.end(), faces.traction.side) == sides.end())
      sides.push_back(faces.traction.side);
  }
  for (const CoupledFaces& faces : interfaces) {
    const auto p = static_cast<std::size_t>(faces.traction.patch.value);
    const auto q = static_cast<std::size_t>(faces.other.patch.value);
    const SideOfPatch own(spaces[p], faces.traction.side, first_node[p]);
    const SideOfPatch other(spaces[q], faces.other.side, first_node[q]);
    const int points = std::max(own.degree(), other.degree()) + points_beyond_degree;
    std::map<ElementOfFace, double> penalties;
    for (const geometry::SharedCell& cell :
         geometry::common_refinement(own.divided(), other.divided(), points, same_point)) {
      auto penalty = penalties.find(cell.first);
      if (penalty == penalties.end()) {
        const int sides = loaded_sides(spaces[p], own.element(cell.first), traction_sides[p]);
        penalty = penalties.emplace(cell.first, 2 * sides * own.trace_constant(cell.first)).first;
      }
      CellBlocks(own, other, cell).add_to(result, materials[p], penalty->second);
    }
  }
  return result;
}

}  // namespace isopatch::iga
