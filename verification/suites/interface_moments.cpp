// Multipliers are the interface's traction against trace functions. Where the stress is constant, this is
// known at every node.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/base/larger.hpp"
#include "geometry/models/reorient.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/output/interface_tractions.hpp"
#include "iga/problem/loads.hpp"
#include "verification/claims/expect.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/model_cases.hpp"
#include "verification/suites/node_forces.hpp"

namespace isopatch::verification {
namespace {

using Traction = std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>;

// Held on one boundary, pulled by the tractions of a constant stress on all other faces.
iga::ElasticityProblem in_constant_stress(const geometry::MultiPatch& model, const std::string& held,
                                          const LinearField& field, const Traction& traction,
                                          const iga::Material& material) {
  iga::ElasticityProblem p{
      iga::discretize(model, {.degree = {2, 2, 2}, .refine = 1}),
      std::vector<iga::Material>(static_cast<std::size_t>(model.patch_count()), material),
      {},
      {},
      {}};
  p.supports = {{held, faces_of(model, held), field.prescribed()}};
  std::vector<geometry::PatchFace> loaded = model.boundary_faces();
  for (const geometry::PatchFace& face : p.supports[0].faces) std::erase(loaded, face);
  p.surface_loads = {{"stress", loaded, traction}};
  return p;
}

// Integrals of the traction on one face against its trace functions, added to the nodes of its patch.
void add_moments(const iga::Discretization& d, const geometry::PatchFace& face, const Traction& traction,
                 Eigen::Matrix3Xd& moments) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  const Eigen::Matrix3Xd on_face = iga::face_load(d.patches[p], face.side, traction);
  const std::vector<int> points = geometry::face_control_points(d.patches[p].sizes(), face.side);
  for (std::size_t i = 0; i < points.size(); ++i)
    moments.col(d.first_node[p] + points[i]) += on_face.col(static_cast<Eigen::Index>(i));
}

// Largest difference of two columns at nodes that no support holds, relative to the largest of the second.
double difference_where_free(const iga::ElasticityProblem& problem, const Eigen::Matrix3Xd& found,
                             const Eigen::Matrix3Xd& expected) {
  const iga::GlobalNodes global = iga::global_nodes(problem.discretization);
  const std::vector<iga::SupportFrame> frames = iga::support_frames(problem, global);
  double apart = 0;
  for (std::size_t node = 0; node < global.global_of.size(); ++node)
    if (frames[static_cast<std::size_t>(global.global_of[node])].free == 3)
      apart = larger(apart, (found - expected).col(static_cast<Eigen::Index>(node)).norm());
  return apart / expected.colwise().norm().maxCoeff<Eigen::PropagateNaN>();
}

TEST(Coupling, MultipliersAreMomentsOfTheTraction) {
  const LinearField field = generic_linear_field();
  const iga::Material material = iga::isotropic(1e9, 0.3);
  const Traction traction = [stress = field.stress(material)](const Eigen::Vector3d&,
                                                              const Eigen::Vector3d& n) -> Eigen::Vector3d {
    return stress * n;
  };
  for (const ModelCase& model : model_cases())
    for (const iga::Coupling coupling : {iga::Coupling::lagrange, iga::Coupling::elimination}) {
      const iga::ElasticityProblem p =
          in_constant_stress(geometry::connect(geometry::randomly_reoriented(patches_of(model), 3)),
                             model.held, field, traction, material);
      const auto solution = iga::solve_elasticity(p, {.coupling = coupling, .quadrature_points = 10});
      Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero(3, p.discretization.node_count());
      for (const geometry::Interface& interface : p.discretization.model.interfaces()) {
        add_moments(p.discretization, interface.first, traction, moments);
        add_moments(p.discretization, interface.second, traction, moments);
      }
      const std::string of = fmt::format(
          "{} in constant stress, {}: ", model.name,
          coupling == iga::Coupling::lagrange ? "multipliers solved for" : "multipliers recovered");
      expect(Claim{
          of + "largest difference of a node's force from the moments of the tractions on its interfaces",
          "",
          ReferenceKind::exact,
          "integral of stress n N",
          0,
          difference_where_free(p, node_forces(p, solution.multipliers), moments),
          round_off(1e4, "assembling, solving and summing over each interface"),
          {}});
    }
}

}  // namespace
}  // namespace isopatch::verification
