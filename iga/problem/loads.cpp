#include "iga/problem/loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/material/internal/point_fields.hpp"
#include "iga/problem/internal/face_quadrature.hpp"
#include "iga/spaces/internal/element_batches.hpp"
#include "iga/spaces/internal/element_tensors.hpp"
#include "iga/spaces/node_values.hpp"

namespace isopatch::iga {

using geometry::PatchFace;

SurfaceLoad constant_traction(std::string name, std::vector<PatchFace> faces, const Eigen::Vector3d& traction,
                              const Region& region) {
  return {std::move(name), std::move(faces),
          [traction](const Eigen::Vector3d&, const Eigen::Vector3d&) { return traction; }, region};
}

SurfaceLoad pressure_load(std::string name, std::vector<PatchFace> faces, double pressure,
                          const Region& region) {
  return {std::move(name), std::move(faces),
          [pressure](const Eigen::Vector3d&, const Eigen::Vector3d& normal) {
            return Eigen::Vector3d(-pressure * normal);
          },
          region};
}

SurfaceLoad total_force(std::string name, std::vector<PatchFace> faces, const Eigen::Vector3d& force,
                        const Discretization& d, const Region& region) {
  // With the rule that the load itself is integrated with, the force adds up to the last digits.
  const double area = area_of(d.patches, faces, region);
  if (!(area > 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': a force needs faces with an area to act on", name));
  return constant_traction(std::move(name), std::move(faces), force / area, region);
}

double area_of(const std::vector<geometry::NurbsVolume>& patches, const std::vector<PatchFace>& faces,
               const Region& region) {
  double area = 0;
  for (const FacePoint& point : face_points(patches, faces, region)) area += point.area;
  return area;
}

std::vector<VolumeLoad> gravity(const std::string& name, const std::vector<PatchId>& patches,
                                const Eigen::Vector3d& acceleration, const std::vector<Material>& materials) {
  std::vector<VolumeLoad> loads;
  for (const PatchId patch : patches) {
    const Material& material = materials.at(static_cast<std::size_t>(patch.value));
    if (!(material.density > 0))
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("'{}': patch {} has no density; gravity and acceleration need one in its material",
                      name, patch.value));
    const Eigen::Vector3d force = material.density * acceleration;
    loads.push_back({name, {patch}, [force](const Eigen::Vector3d&) { return force; }});
  }
  return loads;
}

Eigen::Matrix3Xd face_load(
    const geometry::NurbsVolume& patch, geometry::Side side,
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>& traction,
    const Region& region) {
  const FaceQuadrature quadrature(patch, side, region);
  const geometry::NurbsSurface& surface = quadrature.surface();
  Eigen::Matrix3Xd load = Eigen::Matrix3Xd::Zero(3, surface.size());
  quadrature.for_each([&](const FacePoint& point, const DirectionTable::Element& u, Eigen::Index qu,
                          const DirectionTable::Element& v, Eigen::Index qv) {
    const Eigen::Vector3d weighted = point.area * traction(point.place, point.normal);
    double total = 0;
    for (Eigen::Index j = 0; j < v.values.cols(); ++j)
      for (Eigen::Index i = 0; i < u.values.cols(); ++i)
        total += u.values(qu, i) * v.values(qv, j) *
                 surface.weights()[u.first + i + surface.size(0) * (v.first + j)];
    for (Eigen::Index j = 0; j < v.values.cols(); ++j) {
      for (Eigen::Index i = 0; i < u.values.cols(); ++i) {
        const Eigen::Index index = u.first + i + surface.size(0) * (v.first + j);
        load.col(index) += weighted * (u.values(qu, i) * v.values(qv, j) * surface.weights()[index] / total);
      }
    }
  });
  return load;
}

namespace {

void add_surface_load(const ElasticityProblem& problem, const SurfaceLoad& surface_load,
                      Eigen::Matrix3Xd& load) {
  const Discretization& d = problem.discretization;
  const auto& boundary = d.model.boundary_faces();
  for (const PatchFace face : surface_load.faces) {
    if (std::find(boundary.begin(), boundary.end(), face) == boundary.end())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("'{}': face {} is not on the boundary of the model", surface_load.name,
                              d.model.label(face)));
    const auto p = static_cast<std::size_t>(face.patch.value);
    const Eigen::Matrix3Xd on_face =
        face_load(d.patches[p], face.side, surface_load.traction, surface_load.region);
    if (!on_face.allFinite())
      throw Error(ErrorCode::invalid_argument, fmt::format("'{}': the load on face {} is not finite",
                                                           surface_load.name, d.model.label(face)));
    const std::vector<int> indices = geometry::face_control_points(d.patches[p].sizes(), face.side);
    for (std::size_t i = 0; i < indices.size(); ++i)
      load.col(d.first_node[p] + indices[i]) += on_face.col(static_cast<Eigen::Index>(i));
  }
}

void add_point_load(const Discretization& d, const PointLoad& point_load, Eigen::Matrix3Xd& load) {
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  for (const PatchPoint& point : point_load.points) {
    if (point.patch.value < 0 || point.patch.value >= d.patch_count() || !point_load.force.allFinite())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("'{}': a point load needs a finite force and points in patches 0 to {}",
                              point_load.name, d.patch_count() - 1));
    const auto p = static_cast<std::size_t>(point.patch.value);
    for (const NodeValue& at : node_values(spaces[p], point.parameter))
      load.col(d.first_node[p] + at.node) += point.weight * at.value * point_load.force;
  }
}

// Forces of three components for each function of an element.
using ElementLoad = std::vector<double>;

// One patch under a force per volume, element by element: the force at the points, then the sums of it times
// each function N = w B / W.
class PatchWeight {
 public:
  PatchWeight(const Discretization& d, int patch, const VolumeLoad& load, const GaussPoints& points)
      : index_(patch),
        patch_(d.patches[static_cast<std::size_t>(patch)]),
        load_(load),
        tensors_(patch_, gauss_rules(points)) {}

