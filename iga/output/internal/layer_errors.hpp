#pragma once

#include "geometry/splines/grid.hpp"
#include "iga/spaces/elastic_field.hpp"
#include "iga/spaces/internal/element_numbers.hpp"

namespace isopatch::iga {

/// How far von Mises stress between the nodes of straight cells is from the solution's.
struct LayerErrors {
  /// For every layer of cells across each direction the largest error of those cells of it that are better
  /// for being halved along that direction, Pa; 0 if there are none.
  ElementNumbers layers;
  double largest_error = 0;                         ///< of all cells, Pa
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< of that cell, m
  double largest_stress = 0;                        ///< von Mises at the nodes, Pa
};

/// Estimates it from the stresses at the nodes of one patch's grid.
///
/// What is linear between nodes passes the solution for two reasons, which are added up. Von Mises stress is
/// a norm of the deviator s, and a norm is convex: at weights w_c of the corners the cell shows sum w_c |s_c|
/// where the norm of the interpolated deviator is |sum w_c s_c|. This part is taken at points of edges, faces
/// and the middle, and is all there is where stress is linear, however near it comes to zero. The other is
/// that stress is curved: |s''| h^2 / 8 for each direction, with s'' from the second differences within
/// elements; cells that are whole elements have none. Cells with a node where the map is folded are left out.
/// @param grid  both ends of the patch and of every element included
/// @cost  a second evaluation of the fields at the nodes; in parallel
LayerErrors layer_errors(const ElasticField& field, int patch, const geometry::GridParameters<3>& grid);

}  // namespace isopatch::iga
