#include "geometry/brep/contradictions.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/tessellation.hpp"

namespace isopatch::geometry {
namespace {

FaceId face_id(std::size_t index) {
  return FaceId(static_cast<int>(index));
}

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", p.x(), p.y(), p.z());
}

class Search {
 public:
  Search(const Brep& brep, const BoundaryReport& boundary, const SoundnessOptions& options)
      : brep_(brep),
        boundary_(boundary),
        graph_(edge_graph(brep)),
        size_(brep.size()),
        most_(options.gap * size_) {}

  std::vector<Contradiction> make() {
    add_edge_gaps();
    add_vertex_gaps();
    for (std::size_t f = 0; f < graph_.faces.size(); ++f)
      for (const auto& loop : graph_.faces[f].loops) add_loop(face_id(f), loop);
    if (!boundary_.bounds_a_solid()) return std::move(result_);
    add_characteristics();
    if (result_.empty()) add_volume();  // otherwise it is no wonder
    return std::move(result_);
  }

 private:
  std::string length(double metres) const {
    return fmt::format("{:.3g} m ({:.2g} of the size)", metres, metres / size_);
  }

  void add_edge_gaps() {
    std::vector<EdgeGap> gaps = edge_gaps(brep_);
    std::erase_if(gaps, [&](const EdgeGap& gap) { return !(gap.distance > most_); });
    std::stable_sort(gaps.begin(), gaps.end(),
                     [](const EdgeGap& a, const EdgeGap& b) { return a.distance > b.distance; });
    for (const EdgeGap& gap : gaps) {
      SolidFault fault;
      fault.faces.push_back({gap.face.value, "", "off its edge by " + length(gap.distance)});
      fault.edges.push_back(drawn(brep_, gap.edge));
      fault.points.push_back({"widest gap", gap.place});
      result_.push_back({fmt::format("{} lies {} off its edge {} at {}", describe(brep_, gap.face),
                                     length(gap.distance), gap.edge.value, place(gap.place)),
                         gap.distance, std::move(fault)});
    }
  }

  void add_vertex_gaps() {
    for (std::size_t e = 0; e < brep_.edges().size(); ++e) {
      const EdgeId id(static_cast<int>(e));
      const BrepEdge& edge = brep_.edges()[e];
      for (const auto& [vertex, t] : {std::pair(edge.start, 0.0), std::pair(edge.end, 1.0)}) {
        const double distance = (brep_.vertex(vertex) - brep_.point(id, t)).norm();
        if (!(distance > most_)) continue;
        SolidFault fault;
        fault.edges.push_back(drawn(brep_, id));
        fault.points.push_back({fmt::format("vertex {}", vertex.value), brep_.vertex(vertex)});
        result_.push_back({fmt::format("{} lies {} off the end of edge {}", describe(brep_, vertex),
                                       length(distance), id.value),
                           distance, std::move(fault)});
      }
    }
  }

  void add_loop(FaceId face, const std::vector<EdgeUse>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const EdgeUse use = loop[i], next = loop[(i + 1) % loop.size()];
      if (graph_.to(use) != graph_.from(next))
        add_open_loop(face, use, next);
      else
        add_domain_gap(face, use, next);
    }
    if (loop.size() != 2 || loop[0].edge == loop[1].edge) return;
    const auto straight = [&](EdgeUse use) { return brep_.edge(use.edge).kind == CurveKind::line; };
    if (!straight(loop[0]) || !straight(loop[1])) return;
    SolidFault fault{.edges = {drawn(brep_, loop[0].edge)}};
    fault.faces.push_back({face.value, "", "a loop encloses nothing"});
    result_.push_back({fmt::format("a loop of {} encloses nothing: it is the straight edges {} and {}",
                                   describe(brep_, face), loop[0].edge.value, loop[1].edge.value),
                       0, std::move(fault)});
  }

