#include "iga/post/internal_forces.hpp"

#include "iga/material/internal/point_fields.hpp"
#include "iga/operator/internal/highest_modes.hpp"
#include "iga/post/results.hpp"
#include "iga/spaces/internal/element_batches.hpp"
#include "iga/spaces/internal/element_tensors.hpp"
#include "iga/spaces/internal/folded_patch.hpp"

namespace isopatch::iga {
namespace {

// Elements whose forces are kept until they are added up: 13 MB at degree 3.
constexpr std::int64_t elements_per_batch = 8192;

struct Scratch {
  TensorBuffers<8> fields;
  TensorBuffers<4> test;
  PointStresses stresses, modes;
  Eigen::VectorXd measures;
};

// The largest of an element's points and where it is.
struct Largest {
  double value = -1;
  Eigen::Index point = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();

  void take(double other, Eigen::Index at, const Eigen::Vector3d& where) {
    if (is_larger(other, value)) *this = {other, at, where};
  }
};

struct ElementForces {
  std::vector<double> forces;  // three of each function
  double energy = 0;
  double thermal_work = 0;
  Largest von_mises, strain;
  StressPeaks peaks;
  std::int64_t folded = 0;
  Largest worst = {-2, 0, Eigen::Vector3d::Zero()};  // minus the scaled Jacobian
  UnresolvedEnergy modes;
};

class PatchForces {
 public:
  PatchForces(const Discretization& d, int patch, const Material& material, const ThermalStrain& thermal,
              const Eigen::Matrix3Xd& displacement, const GaussPoints& points)
      : d_(d),
        index_(patch),
        patch_(d.patches[static_cast<std::size_t>(patch)]),
        material_(material),
        thermal_(thermal),
        displacement_(displacement.data() + 3 * d.first_node[static_cast<std::size_t>(patch)]),
        tensors_(patch_, gauss_rules(points)),
        modes_(points, {patch_.degree(0), patch_.degree(1), patch_.degree(2)}) {}

  const ElementTensors& tensors() const { return tensors_; }

  void compute(std::int64_t element, Scratch& scratch, ElementForces& out) const {
    gather(tensors_, element, patch_, displacement_, scratch.fields.coefficients);
    tensors_.gradients(element, scratch.fields);
    for (auto& at : scratch.test.at) at.resize(static_cast<std::size_t>(tensors_.point_count()));
    out.energy = out.thermal_work = 0;
    out.von_mises = out.strain = {};
    out.peaks = {};
    out.folded = 0;
    out.worst = {-2, 0, Eigen::Vector3d::Zero()};
    scratch.stresses.resize(6, tensors_.point_count());
    scratch.measures.resize(tensors_.point_count());
    tensors_.for_each_point(
        element, [&](Eigen::Index q, double weight) { at_point(element, q, weight, scratch, out); });
    out.modes = modes_.energies(scratch.stresses, scratch.measures, material_, scratch.modes);
    tensors_.test_with_gradients(element, scratch.test);
    out.forces.resize(static_cast<std::size_t>(3 * tensors_.function_count()));
    tensors_.for_each_function(element, [&](Eigen::Index a, Eigen::Index i) {
      Eigen::Map<Eigen::Vector3d>(&out.forces[static_cast<std::size_t>(3 * a)]) =
          patch_.weights()[i] * scratch.test.coefficients[static_cast<std::size_t>(a)].head<3>().matrix();
    });
  }

 private:
  // Stress, energy, and what the functions N = w B / W and their gradients are multiplied by: with the stress
  // on the unit cube T, sum over k of T_k dN/dk = w (sum over k of T_k / W dB/dk - B sum over k of T_k / W
  // W_k / W).
  void at_point(std::int64_t element, Eigen::Index point, double weight, Scratch& scratch,
                ElementForces& out) const {
    const auto q = static_cast<std::size_t>(point);
    const RationalPoint place = rational_point(scratch.fields, q);
    const double jacobian = place.derivatives.determinant();
    if (!(jacobian > 0))
      refuse_folded(index_, patch_, d_.model.was_reversed(PatchId(index_)),
                    tensors_.parameter(element, point));
    const Eigen::Matrix3d inverse = place.derivatives.inverse();
    const Eigen::Matrix3d gradient = rational_point(scratch.fields, q, 4).derivatives * inverse;
    const double thermal = thermal_.at(place.value);
    const Eigen::Matrix3d sigma = stress_of_gradient(gradient, material_, thermal);
    const double measure = weight * jacobian;
    const double thermal_work = -0.5 * measure * sigma.trace() * thermal;
    out.energy += 0.5 * measure * sigma.cwiseProduct(gradient).sum() + thermal_work;
    out.thermal_work += thermal_work;
    const auto& [value, du, dv, dw] = scratch.fields.at;
    const double denominator = 1 / value[q][3];
    const Eigen::Matrix3d on_cube = (measure * denominator) * sigma * inverse.transpose();
    const Eigen::Vector3d rate = denominator * Eigen::Vector3d(du[q][3], dv[q][3], dw[q][3]);
    scratch.test.at[0][q] << (-on_cube * rate).array(), 0.0;
    for (int k = 0; k < 3; ++k)
      scratch.test.at[static_cast<std::size_t>(k + 1)][q] << on_cube.col(k).array(), 0.0;
    scratch.measures[point] = measure;
    scratch.stresses.col(point) << sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(0, 1), sigma(1, 2),
        sigma(2, 0);
    double scaled = 0;
    if (map_state(place.derivatives, scaled) != MapState::sound) {
      ++out.folded;
      out.worst.take(-scaled, point, place.value);
      return;
    }
    const double equivalent = von_mises(sigma);
    require_finite(equivalent, index_, place.value);
    out.von_mises.take(equivalent, point, place.value);
    iga::take(
        StressPoint{sigma, equivalent, material_.yield},
        [&]() -> Extremum {
          return {0, place.value, index_, tensors_.parameter(element, point)};
        },
        out.peaks);
    out.strain.take((0.5 * (gradient + gradient.transpose())).norm(), point, place.value);
  }

