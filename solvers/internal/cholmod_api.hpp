#pragma once

#include <cholmod.h>

#include <cstdint>
#include <limits>

namespace isopatch::solvers {

/// CHOLMOD's functions under one name for 32-bit and 64-bit indices.
template <class Index>
struct CholmodApi;

template <>
struct CholmodApi<std::int32_t> {
  static constexpr int itype = CHOLMOD_INT;
  static constexpr auto start = cholmod_start;
  static constexpr auto finish = cholmod_finish;
  static constexpr auto analyze = cholmod_analyze;
  static constexpr auto factorize = cholmod_factorize;
  static constexpr auto solve = cholmod_solve;
  static constexpr auto free_factor = cholmod_free_factor;
  static constexpr auto free_dense = cholmod_free_dense;
};

template <>
struct CholmodApi<std::int64_t> {
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  static constexpr int itype = CHOLMOD_LONG;
  static constexpr auto start = cholmod_l_start;
  static constexpr auto finish = cholmod_l_finish;
  static constexpr auto analyze = cholmod_l_analyze;
  static constexpr auto factorize = cholmod_l_factorize;
  static constexpr auto solve = cholmod_l_solve;
  static constexpr auto free_factor = cholmod_l_free_factor;
  static constexpr auto free_dense = cholmod_l_free_dense;
};

/// CHOLMOD's workspace and parameters; silent.
template <class Index>
class CholmodWorkspace {
 public:
  CholmodWorkspace() {
    CholmodApi<Index>::start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~CholmodWorkspace() { CholmodApi<Index>::finish(&common_); }
  CholmodWorkspace(const CholmodWorkspace&) = delete;
  CholmodWorkspace& operator=(const CholmodWorkspace&) = delete;
  cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

 private:
  cholmod_common common_ = {};
};

/// A factor that frees itself; its workspace must outlive it.
template <class Index>
class CholmodFactor {
 public:
  CholmodFactor(cholmod_factor* factor, CholmodWorkspace<Index>& workspace)
      : factor_(factor), workspace_(workspace) {}
  ~CholmodFactor() { CholmodApi<Index>::free_factor(&factor_, workspace_.get()); }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;
  cholmod_factor* get() const { return factor_; }
  cholmod_factor* operator->() const { return factor_; }

 private:
  cholmod_factor* factor_;
  CholmodWorkspace<Index>& workspace_;
};

/// A lower triangle by columns that CHOLMOD reads where it lies. `values` may be null (pattern only).
template <class Index>
cholmod_sparse lower_triangle_view(std::size_t rows, Index* column_start, Index* row_indices, double* values,
                                   bool sorted) {
  cholmod_sparse view = {};
  view.nrow = view.ncol = rows;
  view.nzmax = static_cast<std::size_t>(column_start[rows]);
  view.p = column_start;
  view.i = row_indices;
  view.x = values;
  view.stype = -1;
  view.itype = CholmodApi<Index>::itype;
  view.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = sorted;
  view.packed = true;
  return view;
}

}  // namespace isopatch::solvers
