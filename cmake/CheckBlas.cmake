# Warns if the system's BLAS is the unoptimised reference one: direct solvers are then several times slower.
# CHOLMOD, UMFPACK and PETSc all load libblas.so.3, so what that name resolves to decides.

find_library(ISOPATCH_BLAS_IN_USE NAMES libblas.so.3)
mark_as_advanced(ISOPATCH_BLAS_IN_USE)
if(ISOPATCH_BLAS_IN_USE)
  file(REAL_PATH "${ISOPATCH_BLAS_IN_USE}" isopatch_blas_file)
  if(isopatch_blas_file MATCHES "openblas|blis|mkl|atlas|flexiblas")
    message(STATUS "BLAS in use: ${isopatch_blas_file}")
  else()
    message(WARNING "The BLAS in use, ${isopatch_blas_file}, looks like the unoptimised reference BLAS: direct "
      "solvers will be several times slower. Install libopenblas-pthread-dev; if it is installed, choose it with "
      "'update-alternatives --config libblas.so.3-${CMAKE_LIBRARY_ARCHITECTURE}' (and liblapack.so.3-...).")
  endif()
endif()
