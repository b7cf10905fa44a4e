#include "iga/operator/internal/point_forms.hpp"

namespace isopatch::iga {
namespace {

using enum Denominators;

constexpr bool rational_functions(Denominators d) {
  return d == functions || d == both || d == shared;
}

constexpr bool rational_geometry(Denominators d) {
  return d == geometry || d == both || d == shared;
}

struct Map {
  Lanes cofactors[3][3];  // [direction][coordinate]: the inverse times the determinant
  Lanes determinant;
};

// Cofactors of dX - x dWg, of which rational geometry needs no division.
template <Denominators denominators>
inline __attribute__((always_inline)) Map map_at(const PointLine& line, int q, const Lanes& inverse_weight) {
  Lanes j[3][3];  // [coordinate][direction]
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c) j[c][d] = line.places.derivatives[d][q * line.places.step + c];
  if constexpr (rational_geometry(denominators)) {
    Lanes ratio[3];
    for (int d = 0; d < 3; ++d)
      ratio[d] = line.geometry_weight.derivatives[d][q * line.geometry_weight.step] * inverse_weight;
    for (int c = 0; c < 3; ++c) {
      const Lanes x = line.places.values[q * line.places.step + c];
      for (int d = 0; d < 3; ++d) j[c][d] -= x * ratio[d];
    }
  }
  Map map;
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c) {
      const int d1 = (d + 1) % 3, d2 = (d + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      map.cofactors[d][c] = j[c1][d1] * j[c2][d2] - j[c1][d2] * j[c2][d1];
    }
  map.determinant =
      j[0][0] * map.cofactors[0][0] + j[1][0] * map.cofactors[0][1] + j[2][0] * map.cofactors[0][2];
  return map;
}

struct PointWeights {
  Lanes inverse_geometry;   // 1 / Wg
  Lanes inverse_functions;  // 1 / Wf
};

template <Denominators denominators>
inline __attribute__((always_inline)) PointWeights weights_at(const PointLine& line, int q) {
  PointWeights weights{};
  if constexpr (rational_geometry(denominators))
    weights.inverse_geometry = 1.0 / line.geometry_weight.values[q * line.geometry_weight.step];
  if constexpr (denominators == shared)
    weights.inverse_functions = weights.inverse_geometry;
  else if constexpr (rational_functions(denominators))
    weights.inverse_functions = 1.0 / line.function_weight.values[q * line.function_weight.step];
  return weights;
}

// Quadrature weight over (D Wg Wf^2), which is common to all entries.
template <Denominators denominators>
inline __attribute__((always_inline)) Lanes scale_at(const PointLine& line, int q, const Lanes& determinant,
                                                     const PointWeights& weights) {
  Lanes scale = *line.weights1 * (line.weights2[q] * line.weight3) / determinant;
  if constexpr (rational_geometry(denominators)) scale *= weights.inverse_geometry;
  if constexpr (rational_functions(denominators))
    scale *= weights.inverse_functions * weights.inverse_functions;
  return scale;
}

inline __attribute__((always_inline)) void keep_smaller(Lanes& smallest, const Lanes& value) {
  smallest = value < smallest ? value : smallest;
}

}  // namespace

namespace {

// The map, and D.
template <Denominators denominators>
inline __attribute__((always_inline)) Lanes map_of_forces(const PointLine& line, int q, PointMap& result) {
  const PointWeights weights = weights_at<denominators>(line, q);
  const Map map = map_at<denominators>(line, q, weights.inverse_geometry);
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c) result.cofactors[d][c] = map.cofactors[d][c];
  result.scale = scale_at<denominators>(line, q, map.determinant, weights);
  if constexpr (rational_functions(denominators))
    for (int d = 0; d < 3; ++d)
      result.ratio[d] =
          line.function_weight.derivatives[d][q * line.function_weight.step] * weights.inverse_functions;
  return map.determinant;
}

