#pragma once

#include <string>

#include "iga/solution/size_forecast.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga {

/// Bytes that a way to solve takes at its peak beyond what is held before, of the process with most of them:
/// assembly, matrix, its copies, factors or vectors. Calibrated by measured runs (solvers/README.md, "What a
/// factor takes"), and rather above than below them.
double direct_bytes(const SizeForecast& size, solvers::Method method);
double jacobi_bytes(const SizeForecast& size);
double multigrid_bytes(const SizeForecast& size, solvers::Operator form);

/// Bytes that do not depend on the size: those of libraries that start.
double fixed_bytes(solvers::Method method);

/// Two digits or more, and no power of ten: "3.2 MB", "0.82 GB", "203 GB".
std::string gigabytes(double bytes);

}  // namespace isopatch::iga