  const Discretization& d_;
  int index_;
  const geometry::NurbsVolume& patch_;
  const Material& material_;
  ThermalStrain thermal_;
  const double* displacement_;
  ElementTensors tensors_;
  HighestModes modes_;
};

// The elements of a part, which follow each other: direction 3 is the slowest.
struct ElementRange {
  std::int64_t first;
  std::int64_t count;
};

ElementRange elements_of(const Discretization& d, const PatchLayers& part) {
  const geometry::NurbsVolume& patch = d.patches[static_cast<std::size_t>(part.patch)];
  const std::int64_t layer = std::int64_t{patch.knots(0).element_count()} * patch.knots(1).element_count();
  return {layer * part.first_layer, layer * (part.last_layer - part.first_layer)};
}

}  // namespace

InternalForces internal_forces(const Discretization& d, const std::vector<Material>& materials,
                               const Eigen::Matrix3Xd& displacement, const std::vector<PatchLayers>& parts,
                               int points, const Progress& progress,
                               const std::vector<ThermalStrain>& thermal) {
  InternalForces result;
  result.forces = Eigen::Matrix3Xd::Zero(3, d.node_count());
  result.max_von_mises.value = result.max_strain.value = -1;
  std::int64_t total = 0, done = 0;
  for (const PatchLayers& part : parts) total += elements_of(d, part).count;
  for (const PatchLayers& part : parts) {
    const int p = part.patch;
    const auto patch = static_cast<std::size_t>(p);
    const PatchForces of_patch(d, p, materials[patch], thermal.empty() ? ThermalStrain{} : thermal[patch],
                               displacement, d.points_of(p, points));
    double* const forces = result.forces.data() + 3 * d.first_node[patch];
    const ElementRange range = elements_of(d, part);
    in_batches<Scratch, ElementForces>(
        range.count, elements_per_batch,
        [&](std::int64_t element, Scratch& scratch, ElementForces& out) {
          of_patch.compute(range.first + element, scratch, out);
        },
        [&](std::int64_t first, std::span<const ElementForces> elements) {
          for (const ElementForces& element : elements) {
            result.energy += element.energy;
            result.thermal_work += element.thermal_work;
            of_patch.tensors().for_each_function(range.first + first, [&](Eigen::Index a, Eigen::Index i) {
              Eigen::Map<Eigen::Vector3d>(forces + 3 * i) +=
                  Eigen::Map<const Eigen::Vector3d>(&element.forces[static_cast<std::size_t>(3 * a)]);
            });
            const auto take = [&](const Largest& found, Extremum& so_far) {
              if (is_larger(found.value, so_far.value))
                so_far = {found.value, found.place, p,
                          of_patch.tensors().parameter(range.first + first, found.point)};
            };
            take(element.von_mises, result.max_von_mises);
            take(element.strain, result.max_strain);
            take(element.worst, result.left_out.worst);
            result.peaks = together(result.peaks, element.peaks);
            result.left_out.folded += element.folded;
            result.unresolved += element.modes;
            ++first;
          }
          done += static_cast<std::int64_t>(elements.size());
          progress("stresses", static_cast<double>(done) / static_cast<double>(total));
        });
  }
  return result;
}

InternalForces internal_forces(const Discretization& d, const std::vector<Material>& materials,
                               const Eigen::Matrix3Xd& displacement, int points, const Progress& progress) {
  return internal_forces(d, materials, displacement, whole_patches(isoparametric_spaces(d)), points,
                         progress);
}

Eigen::Matrix3Xd thermal_forces(const Discretization& d, const std::vector<Material>& materials,
                                const std::vector<ThermalStrain>& thermal,
                                const std::vector<PatchLayers>& parts, int points) {
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, d.node_count());
  return -internal_forces(d, materials, still, parts, points, {}, thermal).forces;
}

InternalForces summed(InternalForces share, const solvers::Processes& processes) {
  if (processes.count() == 1) return share;
  processes.sum(Eigen::Map<Eigen::VectorXd>(share.forces.data(), share.forces.size()));
  share.energy = processes.sum(share.energy);
  share.thermal_work = processes.sum(share.thermal_work);
  share.max_von_mises = largest(share.max_von_mises, processes);
  share.max_strain = largest(share.max_strain, processes);
  share.left_out = summed(share.left_out, processes);
  share.peaks = largest(share.peaks, processes);
  for (double& along : share.unresolved.along) along = processes.sum(along);
  share.unresolved.volumetric = processes.sum(share.unresolved.volumetric);
  return share;
}

}  // namespace isopatch::iga