  const ElementTensors& tensors() const { return tensors_; }

  void compute(std::int64_t element, TensorBuffers<4>& buffers, ElementLoad& out) const {
    gather(tensors_, element, patch_.control_points(), patch_.weights(), buffers.coefficients);
    tensors_.gradients(element, buffers);
    tensors_.for_each_point(element, [&](Eigen::Index point, double weight) {
      const auto q = static_cast<std::size_t>(point);
      const RationalPoint place = rational_point(buffers, q);
      const double jacobian = place.derivatives.determinant();
      const Eigen::Vector3d force = weight * jacobian * load_.force(place.value);
      if (!force.allFinite())
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("'{}': the force in patch {} is not finite", load_.name, index_));
      buffers.at[0][q].head<3>() = force.array() / buffers.at[0][q][3];
    });
    tensors_.test_with_values(element, buffers);
    out.resize(static_cast<std::size_t>(3 * tensors_.function_count()));
    tensors_.for_each_function(element, [&](Eigen::Index a, Eigen::Index i) {
      Eigen::Map<Eigen::Vector3d>{&out[static_cast<std::size_t>(3 * a)]} =
          patch_.weights()[i] * buffers.coefficients[static_cast<std::size_t>(a)].head<3>().matrix();
    });
  }

 private:
  int index_;
  const geometry::NurbsVolume& patch_;
  const VolumeLoad& load_;
  ElementTensors tensors_;
};

void add_volume_load(const Discretization& d, const VolumeLoad& volume_load, int points,
                     Eigen::Matrix3Xd& load) {
  constexpr std::int64_t elements_per_batch = 8192;
  for (const PatchId patch : volume_load.patches) {
    if (patch.value < 0 || patch.value >= d.patch_count())
      throw Error(ErrorCode::invalid_argument, fmt::format("'{}': there is no patch {}; the model has {}",
                                                           volume_load.name, patch.value, d.patch_count()));
    const PatchWeight weight(d, patch.value, volume_load, d.points_of(patch.value, points));
    double* const sums = load.data() + 3 * d.first_node[static_cast<std::size_t>(patch.value)];
    in_batches<TensorBuffers<4>, ElementLoad>(
        weight.tensors().element_count(), elements_per_batch,
        [&](std::int64_t element, TensorBuffers<4>& buffers, ElementLoad& out) {
          weight.compute(element, buffers, out);
        },
        [&](std::int64_t element, std::span<const ElementLoad> loads) {
          for (const ElementLoad& of_element : loads)
            weight.tensors().for_each_function(element++, [&](Eigen::Index a, Eigen::Index i) {
              Eigen::Map<Eigen::Vector3d>(sums + 3 * i) +=
                  Eigen::Map<const Eigen::Vector3d>(&of_element[static_cast<std::size_t>(3 * a)]);
            });
        });
  }
}

}  // namespace

Eigen::Matrix3Xd load_vector(const ElasticityProblem& problem, int points) {
  Eigen::Matrix3Xd load = Eigen::Matrix3Xd::Zero(3, problem.discretization.node_count());
  for (const SurfaceLoad& surface_load : problem.surface_loads) add_surface_load(problem, surface_load, load);
  for (const VolumeLoad& volume_load : problem.volume_loads)
    add_volume_load(problem.discretization, volume_load, points, load);
  for (const PointLoad& point_load : problem.point_loads)
    add_point_load(problem.discretization, point_load, load);
  return load;
}

Eigen::Vector3d total_force(const VolumeLoad& load, const Discretization& discretization, int points) {
  Eigen::Matrix3Xd at_nodes = Eigen::Matrix3Xd::Zero(3, discretization.node_count());
  add_volume_load(discretization, load, points, at_nodes);
  return at_nodes.rowwise().sum();
}

}  // namespace isopatch::iga