  void add_open_loop(FaceId face, EdgeUse use, EdgeUse next) {
    SolidFault fault{.edges = {drawn(brep_, use.edge)}};
    fault.faces.push_back({face.value, "", "an open loop"});
    const VertexId end = graph_.to(use), start = graph_.from(next);
    for (const VertexId vertex : {end, start})
      fault.points.push_back({fmt::format("vertex {}", vertex.value), brep_.vertex(vertex)});
    result_.push_back(
        {fmt::format("a loop of {} is open: edge {} ends in {}, edge {} starts in {}", describe(brep_, face),
                     use.edge.value, describe(brep_, end), next.edge.value, describe(brep_, start)),
         (brep_.vertex(end) - brep_.vertex(start)).norm(), std::move(fault)});
  }

  // As long on the surface as the straight line between the two ends in the domain: nothing at a pole, once
  // around where a loop closes in space only.
  void add_domain_gap(FaceId face, EdgeUse use, EdgeUse next) {
    const Eigen::Vector2d end = brep_.domain_point(face, use, use.reversed ? 0 : 1);
    const Eigen::Vector2d start = brep_.domain_point(face, next, next.reversed ? 1 : 0);
    constexpr int chords = 8;
    double gap = 0;
    Eigen::Vector3d before = brep_.point(face, end);
    for (int i = 1; i <= chords; ++i) {
      const Eigen::Vector3d at = brep_.point(face, end + (start - end) * (double(i) / chords));
      gap += (at - before).norm();
      before = at;
    }
    if (!(gap > 2 * most_)) return;  // each of the two may be off by one
    const Eigen::Vector3d at = brep_.point(use.edge, use.reversed ? 0 : 1);
    SolidFault fault{.edges = {drawn(brep_, use.edge)}, .points = {{"where the loop is open", at}}};
    fault.faces.push_back({face.value, "", "a loop is open in the domain"});
    result_.push_back(
        {fmt::format(
             "a loop of {} is open in the face's domain: the curves of edges {} and {} end {} apart at {}",
             describe(brep_, face), use.edge.value, next.edge.value, length(gap), place(at)),
         gap, std::move(fault)});
  }

  void add_characteristics() {
    for (const ShellCharacteristic& shell : shell_characteristics(graph_)) {
      if (shell.value <= 2 && shell.value % 2 == 0) continue;
      SolidFault fault;
      for (const FaceId face : shell.faces) fault.faces.push_back({face.value});
      result_.push_back(
          {fmt::format("the shell of {} has V - E + F = {}, which no closed surface has (2 less "
                       "twice its handles): loops are wrong",
                       describe(brep_, shell.faces.front()), shell.value),
           0, std::move(fault)});
    }
  }

  // Triangles within `chord` of the surface are off by no more than that times its area; twice, since the
  // triangulation is not strict about it. Coarse ones, which are quick, may be far from strict on splines.
  void add_volume() {
    constexpr double chord = 1e-3;
    const Measure volume = brep_.measured_volume(), area = brep_.measured_area();
    const double explained = 2 * chord * size_ * area.value;
    if (volume.error > explained) return;  // says so itself
    double sum = 0;
    Tessellation mesh;
    for (const Angle turn : {Angle::degrees(60), Angle::degrees(15)}) {
      try {
        mesh = tessellate(brep_, {chord, turn});
      } catch (const Error&) {
        return;  // nothing to compare with
      }
      sum = enclosed_volume(mesh, brep_.vertex(VertexId(0)));
      if (std::abs(sum - volume.value) <= explained) return;
    }
    if (distance_from_surfaces(mesh) > 10 * chord * size_) return;  // the triangles are wrong, not the solid
    result_.push_back(
        {fmt::format("the volume is {:.6g} m^3 by quadrature over the faces and {:.6g} m^3 by "
                     "triangles within {:.3g} m of them: faces, loops or their senses are wrong",
                     volume.value, sum, chord * size_),
         0,
         {}});
  }

