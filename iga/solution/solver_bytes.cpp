#include "iga/solution/solver_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;

// Of a matrix in blocks of nine numbers and a column: the triangle of single numbers with an index of 4 bytes
// that CHOLMOD gets, and rows and columns that MUMPS gets beside the values. UMFPACK gets the whole with
// indices of 8 bytes, and METIS takes several times that for ordering single rows.
constexpr double permuted_triangle = 9 * 12 / 76.0;
constexpr double entries_of_mumps = 9 * 16 / 76.0;
constexpr double whole_and_ordering = 24;

// Vectors of several load cases: three of every direction, and seven while it iterates with others.
double bytes_of_cases(const SizeForecast& size) {
  if (size.right_sides == 1) return 0;
  const double vectors = 3.0 * size.right_sides + 7.0 * std::min(10, size.right_sides);
  return sizeof(double) * vectors * static_cast<double>(size.unknowns) / size.processes;
}

}  // namespace

double fixed_bytes(Method method) {
  return method == Method::cholmod || method == Method::umfpack ? 10e6 : 25e6;  // MPI and PETSc start
}

std::string gigabytes(double bytes) {
  if (bytes < 5e7) return fmt::format("{:.2g} MB", bytes / 1e6);
  return bytes < 1e11 ? fmt::format("{:.2g} GB", bytes / 1e9) : fmt::format("{:.0f} GB", bytes / 1e9);
}

double direct_bytes(const SizeForecast& size, Method method) {
  const double entries = size.factor.entries / size.processes;
  const double common = fixed_bytes(method) + size.matrix_bytes + size.system_bytes;
  switch (method) {
    case Method::cholmod:
      return common + permuted_triangle * size.matrix_bytes + 10 * entries + 8 * size.factor.largest_front;
    case Method::mumps:
      return common + entries_of_mumps * size.matrix_bytes + 28 * entries;
    case Method::umfpack:
      return common + whole_and_ordering * size.matrix_bytes + 15 * entries;
    default:
      throw Error(ErrorCode::internal, "a method without factors has no bytes of factors");
  }
}

double jacobi_bytes(const SizeForecast& size) {
  return fixed_bytes(Method::cg) + size.matrix_bytes + size.system_bytes;
}

double multigrid_bytes(const SizeForecast& size, solvers::Operator form) {
  return fixed_bytes(Method::cg) + size.multigrid_bytes + bytes_of_cases(size) +
         (form == solvers::Operator::assembled ? size.matrix_bytes : 0);
}

}  // namespace isopatch::iga
