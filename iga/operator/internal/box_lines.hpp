#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "iga/operator/internal/box_contraction.hpp"
#include "iga/operator/internal/line_table.hpp"
#include "iga/operator/internal/point_forms.hpp"

namespace isopatch::iga {

/// The fields of a group at the points: their number, and whether values are among their vectors.
struct FieldLayout {
  BoxContraction& contraction;
  int fields;
  bool values;

  // From a field on.
  LineFields from(int field) const {
    const Lanes* const first = contraction.point(0) + field;
    const int skipped = values ? fields : 0;
    return {values ? first : nullptr,
            {first + skipped, first + skipped + 2 * fields, first + skipped + fields},
            skipped + 3 * fields};
  }
};

/// Fields are in the order displacement, places, weight, whichever there are.
inline PointLine lines_of(const FieldLayout& own, const FieldLayout& geometry, bool displaced,
                          bool together) {
  PointLine line{};
  if (displaced) line.displacement = own.from(0);
  if (own.values) line.function_weight = own.from(own.fields - 1);
  line.places = together ? own.from(displaced ? 3 : 0) : geometry.from(0);
  if (together) line.geometry_weight = line.function_weight;
  if (geometry.values) line.geometry_weight = geometry.from(geometry.fields - 1);
  return line;
}

/// Adds sum_kinds band * plane, summed over lanes, for C numbers per function.
/// @param fields  of each kind in the plane, of which the first C are meant
template <int C, int Kinds>
void gather(const LaneBand& band, const Lanes* plane, int fields, const double* weights, double* target) {
  for (int i = 0; i < band.functions; ++i) {
    const Lanes* const at = &band.values[static_cast<std::size_t>(i * Kinds)];
    double weight = 1;
    if (weights) weight = Kinds == 3 ? weights[i] * weights[i] : weights[i];
    for (int c = 0; c < C; ++c) {
      Lanes total = at[0] * plane[c];
      for (int kind = 1; kind < Kinds; ++kind) total += at[kind] * plane[kind * fields + c];
      target[C * i + c] += weight * sum(total);
    }
  }
}

/// Into the numbers of the functions of a box.
template <int C, int Kinds>
void gather_all(const std::array<int, 2>& sizes, const BoxFunctions& box, const LaneBand& band,
                const Eigen::VectorXd& weights, BoxContraction& contraction, double* target, int fields = C,
                int first_field = 0) {
  double* const first = target + static_cast<std::ptrdiff_t>(C) * (band.first - box.first[0]);
  const std::ptrdiff_t line = static_cast<std::ptrdiff_t>(C) * box.sizes[0];
  for (int k = 0; k < contraction.planes(); ++k)
    for (int r = 0; r < contraction.rows(); ++r) {
      const std::ptrdiff_t node =
          band.first + static_cast<std::ptrdiff_t>(sizes[0]) *
                           (contraction.first_row() + r +
                            static_cast<std::ptrdiff_t>(sizes[1]) * (contraction.first_plane() + k));
      gather<C, Kinds>(band, contraction.plane(r, k) + first_field, fields,
                       weights.size() > 0 ? weights.data() + node : nullptr,
                       first + line * (r + static_cast<std::ptrdiff_t>(box.sizes[1]) * k));
    }
}

}  // namespace isopatch::iga
