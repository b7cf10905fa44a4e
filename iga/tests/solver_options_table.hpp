#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "iga/coupling/coupling_kind.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::iga::testing {

/// All that a study can ask for.
template <class Visit>
void for_all_options(Visit visit) {
  using solvers::Method, solvers::Operator, solvers::Preconditioner;
  for (const Method method :
       {Method::automatic, Method::cholmod, Method::mumps, Method::umfpack, Method::cg, Method::minres})
    for (const Preconditioner preconditioner : {Preconditioner::multigrid, Preconditioner::block_jacobi})
      for (const Operator form : {Operator::automatic, Operator::assembled, Operator::matrix_free}) {
        solvers::SolverOptions options;
        options.method = method;
        options.preconditioner = preconditioner;
        options.form = form;
        SCOPED_TRACE(fmt::format("{}, {}, {}", solvers::name(method), solvers::name(preconditioner),
                                 solvers::name(form)));
        visit(options);
      }
}

/// Whether method, coupling, preconditioner and operator can go together; written down once more, as a table.
inline bool is_possible(const solvers::SolverOptions& o, Coupling coupling) {
  using solvers::Method, solvers::Operator;
  const bool tied = coupling == Coupling::lagrange;
  const bool jacobi = o.preconditioner == solvers::Preconditioner::block_jacobi;
  switch (o.method) {
    case Method::automatic:
      return !(jacobi && o.form == Operator::matrix_free);
    case Method::cholmod:
      return !tied && !jacobi && o.form != Operator::matrix_free;
    case Method::mumps:
    case Method::umfpack:
      return !jacobi && o.form != Operator::matrix_free;
    case Method::cg:
      return !tied && !(jacobi && o.form == Operator::matrix_free);
    case Method::minres:
      return tied && !jacobi && o.form != Operator::assembled;
  }
  return false;
}

}  // namespace isopatch::iga::testing
