#pragma once

#include <array>
#include <vector>

#include "geometry/splines/knot_vector.hpp"
#include "iga/internal/lanes.hpp"
#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {

/// Consecutive quadrature points at which the same functions live.
struct PointRun {
  int first;  ///< function
  int begin;  ///< point
  int end;
};

/// The functions of one direction at all quadrature points of a line, in one or several kinds: values and
/// derivatives, or products of these. The points are those of a table of elements, which need not be the
/// functions' own.
struct LineTable {
  int functions = 0;                       ///< at a point: degree + 1
  std::vector<int> first;                  ///< function at each point
  std::vector<std::vector<double>> kinds;  ///< [kind][point * functions + function]
  std::vector<PointRun> runs;              ///< of element e: run_start[e] .. run_start[e + 1] - 1
  std::vector<int> run_start;

  int points() const { return static_cast<int>(first.size()); }
  int kind_count() const { return static_cast<int>(kinds.size()); }
  FunctionTable at(const PointRun& run, int kind) const {
    return {kinds[static_cast<std::size_t>(kind)].data() + static_cast<std::ptrdiff_t>(run.begin) * functions,
            run.end - run.begin, functions};
  }
};

/// Values and derivatives of the elements' own functions.
LineTable line_table(const DirectionTable& elements);

/// Values and derivatives of the functions over `knots` at the points of `elements`. Where a point is a knot
/// of theirs, they are taken from its right.
LineTable line_table(const geometry::KnotVector& knots, const DirectionTable& elements);

/// The three products value * value, value * derivative, derivative * derivative of a line_table.
LineTable squares(const LineTable& table);

/// The functions at eight consecutive points of direction 1, as a matrix of lanes by functions.
struct LaneBand {
  int first = 0;              ///< function
  int functions = 0;          ///< that live at any of the eight points
  std::vector<Lanes> values;  ///< [function * kinds + kind], 0 at the points where a function does not live
};

/// All points of a line in bands of eight; the last band repeats the last point.
std::vector<LaneBand> lane_bands(const LineTable& table);

}  // namespace isopatch::iga
