#include "segmentation/sweeps/layered_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/sweeps/internal/column_complex.hpp"
#include "segmentation/sweeps/internal/column_volume.hpp"
#include "segmentation/sweeps/internal/divided_drawing.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

/// Heights of floors, ascending; those that differ by less than a tolerance are one.
std::vector<double> floor_heights(const SweptDrawing& drawing, double tolerance) {
  std::vector<double> result;
  for (const std::vector<Slab>& slabs : drawing.slabs)
    for (const Slab& slab : slabs) result.insert(result.end(), {slab.low, slab.high});
  std::sort(result.begin(), result.end());
  result.erase(
      std::unique(result.begin(), result.end(), [&](double a, double b) { return b - a < tolerance; }),
      result.end());
  return result;
}

/// What of a region's material lies between two heights next to each other.
std::vector<Slab> clipped(const std::vector<Slab>& slabs, double low, double high, double tolerance) {
  for (Slab slab : slabs) {
    if (slab.low > low + tolerance || slab.high < high - tolerance) continue;
    if (slab.low < low - tolerance) slab.bottom.reset();
    if (slab.high > high + tolerance) slab.top.reset();
    slab.low = low;
    slab.high = high;
    return {slab};
  }
  return {};
}

/// The floor on which some of them end; nothing where these are several.
std::optional<FaceId> common_floor(const std::vector<std::vector<Slab>>& slabs,
                                   const std::vector<int>& regions, std::optional<FaceId> Slab::*end) {
  std::optional<FaceId> result;
  for (const int region : regions)
    for (const Slab& slab : slabs[static_cast<std::size_t>(region)]) {
      if (!(slab.*end)) continue;
      if (result && result != slab.*end) return std::nullopt;
      result = slab.*end;
    }
  return result;
}

/// What of a drawing lies between two heights next to each other, divided as if there were nothing else.
DividedDrawing divided_layer(const Brep& solid, const SweepFrame& frame, SweptDrawing drawing, double low,
                             double high, const QuadrangulationOptions& options) {
  std::vector<int> groups;
  for (std::vector<Slab>& slabs : drawing.slabs) {
    slabs = clipped(slabs, low, high, 1e-7 * solid.size());
    groups.push_back(slabs.empty() ? -1 : 0);
  }
  const Tracks& tracks = drawing.tracks;
  const bool stays = tracks.vertices.empty() && tracks.edges.empty() && tracks.rings.empty();
  const MergedProfile merged(drawing.profile, groups, stays ? CollinearLines::one : CollinearLines::apart);
  const std::vector<std::vector<Slab>> apart = drawing.slabs;
  for (const std::vector<int>& members : merged.members())
    for (const int region : members)
      drawing.slabs[static_cast<std::size_t>(region)] = {
          {low, high, common_floor(apart, members, &Slab::bottom), common_floor(apart, members, &Slab::top)}};
  return divided_drawing(solid, frame, std::move(drawing), merged, options);
}

/// With all of another complex beside what is there.
void append(CellComplex& all, const CellComplex& part) {
  const int curve = static_cast<int>(all.curves.size()), surface = static_cast<int>(all.surfaces.size()),
            vertex = static_cast<int>(all.vertices.size()), edge = static_cast<int>(all.edges.size()),
            face = static_cast<int>(all.faces.size());
  all.surfaces.insert(all.surfaces.end(), part.surfaces.begin(), part.surfaces.end());
  all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (geometry::CellCurve here : part.curves) {
    for (geometry::CellCurve::Trace& trace : here.traces) trace.surface.value += surface;
    all.curves.push_back(std::move(here));
  }
  for (geometry::CellEdge here : part.edges) {
    here.curve.value += curve;
    here.start.value += vertex;
    here.end.value += vertex;
    all.edges.push_back(here);
  }
  for (geometry::CellFace here : part.faces) {
    here.surface.value += surface;
    for (geometry::EdgeUse& use : here.loop) use.edge.value += edge;
    all.faces.push_back(std::move(here));
  }
  for (geometry::Cell here : part.cells) {
    for (geometry::CellFaceUse& use : here.faces) use.face.value += face;
    all.cells.push_back(std::move(here));
  }
}

SweptCells layered_along(const Brep& solid, const SweepFrame& frame, const SweptDrawing& whole,
                         const std::vector<double>& heights, const QuadrangulationOptions& options) {
  const double tolerance = 1e-7 * solid.size();
  SweptCells result{{}, frame.along, 0, static_cast<int>(heights.size())};
  double volume = 0;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const DividedDrawing divided = divided_layer(solid, frame, whole, heights[h], heights[h + 1], options);
    const MovingDrawing moving(solid, frame, divided.drawing, divided.quads);
    const Layers levels = layers(divided.quads, divided.drawing.slabs, moving, {}, tolerance);
    volume += column_volume(frame, divided.quads, moving, levels);
    result.quadrilaterals += static_cast<int>(divided.quads.quads.size());
    append(result.complex, column_complex(solid, frame, divided.quads, moving, levels));
  }
  if (!(std::abs(volume - solid.volume()) <= 1e-5 * solid.volume()))
    throw Error(ErrorCode::unsupported,
                fmt::format("its layers would have {:.6g} of its {:.6g} m^3", volume, solid.volume()));
  return result;
}

}  // namespace

std::optional<SweptCells> layered_cells(const Brep& solid, const QuadrangulationOptions& options) {
  std::optional<SweptCells> best;
  std::optional<Error> refusal;
  for (const SweepFrame& frame : sweep_frames(solid)) {
    try {
      const SweptDrawing whole = swept_drawing(solid, frame);
      const std::vector<double> heights = floor_heights(whole, 1e-7 * solid.size());
      if (heights.size() < 3) continue;
      SweptCells made = layered_along(solid, frame, whole, heights, options);
      if (!best || made.complex.cells.size() < best->complex.cells.size()) best = std::move(made);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      refusal = error;
    }
  }
  if (!best && refusal) throw *refusal;
  return best;
}

}  // namespace isopatch::segmentation