  /// Of the middles of triangles. The kernel leaves long faces that wind half empty at times.
  double distance_from_surfaces(const Tessellation& mesh) const {
    double largest = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const FaceTriangles& face = mesh.faces[f];
      for (const auto& triangle : face.triangles.colwise()) {
        const Eigen::Vector2d uv = face.uv(Eigen::all, triangle).rowwise().mean();
        const Eigen::Vector3d middle = face.points(Eigen::all, triangle).rowwise().mean();
        largest = std::max(largest, (brep_.point(face_id(f), uv) - middle).norm());
      }
    }
    return largest;
  }

  static double enclosed_volume(const Tessellation& mesh, const Eigen::Vector3d& from) {
    double sum = 0;
    for (const FaceTriangles& face : mesh.faces)
      for (const auto& triangle : face.triangles.colwise()) {
        const Eigen::Vector3d a = face.points.col(triangle(0)) - from,
                              b = face.points.col(triangle(1)) - from,
                              c = face.points.col(triangle(2)) - from;
        sum += a.dot(b.cross(c)) / 6;
      }
    return sum;
  }

  const Brep& brep_;
  const BoundaryReport& boundary_;
  const EdgeGraph graph_;
  const double size_, most_;
  std::vector<Contradiction> result_;
};

}  // namespace

void validate(const SoundnessOptions& options) {
  if (!(options.gap > 0 && options.gap < 0.1))
    throw Error(ErrorCode::invalid_argument, fmt::format("gap is {}; it must lie in (0, 0.1)", options.gap));
}

std::vector<EdgeGap> edge_gaps(const Brep& brep) {
  constexpr int samples = 17;
  std::vector<EdgeGap> result;
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    EdgeGap widest{-1, face_id(f), EdgeId(0)};
    for (const auto& loop : brep.faces()[f].loops)
      for (const EdgeUse use : loop)
        for (int i = 0; i < samples; ++i) {
          const double t = double(i) / (samples - 1);
          const Eigen::Vector3d on_edge = brep.point(use.edge, t);
          const Eigen::Vector3d on_face = brep.point(widest.face, brep.domain_point(widest.face, use, t));
          const double distance = (on_face - on_edge).norm();
          if (distance > widest.distance) widest = {distance, widest.face, use.edge, on_edge};
        }
    if (widest.distance >= 0) result.push_back(widest);
  }
  return result;
}

EdgeGap largest_gap(const Brep& brep) {
  const std::vector<EdgeGap> gaps = edge_gaps(brep);
  const auto widest = std::max_element(
      gaps.begin(), gaps.end(), [](const EdgeGap& a, const EdgeGap& b) { return a.distance < b.distance; });
  return widest == gaps.end() ? EdgeGap{0, FaceId(0), EdgeId(0)} : *widest;
}

std::vector<Contradiction> contradictions(const Brep& brep, const BoundaryReport& boundary,
                                          const SoundnessOptions& options) {
  validate(options);
  return Search(brep, boundary, options).make();
}

void require_sound(const Brep& brep, const SoundnessOptions& options) {
  const BoundaryReport report = boundary(edge_graph(brep));
  const std::string problem = boundary_problem(brep, report);
  if (!problem.empty()) throw SolidError(ErrorCode::not_manifold, problem, boundary_fault(brep, report));
  const std::vector<Contradiction> found = contradictions(brep, report, options);
  if (found.empty()) return;
  SolidFault fault;
  for (const Contradiction& each : found) {
    fault.faces.insert(fault.faces.end(), each.fault.faces.begin(), each.fault.faces.end());
    fault.edges.insert(fault.edges.end(), each.fault.edges.begin(), each.fault.edges.end());
    fault.points.insert(fault.points.end(), each.fault.points.begin(), each.fault.points.end());
  }
  const std::string more =
      found.size() == 1 ? "" : fmt::format("; and {} more contradictions", found.size() - 1);
  throw SolidError(ErrorCode::not_manifold,
                   fmt::format("the geometry contradicts itself: {}{}; repair the solid in the CAD program",
                               found.front().text, more),
                   std::move(fault));
}

}  // namespace isopatch::geometry
