#include "iga/post/internal_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// What the map of a patch is at a point, whatever moves there.
struct PointGeometry {
  Eigen::Vector3d place;
  Eigen::Matrix3d inverse;  // of the derivatives
  double measure = 0;       // weight times det J, m^3
  double denominator = 0;   // one over W
  Eigen::Vector3d rate;     // of W, times that
  MapState state = MapState::sound;
  double scaled = 0;
};

struct Scratch {
  TensorBuffers<4> geometry, displacement, test;
  std::vector<PointGeometry> points;
  PointStresses stresses, modes;
  Eigen::VectorXd measures;
  std::vector<StressPeaks> seen;  // of each displacement, by this thread, whose elements come in order
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

// What the stresses of several displacements do in one element.
using ElementResults = std::vector<ElementForces>;

class PatchForces {
 public:
  PatchForces(const Discretization& d, int patch, const Material& material,
              const std::vector<StrainedPart>& displacements, const GaussPoints& points)
      : d_(d),
        index_(patch),
        patch_(d.patches[static_cast<std::size_t>(patch)]),
        material_(material),
        tensors_(patch_, gauss_rules(points)),
        modes_(points, {patch_.degree(0), patch_.degree(1), patch_.degree(2)}) {
    const auto p = static_cast<std::size_t>(patch);
    for (const StrainedPart& one : displacements) {
      displacements_.emplace_back(one.displacement.middleCols(d.first_node[p], patch_.size()));
      thermal_.push_back(one.thermal.empty() ? ThermalStrain{} : one.thermal[p]);
    }
  }

  const ElementTensors& tensors() const { return tensors_; }

  void compute(std::int64_t element, Scratch& scratch, ElementResults& out) const {
    evaluate_geometry(element, scratch);
    out.resize(displacements_.size());
    scratch.seen.resize(displacements_.size());
    for (std::size_t i = 0; i < displacements_.size(); ++i) compute(element, i, scratch, out[i]);
  }

 private:
  void evaluate_geometry(std::int64_t element, Scratch& scratch) const {
    gather(tensors_, element, patch_.control_points(), patch_.weights(), scratch.geometry.coefficients);
    tensors_.gradients(element, scratch.geometry);
    scratch.points.resize(static_cast<std::size_t>(tensors_.point_count()));
    scratch.measures.resize(tensors_.point_count());
    tensors_.for_each_point(element, [&](Eigen::Index point, double weight) {
      const auto q = static_cast<std::size_t>(point);
      const RationalPoint place = rational_point(scratch.geometry, q);
      const double jacobian = place.derivatives.determinant();
      if (!(jacobian > 0))
        refuse_folded(index_, patch_, d_.model.was_reversed(PatchId(index_)),
                      tensors_.parameter(element, point));
      PointGeometry& at = scratch.points[q];
      at.place = place.value;
      at.inverse = place.derivatives.inverse();
      scratch.measures[point] = at.measure = weight * jacobian;
      const auto& [value, du, dv, dw] = scratch.geometry.at;
      at.denominator = 1 / value[q][3];
      at.rate = at.denominator * Eigen::Vector3d(du[q][3], dv[q][3], dw[q][3]);
      at.state = map_state(place.derivatives, at.scaled);
    });
  }

  void compute(std::int64_t element, std::size_t which, Scratch& scratch, ElementForces& out) const {
    gather(tensors_, element, displacements_[which], patch_.weights(), scratch.displacement.coefficients);
    tensors_.gradients(element, scratch.displacement);
    for (auto& at : scratch.test.at) at.resize(static_cast<std::size_t>(tensors_.point_count()));
    out.energy = out.thermal_work = 0;
    out.von_mises = out.strain = {};
    out.peaks = {};
    out.folded = 0;
    out.worst = {-2, 0, Eigen::Vector3d::Zero()};
    scratch.stresses.resize(6, tensors_.point_count());
    for (Eigen::Index q = 0; q < tensors_.point_count(); ++q) at_point(element, q, which, scratch, out);
    out.modes = modes_.energies(scratch.stresses, scratch.measures, material_, scratch.modes);
    tensors_.test_with_gradients(element, scratch.test);
    out.forces.resize(static_cast<std::size_t>(3 * tensors_.function_count()));
    tensors_.for_each_function(element, [&](Eigen::Index a, Eigen::Index i) {
      Eigen::Map<Eigen::Vector3d>(&out.forces[static_cast<std::size_t>(3 * a)]) =
          patch_.weights()[i] * scratch.test.coefficients[static_cast<std::size_t>(a)].head<3>().matrix();
    });
  }

