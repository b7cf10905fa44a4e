#pragma once

// Private to the .cpp files of this folder: PETSc's handles with owners, its error codes as exceptions.

#include <petscksp.h>

#include <Eigen/Core>

#include <string_view>
#include <utility>

namespace isopatch::solvers::petsc {

/// Turns a PETSc error code into an exception that carries PETSc's own message.
/// @throws Error out_of_memory or internal, naming `action`
void check(PetscErrorCode code, std::string_view action);

/// Owner of a PETSc object.
template <class Object, PetscErrorCode (*Destroy)(Object*)>
class Owner {
 public:
  Owner() = default;
  ~Owner() {
    if (object_) Destroy(&object_);
  }
  Owner(Owner&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Owner& operator=(Owner&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  Object get() const { return object_; }
  /// Where PETSc's create functions put the object.
  Object* receive() { return &object_; }

 private:
  Object object_ = nullptr;
};

using Matrix = Owner<Mat, MatDestroy>;
using Vector = Owner<Vec, VecDestroy>;
using Krylov = Owner<KSP, KSPDestroy>;

/// A vector that uses the memory of an Eigen vector, which must outlive it.
Vector view(MPI_Comm communicator, const Eigen::VectorXd& values, int block_size);

}  // namespace isopatch::solvers::petsc
