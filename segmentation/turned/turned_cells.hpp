#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"
#include "segmentation/turned/turned_request.hpp"

namespace isopatch::segmentation {

/// A solid as rings of hexahedra over quadrilaterals of its half profile, and a column of them along its
/// axis.
struct TurnedCells {
  geometry::CellComplex complex;  ///< of hexahedra that meet side to side
  Eigen::Vector3d about;          ///< direction of the axis, unit
  double sweep;                   ///< rad, 2 pi of a whole turn
  int quadrilaterals = 0, sectors = 0;
  int along_axis = 0;  ///< hexahedra in columns
};

/// Whether each face is a surface of revolution about one axis, but for two plane ends through it.
/// @cost  a few evaluations of each face
bool is_turned(const geometry::Brep& solid);

/// The axis of a solid that `turned_cells` will look at, prisms about it included; nothing of others.
/// @cost  as above
std::optional<Eigen::Vector3d> turned_about(const geometry::Brep& solid);

/// Divides a solid that is turned: each face is a surface of revolution about one axis. So are balls, tori,
/// shafts with rounds, pulleys without holes. Or, turned by an angle, it ends in two planes through the axis:
/// bends of pipes and bars.
///
/// The half profile is divided into quadrilaterals, which are turned in sectors of at most 90 degrees. Where
/// material reaches the axis, a square column of hexahedra runs along it, whose ends lie on planes, spheres
/// or ellipsoids. Faces away from the axis are exact.
///
/// A whole turn may have regular prisms of 4, 6, 8 or 12 sides about its axis, all of as many and with
/// corners at the same angles: sockets of screws, square ends. Then it is divided in as many sectors, and the
/// column along the axis in half as many less one.
/// @param lines  straight pieces in the ends of what is no whole turn, m: they become sides of hexahedra
/// @return  nothing for a solid that is not turned
/// @throws Error unsupported  it looks like one, but has a point or an edge on its axis, or a half profile
/// that cannot be divided: names the place
std::optional<TurnedCells> turned_cells(const geometry::Brep& solid,
                                        const std::vector<std::array<Eigen::Vector3d, 2>>& lines = {},
                                        const QuadrangulationOptions& options = {});

/// The same of a whole turn, as asked for.
/// @return  nothing for a solid that is not turned, or not by a whole turn
/// @throws Error unsupported  as above, or a ray that meets nothing, or other than 4 sectors about a column
std::optional<TurnedCells> turned_cells(const geometry::Brep& solid, const TurnedRequest& request,
                                        const QuadrangulationOptions& options = {});

}  // namespace isopatch::segmentation