  // What the functions N = w B / W and their gradients are multiplied by: with the stress on the unit cube T,
  // sum over k of T_k dN/dk = w (sum over k of T_k / W dB/dk - B sum over k of T_k / W W_k / W).
  static void put_on_cube(const Eigen::Matrix3d& sigma, const PointGeometry& geometry, std::size_t q,
                          TensorBuffers<4>& test) {
    const std::array<FieldLanes<4>, 3> columns = {FieldLanes<4>(sigma(0, 0), sigma(1, 0), sigma(2, 0), 0),
                                                  FieldLanes<4>(sigma(0, 1), sigma(1, 1), sigma(2, 1), 0),
                                                  FieldLanes<4>(sigma(0, 2), sigma(1, 2), sigma(2, 2), 0)};
    const double factor = geometry.measure * geometry.denominator;
    FieldLanes<4> of_values = FieldLanes<4>::Zero();
    for (Eigen::Index k = 0; k < 3; ++k) {
      FieldLanes<4>& on_cube = test.at[static_cast<std::size_t>(k + 1)][q];
      on_cube = factor * (geometry.inverse(k, 0) * columns[0] + geometry.inverse(k, 1) * columns[1] +
                          geometry.inverse(k, 2) * columns[2]);
      of_values -= geometry.rate[k] * on_cube;
    }
    test.at[0][q] = of_values;
  }

  // Stress, energy, forces and largest values.
  void at_point(std::int64_t element, Eigen::Index point, std::size_t which, Scratch& scratch,
                ElementForces& out) const {
    const auto q = static_cast<std::size_t>(point);
    const PointGeometry& geometry = scratch.points[q];
    const auto [x, y, z] =
        point_derivatives(scratch.displacement, q, geometry.inverse, geometry.denominator).gradient;
    const double thermal = thermal_[which].at(geometry.place);
    const double xy = 0.5 * (x[1] + y[0]), yz = 0.5 * (y[2] + z[1]), zx = 0.5 * (z[0] + x[2]);
    const double twice = 2 * material_.mu, trace = x[0] + y[1] + z[2];
    const double pressure = material_.lambda * trace - (3 * material_.lambda + twice) * thermal;
    Eigen::Matrix3d sigma;
    sigma << twice * x[0] + pressure, twice * xy, twice * zx,  //
        twice * xy, twice * y[1] + pressure, twice * yz,       //
        twice * zx, twice * yz, twice * z[2] + pressure;
    const double shear = 2 * (xy * xy + yz * yz + zx * zx);
    const double squares = x[0] * x[0] + y[1] * y[1] + z[2] * z[2] + shear;  // of the strain
    const double thermal_work = -0.5 * geometry.measure * sigma.trace() * thermal;
    out.energy += 0.5 * geometry.measure * (twice * squares + pressure * trace) + thermal_work;
    out.thermal_work += thermal_work;
    put_on_cube(sigma, geometry, q, scratch.test);
    scratch.stresses.col(point) << sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(0, 1), sigma(1, 2),
        sigma(2, 0);
    if (geometry.state != MapState::sound) {
      ++out.folded;
      out.worst.take(-geometry.scaled, point, geometry.place);
      return;
    }
    const double equivalent = von_mises(sigma);
    require_finite(equivalent, index_, geometry.place);
    out.von_mises.take(equivalent, point, geometry.place);
    iga::take(
        StressPoint{sigma, equivalent, material_.yield},
        [&]() -> Extremum {
          return {0, geometry.place, index_, tensors_.parameter(element, point)};
        },
        scratch.seen[which], out.peaks);
    out.strain.take(std::sqrt(squares), point, geometry.place);
  }