template <bool rational>
inline __attribute__((always_inline)) void force_at(const LineFields& displacement, int q, int which,
                                                    int count, const PointMap& map, const Material& material,
                                                    Lanes* out) {
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(q) * displacement.step + 3 * which;
  Lanes h[3][3];  // [component][coordinate]: displacement gradient times D Wf / Wg
  for (int c = 0; c < 3; ++c) {
    Lanes g[3];
    for (int d = 0; d < 3; ++d) g[d] = displacement.derivatives[d][first + c];
    if constexpr (rational) {
      const Lanes u = displacement.values[first + c];
      for (int d = 0; d < 3; ++d) g[d] -= u * map.ratio[d];
    }
    for (int k = 0; k < 3; ++k)
      h[c][k] = g[0] * map.cofactors[0][k] + g[1] * map.cofactors[1][k] + g[2] * map.cofactors[2][k];
  }
  const Lanes shear = material.mu * map.scale;
  const Lanes pressure = (material.lambda * map.scale) * (h[0][0] + h[1][1] + h[2][2]);
  Lanes stress[3][3];
  for (int c = 0; c < 3; ++c) {
    stress[c][c] = (shear + shear) * h[c][c] + pressure;
    for (int k = 0; k < c; ++k) stress[c][k] = stress[k][c] = shear * (h[c][k] + h[k][c]);
  }
  constexpr int order[3] = {0, 2, 1};  // vectors of direction 1, 3, 2
  const int fields = 3 * count, skipped = rational ? fields : 0;
  Lanes* const to = out + static_cast<std::ptrdiff_t>(q) * (3 * fields + skipped) + 3 * which;
  for (int c = 0; c < 3; ++c) {
    Lanes value{};
    for (int d = 0; d < 3; ++d) {
      const Lanes t = stress[c][0] * map.cofactors[d][0] + stress[c][1] * map.cofactors[d][1] +
                      stress[c][2] * map.cofactors[d][2];
      to[skipped + fields * order[d] + c] = t;
      if constexpr (rational) value -= t * map.ratio[d];
    }
    if constexpr (rational) to[c] = value;
  }
}

}  // namespace

template <Denominators denominators>
Lanes forces_at_points(const PointLine& line, const Material& material, Lanes* out) {
  Lanes smallest = Lanes{} + 1e300;
  for (int q = 0; q < line.points; ++q) {
    PointMap map;
    keep_smaller(smallest, map_of_forces<denominators>(line, q, map));
    force_at<rational_functions(denominators)>(line.displacement, q, 0, 1, map, material, out);
  }
  return smallest;
}

template <Denominators denominators>
Lanes maps_at_points(const PointLine& line, PointMap* maps) {
  Lanes smallest = Lanes{} + 1e300;
  for (int q = 0; q < line.points; ++q) keep_smaller(smallest, map_of_forces<denominators>(line, q, maps[q]));
  return smallest;
}

template <bool rational>
void forces_with_maps(const LineFields& displacement, int count, const PointMap* maps, int points,
                      const Material& material, Lanes* out) {
  for (int q = 0; q < points; ++q)
    for (int i = 0; i < count; ++i) force_at<rational>(displacement, q, i, count, maps[q], material, out);
}

template <Denominators denominators>
Lanes squares_at_points(const PointLine& line, Lanes* out) {
  constexpr bool rational = rational_functions(denominators);
  constexpr int entries[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  Lanes smallest = Lanes{} + 1e300;
  for (int q = 0; q < line.points; ++q) {
    const PointWeights weights = weights_at<denominators>(line, q);
    const Map map = map_at<denominators>(line, q, weights.inverse_geometry);
    keep_smaller(smallest, map.determinant);
    const Lanes scale = scale_at<denominators>(line, q, map.determinant, weights);
    Lanes factors[4][3] = {};  // of B and its three derivatives, in each coordinate
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) {
        factors[d + 1][c] = map.cofactors[d][c];
        if constexpr (rational)
          factors[0][c] -= map.cofactors[d][c] * weights.inverse_functions *
                           line.function_weight.derivatives[d][q * line.function_weight.step];
      }
    for (int i = rational ? 0 : 1; i <= 3; ++i)
      for (int j = i; j <= 3; ++j)
        for (const auto& [c, k] : entries) {
          Lanes product = factors[i][c] * factors[j][k];
          if (i != j) product += factors[j][c] * factors[i][k];
          *out++ = scale * product;
        }
  }
  return smallest;
}

template Lanes forces_at_points<none>(const PointLine&, const Material&, Lanes*);
template Lanes forces_at_points<geometry>(const PointLine&, const Material&, Lanes*);
template Lanes forces_at_points<functions>(const PointLine&, const Material&, Lanes*);
template Lanes forces_at_points<both>(const PointLine&, const Material&, Lanes*);
template Lanes forces_at_points<shared>(const PointLine&, const Material&, Lanes*);
template Lanes maps_at_points<none>(const PointLine&, PointMap*);
template Lanes maps_at_points<geometry>(const PointLine&, PointMap*);
template Lanes maps_at_points<functions>(const PointLine&, PointMap*);
template Lanes maps_at_points<both>(const PointLine&, PointMap*);
template Lanes maps_at_points<shared>(const PointLine&, PointMap*);
template void forces_with_maps<false>(const LineFields&, int, const PointMap*, int, const Material&, Lanes*);
template void forces_with_maps<true>(const LineFields&, int, const PointMap*, int, const Material&, Lanes*);
template Lanes squares_at_points<none>(const PointLine&, Lanes*);
template Lanes squares_at_points<geometry>(const PointLine&, Lanes*);
template Lanes squares_at_points<functions>(const PointLine&, Lanes*);
template Lanes squares_at_points<both>(const PointLine&, Lanes*);
template Lanes squares_at_points<shared>(const PointLine&, Lanes*);

}  // namespace isopatch::iga
