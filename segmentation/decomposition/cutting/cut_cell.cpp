#include "segmentation/decomposition/cutting/cut_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/cutting/chord.hpp"
#include "segmentation/decomposition/cutting/cutting_surface.hpp"
#include "segmentation/decomposition/cutting/divide.hpp"
#include "segmentation/decomposition/cutting/inside.hpp"
#include "segmentation/decomposition/cutting/vertex_on_chain.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

/// Thrown inside this file only.
struct Refused {
  std::string why;
};

class Cutter {
 public:
  Cutter(const Brep& source, CellComplex complex, CellId cell, const CellSides& sides,
         const CutOptions& options, const Eigen::Matrix3Xd* boundary)
      : source_(source),
        complex_(std::move(complex)),
        cell_(cell),
        sides_(sides),
        options_(options),
        boundary_(boundary),
        tolerance_(options.tolerance * source.size()),
        polyhedral_(is_polyhedral(shapes(), cell)),
        convex_(is_convex()),
        chains_(sides.edges) {}

  CutCell cut(const PlacedLoop& loop) {
    const CellComplex before = convex_ ? CellComplex() : complex_;
    const std::vector<VertexId> places = place_vertices(loop);
    const StepWalk steps = walk(loop.loop, places);
    const auto surface = cutting_surface(shapes(), steps, tolerance_, is_free_form());
    if (!surface)
      throw Refused{fmt::format("no surface is known through {} steps that lie in no plane", steps.size())};
    if (options_.keep_plane && polyhedral_ &&
        !std::holds_alternative<geometry::PlaneSurface>(surface->surface))
      throw Refused{"the loop lies in no plane, though all sides of the cell do"};
    const geometry::SurfaceId id = complex_.add_surface(surface->surface);
    const std::vector<EdgeUse> edges = joined(steps);
    for (std::size_t i = 0; i < surface->traces.size(); ++i) add_trace(edges[i].edge, id, surface->traces[i]);
    const DividedCell divided = divide_cell(complex_, cell_, edges, id);
    require_angles(edges, divided);
    continue_sides(edges, divided);
    if (!convex_) require_inside(before, divided.face);
    return {std::move(complex_), cell_, divided.other, divided.face, places};
  }

 private:
  CellShapes shapes() const { return CellShapes(source_, complex_); }

  /// Whether the cell is convex in space for certain, so that a plane section of it cannot leave it.
  bool is_convex() const {
    for (const CellGraph::Edge& edge : sides_.graph.edges)
      if (edge.kind == EdgeKind::non_convex) return false;
    return polyhedral_;
  }

  bool is_free_form() const { return options_.free_form && !(options_.keep_plane && polyhedral_); }

  std::vector<VertexId> place_vertices(const PlacedLoop& loop) {
    std::vector<VertexId> result;
    for (std::size_t i = 0; i < loop.loop.places.size(); ++i) {
      const LoopPlace place = loop.loop.places[i];
      if (!place.auxiliary())
        result.push_back(sides_.vertices[static_cast<std::size_t>(place.vertex.value)]);
      else if (i < loop.at.size() && loop.at[i].value >= 0)
        result.push_back(loop.at[i]);
      else if (!loop.points.empty())
        result.push_back(vertex_at(chains_[static_cast<std::size_t>(place.edge.value)], loop.points[i]));
      else
        result.push_back(middle_of(chains_[static_cast<std::size_t>(place.edge.value)]));
    }
    return result;
  }

  /// A vertex on a chain of edges, the one nearest to its middle where there are any.
  VertexId middle_of(std::vector<EdgeUse>& chain) {
    if (chain.size() > 1) return complex_.to(chain[chain.size() / 2 - 1]);
    const VertexId vertex = divide_edge(complex_, chain[0].edge, 0.5, shapes().point(chain[0].edge, 0.5));
    chain.push_back({EdgeId(static_cast<int>(complex_.edges.size()) - 1), chain[0].reversed});
    if (chain[0].reversed) std::swap(chain[0], chain[1]);
    return vertex;
  }