  const Discretization& d_;
  int index_;
  const geometry::NurbsVolume& patch_;
  const Material& material_;
  std::vector<Eigen::Matrix3Xd> displacements_;  // of this patch
  std::vector<ThermalStrain> thermal_;
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

// Adds what the stresses of one displacement do in an element.
void add(const PatchForces& of_patch, int patch, std::int64_t number, const ElementForces& element,
         double* forces, InternalForces& result) {
  result.energy += element.energy;
  result.thermal_work += element.thermal_work;
  of_patch.tensors().for_each_function(number, [&](Eigen::Index a, Eigen::Index i) {
    Eigen::Map<Eigen::Vector3d>(forces + 3 * i) +=
        Eigen::Map<const Eigen::Vector3d>(&element.forces[static_cast<std::size_t>(3 * a)]);
  });
  const auto take = [&](const Largest& found, Extremum& so_far) {
    if (is_larger(found.value, so_far.value))
      so_far = {found.value, found.place, patch, of_patch.tensors().parameter(number, found.point)};
  };
  take(element.von_mises, result.max_von_mises);
  take(element.strain, result.max_strain);
  take(element.worst, result.left_out.worst);
  result.peaks = together(result.peaks, element.peaks);
  result.left_out.folded += element.folded;
  result.unresolved += element.modes;
}

}  // namespace

std::vector<InternalForces> internal_forces(const Discretization& d, const std::vector<Material>& materials,
                                            const std::vector<StrainedPart>& displacements,
                                            const std::vector<PatchLayers>& parts, int points,
                                            const Progress& progress) {
  std::vector<InternalForces> result(displacements.size());
  for (InternalForces& one : result) {
    one.forces = Eigen::Matrix3Xd::Zero(3, d.node_count());
    one.max_von_mises.value = one.max_strain.value = -1;
  }
  std::int64_t total = 0, done = 0;
  for (const PatchLayers& part : parts) total += elements_of(d, part).count;
  const std::int64_t batch =
      std::max<std::int64_t>(1, elements_per_batch / static_cast<std::int64_t>(displacements.size()));
  for (const PatchLayers& part : parts) {
    const auto patch = static_cast<std::size_t>(part.patch);
    const PatchForces of_patch(d, part.patch, materials[patch], displacements,
                               d.points_of(part.patch, points));
    const ElementRange range = elements_of(d, part);
    in_batches<Scratch, ElementResults>(
        range.count, batch,
        [&](std::int64_t element, Scratch& scratch, ElementResults& out) {
          of_patch.compute(range.first + element, scratch, out);
        },
        [&](std::int64_t first, std::span<const ElementResults> elements) {
          for (const ElementResults& element : elements) {
            for (std::size_t i = 0; i < element.size(); ++i)
              add(of_patch, part.patch, range.first + first, element[i],
                  result[i].forces.data() + std::ptrdiff_t{3} * d.first_node[patch], result[i]);
            ++first;
          }
          done += static_cast<std::int64_t>(elements.size());
          progress("stresses", static_cast<double>(done) / static_cast<double>(total));
        });
  }
  return result;
}

InternalForces internal_forces(const Discretization& d, const std::vector<Material>& materials,
                               const Eigen::Matrix3Xd& displacement, const std::vector<PatchLayers>& parts,
                               int points, const Progress& progress,
                               const std::vector<ThermalStrain>& thermal) {
  return std::move(internal_forces(d, materials, std::vector<StrainedPart>{{displacement, thermal}}, parts,
                                   points, progress)
                       .front());
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
