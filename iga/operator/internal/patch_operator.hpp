#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "iga/material/material.hpp"
#include "iga/operator/internal/box_contraction.hpp"
#include "iga/operator/internal/line_table.hpp"
#include "iga/operator/internal/point_forms.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Scratch storage of one thread, used again from box to box.
struct PatchOperatorScratch {
  BoxContraction functions, geometry, results;
  BoxContraction displacements;  // of several at once, apart from the geometry
  std::vector<PointMap> maps;    // of a line
};

/// The stiffness of one patch as an operator, in boxes of elements.
class PatchOperator {
 public:
  /// @param points  Gauss points per element of the functions and direction; 0: degree + 1
  PatchOperator(int patch, const PatchSpace& space, const Material& material, int points);

  /// Cuts the elements of a range of layers into boxes whose buffers fit a second-level cache, and enough of
  /// them for many threads. The cut depends on nothing but the patch and the range.
  std::vector<ElementBox> boxes(int first_layer, int last_layer) const;
  BoxFunctions functions_of(const ElementBox& box) const;

  /// Adds K u of a box.
  /// @param displacement  three numbers per function of the patch
  /// @param forces        three numbers per function of the box
  /// @throws Error fold_over
  void add_forces(const ElementBox& box, const double* displacement, double* forces,
                  PatchOperatorScratch& scratch) const;
  /// The same of several displacements, for which the map of the geometry is computed once.
  /// More would leave the second-level cache, and the map is shared well enough.
  static constexpr std::size_t most_together = 5;
  /// @param displacements, forces  of each as above; `most_together` at most
  /// @cost  of each about three quarters of what it takes alone
  void add_forces(const ElementBox& box, std::span<const double* const> displacements,
                  std::span<double* const> forces, PatchOperatorScratch& scratch) const;
  /// Adds the integrals of grad N grad N^T over a box, six numbers per function of the box: entries 00, 11,
  /// 22, 01, 02, 12.
  /// @throws Error fold_over
  void add_squares(const ElementBox& box, double* squares, PatchOperatorScratch& scratch) const;

  std::int64_t bytes() const;

 private:
  // The functions or the geometry: tables in three directions, the first one in bands.
  struct Group {
    std::array<LineTable, 3> tables;
    std::vector<LaneBand> bands;
    std::array<int, 2> sizes = {0, 0};  // functions of directions 1 and 2
  };
  // What is expanded with the functions of a group.
  struct Fields {
    std::span<const double* const> displacements = {};
    const geometry::NurbsVolume* places = nullptr;
    const Eigen::VectorXd* weights = nullptr;  // to multiply the others
    bool has_weights = weights != nullptr;     // whether they are a field themselves
    int count() const {
      return 3 * static_cast<int>(displacements.size()) + (places ? 3 : 0) + (has_weights ? 1 : 0);
    }
  };
  class SeveralForces;
  using Evaluate = std::function<Lanes(const PointLine&, Lanes*)>;

  static Group group(const std::array<geometry::KnotVector, 3>& knots, std::array<LineTable, 3> tables);
  template <int F>
  static void spread_fields(const Group& group, const Fields& fields, const LaneBand& band,
                            BoxContraction& contraction);
  static void spread(const Group& group, const Fields& fields, const LaneBand& band,
                     BoxContraction& contraction);
  template <class Collect>
  void integrate(const ElementBox& box, const double* displacement, const Group& result_group,
                 const ContractionStages& result_stages, const Evaluate& evaluate,
                 PatchOperatorScratch& scratch, Collect collect) const;
  // What is expanded for the map of the geometry alone: with the functions, and with the geometry's own.
  Fields fields_of_map_in_functions() const;
  Fields fields_of_map_in_geometry() const;
  [[noreturn]] void refuse_folded(const ElementBox& box) const;

  int patch_;
  const PatchSpace* space_;
  Material material_;
  std::array<DirectionTable, 3> elements_;
  std::array<std::vector<double>, 3> quadrature_;  // weights of all points
  std::vector<Lanes> lane_weights_;                // of direction 1
  bool is_isoparametric_ = false;                  // functions and geometry are the same functions
  Denominators denominators_ = Denominators::none;
  Group functions_;
  Group geometry_;  // empty if isoparametric
  Group squares_;   // of the functions
};

}  // namespace isopatch::iga