  /// A vertex at a point of a chain.
  VertexId vertex_at(std::vector<EdgeUse>& chain, const Eigen::Vector3d& point) {
    const std::size_t edges = complex_.edges.size();
    const VertexId vertex = vertex_on_chain(source_, complex_, chain, point, 1e-7 * source_.size());
    if (complex_.edges.size() == edges) return vertex;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (complex_.edge(chain[i].edge).end != vertex) continue;
      const EdgeUse second{EdgeId(static_cast<int>(edges)), chain[i].reversed};
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i + (chain[i].reversed ? 0 : 1)), second);
      break;
    }
    return vertex;
  }

  /// The edges of the complex between two vertices of an edge of the graph, from one to the other.
  std::vector<EdgeUse> along(EdgeId edge, VertexId from, VertexId to) const {
    std::vector<EdgeUse> chain = chains_[static_cast<std::size_t>(edge.value)];
    const auto find = [&](VertexId start, VertexId end) {
      std::vector<EdgeUse> part;
      for (const EdgeUse& use : chain) {
        if (complex_.from(use) == start || !part.empty()) part.push_back(use);
        if (!part.empty() && complex_.to(use) == end) return part;
      }
      return std::vector<EdgeUse>();
    };
    std::vector<EdgeUse> part = find(from, to);
    if (!part.empty()) return part;
    std::reverse(chain.begin(), chain.end());
    for (EdgeUse& use : chain) use.reversed = !use.reversed;
    part = find(from, to);
    if (part.empty())
      throw Error(ErrorCode::internal, "a loop runs along an edge that its places are not on");
    return part;
  }

  /// The plane that the places of a loop and the edges that it runs along lie in.
  std::optional<geometry::PlaneSurface> plane_of(const CuttingLoop& loop,
                                                 const std::vector<VertexId>& places) const {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < loop.steps.size(); ++k) {
      if (loop.steps[k].auxiliary()) {
        points.push_back(complex_.vertex(places[k]));
        continue;
      }
      const Eigen::Matrix3Xd along_step =
          points_along(shapes(), along(loop.steps[k].edge, places[k], places[(k + 1) % places.size()]));
      for (const auto& point : along_step.colwise()) points.emplace_back(point);
    }
    return plane_through(Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3,
                                                            static_cast<Eigen::Index>(points.size())),
                         tolerance_);
  }

  StepWalk walk(const CuttingLoop& loop, const std::vector<VertexId>& places) {
    StepWalk result;
    ChordOptions options{tolerance_, options_.smallest_angle, is_free_form(), {}};
    if (!polyhedral_) options.plane = plane_of(loop, places);
    for (std::size_t k = 0; k < loop.steps.size(); ++k) {
      const VertexId from = places[k], to = places[(k + 1) % places.size()];
      const LoopStep& step = loop.steps[k];
      if (!step.auxiliary()) {
        result.push_back(along(step.edge, from, to));
        continue;
      }
      std::vector<FaceId> side;
      for (const CellFaceUse& face : complex_.cell(cell_).faces)
        if (face.side == sides_.faces[static_cast<std::size_t>(step.face.value)].front().side)
          side.push_back(face.face);
      auto chord = add_chord(source_, complex_, side, from, to, options);
      if (!chord)
        throw Refused{fmt::format("an auxiliary edge would leave side {} or come too close to its outline",
                                  step.face.value)};
      result.push_back(std::move(*chord));
    }
    require_lengths(result, places);
    return result;
  }

  /// Of the walk, and of what its places leave of the edges that they divide.
  void require_lengths(const StepWalk& walk, const std::vector<VertexId>& places) const {
    const double least = options_.shortest_edge * source_.size();
    const auto require = [&](EdgeId edge) {
      if (!((shapes().point(edge, 1) - shapes().point(edge, 0)).norm() > least))
        throw Refused{"it would make an edge that is too short"};
    };
    for (const auto& step : walk)
      for (const EdgeUse& use : step) require(use.edge);
    for (const std::vector<EdgeUse>& chain : chains_)
      if (chain.size() > 1)
        for (const EdgeUse& use : chain)
          for (const VertexId place : places)
            if (complex_.from(use) == place || complex_.to(use) == place) require(use.edge);
  }

  void add_trace(EdgeId edge, geometry::SurfaceId surface, const geometry::NurbsCurve& trace) {
    auto& traces = complex_.curves[static_cast<std::size_t>(complex_.edge(edge).curve.value)].traces;
    const auto known =
        std::any_of(traces.begin(), traces.end(), [&](const auto& old) { return old.surface == surface; });
    if (!known) traces.push_back({surface, trace});
  }

  void require_angles(const std::vector<EdgeUse>& walk, const DividedCell& divided) const {
    const double least = options_.smallest_angle.degrees();
    for (const CellId id : {cell_, divided.other}) {
      const std::vector<CellFaceUse>& faces = complex_.cell(id).faces;
      const CellFaceUse& cut = faces.back();
      for (const EdgeUse& use : walk)
        for (const CellFaceUse& face : faces) {
          if (face.face == cut.face) continue;
          for (const EdgeUse& here : complex_.face(face.face).loop) {
            if (here.edge != use.edge) continue;
            const EdgeUse outside{here.edge, here.reversed != face.reversed};
            for (const double t : {0.05, 0.5, 0.95}) {
              const double angle = inner_angle(shapes(), face, cut, outside, t).degrees();
              if (angle < least || angle > 360 - least)
                throw Refused{fmt::format("it would meet a side at {:.1f} degrees", angle)};
            }
          }
        }
    }
  }

  /// Makes the new face one with sides that it continues without an edge.
  void continue_sides(const std::vector<EdgeUse>& walk, const DividedCell& divided) {
    for (const CellId id : {cell_, divided.other}) {
      std::vector<CellFaceUse>& faces = complex_.cells[static_cast<std::size_t>(id.value)].faces;
      for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
        const int side = faces[f].side, cut = faces.back().side;
        if (side == cut || !continues(walk, faces[f], faces.back())) continue;
        for (CellFaceUse& face : faces)
          if (face.side == cut) face.side = side;
      }
    }
  }

  bool continues(const std::vector<EdgeUse>& walk, const CellFaceUse& face, const CellFaceUse& cut) const {
    for (const EdgeUse& use : walk)
      for (const EdgeUse& here : complex_.face(face.face).loop) {
        if (here.edge != use.edge || !shapes().is_plane(complex_.face(face.face).surface) ||
            !shapes().is_plane(complex_.face(cut.face).surface))
          continue;
        const EdgeUse outside{here.edge, here.reversed != face.reversed};
        const double angle = inner_angle(shapes(), face, cut, outside, 0.5).degrees();
        if (std::abs(angle - 180) < 1e-3) return true;
      }
    return false;
  }

  void require_inside(const CellComplex& before, FaceId face) const {
    const Eigen::Matrix3Xd boundary =
        boundary_ != nullptr ? *boundary_ : boundary_triangles(CellShapes(source_, before), cell_);
    // Near curved sides the triangles may be on the wrong side of a point; in a plane distances are known.
    const bool near_matters =
        !polyhedral_ && shapes().is_plane(complex_.face(face).surface) && boundary.cols() > 0;
    const double off =
        near_matters ? triangles_off * (boundary.rowwise().maxCoeff() - boundary.rowwise().minCoeff()).norm()
                     : 0;
    const Eigen::Matrix2Xd inside = points_inside(outline(shapes(), face), off);
    if (inside.cols() == 0) throw Refused{"the cut would be too thin"};
    for (const auto& uv : inside.colwise())
      if (winding_number(boundary, shapes().point(complex_.face(face).surface, uv)) < 0.5)
        throw Refused{"the cut would leave the cell"};
  }

  const Brep& source_;
  CellComplex complex_;
  CellId cell_;
  const CellSides& sides_;
  const CutOptions& options_;
  const Eigen::Matrix3Xd* boundary_;
  double tolerance_;
  bool polyhedral_, convex_;
  std::vector<std::vector<EdgeUse>>
      chains_;  // of the graph's edges, with what they are divided into meanwhile
};

}  // namespace

void validate(const CutOptions& options) {
  const auto require = [](const char* field, double value, double high) {
    if (!(value > 0 && value < high))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("{} is {}; its range is (0, {})", field, value, high));
  };
  require("tolerance", options.tolerance, 1e-3);
  require("smallest_angle", options.smallest_angle.degrees(), 45);
  require("shortest_edge", options.shortest_edge, 0.1);
}

CutAttempt cut_cell(const Brep& source, CellComplex complex, CellId cell, const CellSides& sides,
                    const PlacedLoop& loop, const CutOptions& options, const Eigen::Matrix3Xd* boundary) {
  validate(options);
  try {
    return {Cutter(source, std::move(complex), cell, sides, options, boundary).cut(loop)};
  } catch (const Refused& refused) {
    return {std::nullopt, refused.why};
  }
}

}  // namespace isopatch::segmentation
