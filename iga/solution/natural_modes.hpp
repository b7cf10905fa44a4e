#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/base/progress.hpp"
#include "iga/post/elasticity_results.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::iga {

struct ModesOptions {
  int number = 10;            ///< lowest modes besides rigid motions, 1 .. 200
  int quadrature_points = 0;  ///< as ElasticityOptions
  bool count = true;          ///< whether a second factorization proves that none is missing
  double memory_limit = 0;    ///< bytes that the process may hold, 0 for what the machine has to spare
};

/// A natural mode of vibration: frequency and shape.
struct NaturalMode {
  double frequency = 0;  ///< Hz; 0 for a rigid motion
  bool is_rigid = false;
  /// Coefficients per patch, (3, control points), scaled to x.M x = 1 kg m^2: divided by m.
  std::vector<Eigen::Matrix3Xd> shape;
  double residual = 0;  ///< |K x - lambda M x| / |K x|, of a rigid motion beside the first mode's K x
};

struct NaturalModes {
  std::vector<NaturalMode> modes;  ///< rigid motions first, then by frequency
  double worst_orthogonality = 0;  ///< largest |x_i.M x_j - delta_ij| of all of them
  int rigid_motions = 0;           ///< that the supports leave, by geometry: as many modes are rigid
  double counted_to = 0;           ///< Hz; up to there the factors' inertia counts `counted` modes
  std::int64_t counted = 0;        ///< rigid ones among them; 0 without `count`
  std::vector<PhaseTime> timings;
};

/// The lowest natural frequencies and shapes of a part with its supports, which hold it at 0. Interfaces are
/// eliminated, those that do not match coupled by Nitsche's method; loads count for nothing.
///
/// Block Lanczos on (K + a M)^-1 M, with a > 0 only where the part can move as a whole, so that the matrix is
/// positive definite; full orthogonality in the mass keeps rigid motions out of the other shapes. Blocks are
/// larger than the number of copies that frequencies have, and the inertia of K - s M counts them once more:
/// a number of modes that is not the one found is an error, not a result.
///
/// @throws Error invalid_argument  a material without density, options out of range
/// @throws Error not_converged     modes that did not converge, or that the count says are missing
/// @throws Error out_of_memory     before anything is assembled: what factors and vectors would take
/// @throws Error as assembly and CHOLMOD do
/// @cost   one factorization, one more to count, and some 10 solutions of 8 right sides each
/// @source Golub, Underwood 1977; Gould 1985 (inertia)
NaturalModes natural_modes(const ElasticityProblem& problem, const ModesOptions& options = {},
                           const Progress& progress = {});

}  // namespace isopatch::iga
