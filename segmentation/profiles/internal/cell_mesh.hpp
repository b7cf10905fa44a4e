#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace isopatch::segmentation::planar {

/// Where cells meet: a vertex of the profile, a cut of one of its edges, or a point inside a region.
struct Node {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  bool given = false;  ///< a vertex of the profile
  int curve = -1;      ///< the edge that a cut lies on
  double at = 0;       ///< its parameter there

  bool is_cut() const { return curve >= 0; }
  bool is_inside() const { return !given && curve < 0; }
};

/// A side of a cell, counterclockwise: a chord, or a piece of a curve, which may be run backwards.
struct Side {
  int from = -1, to = -1;
  int curve = -1;
  double low = 0, high = 1;  ///< low < high; `from` is at low unless reversed
  bool reversed = false;
};
inline Side turned(const Side& side) {
  return {side.to, side.from, side.curve, side.low, side.high, !side.reversed};
}

/// A triangle or quadrilateral.
struct Cell {
  int region = -1;
  int count = 0;  ///< of sides: 3 or 4
  std::array<Side, 4> sides;
};

/// Cells that cover the wanted regions. Nodes that none uses are allowed.
struct CellMesh {
  std::vector<Node> nodes;
  std::vector<Cell> cells;
};

/// Equal for the two uses of one side but for the direction.
using SideKey = std::tuple<int, int, int, bool>;
inline SideKey key_of(const Side& side) {
  return {side.from, side.to, side.curve, side.curve >= 0 && side.reversed};
}
inline SideKey key_across(const Side& side) {
  return {side.to, side.from, side.curve, side.curve >= 0 && !side.reversed};
}

}  // namespace isopatch::segmentation::planar
