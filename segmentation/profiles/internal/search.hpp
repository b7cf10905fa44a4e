#pragma once

#include <optional>
#include <set>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/cell_shape.hpp"
#include "segmentation/profiles/internal/curve.hpp"
#include "segmentation/profiles/internal/start.hpp"
#include "segmentation/profiles/internal/window.hpp"

namespace isopatch::segmentation::planar {

/// What a search works on and what it may use.
struct SearchInput {
  ShapeRules rules;
  const std::vector<Curve>& curves;
  std::vector<bool> shared;   ///< of each curve: whether there are wanted regions on both its sides
  CutPlaces candidates;       ///< of each curve
  bool near_corners = false;  ///< whether candidates count that are near the ends of their curve
};

/// Divides windows of a mesh anew, one after the other, where that costs less.
class Search {
 public:
  /// @param slide whether cuts of shared edges may be moved
  Search(const SearchInput& input, CellMesh mesh, unsigned seed, bool slide = false);

  /// Divides a region, where the mesh has no cells yet, from its corners alone, then with a few cuts: what
  /// has few corners is divided at best so, however thin it is.
  /// @param outline  places that are not optional
  bool fill(const std::vector<Place>& outline, int region);
  /// Until no triangle is left or a number of windows has been tried in vain.
  void remove_triangles(int tries);
  /// Divides a number of windows anew.
  void improve(int windows);

  /// Moves nodes to their best places.
  void polish();
  /// Moves nodes towards them so many times.
  /// @return  what has been gained
  double settle(int rounds);

  double cost() const;
  int triangles() const;
  bool is_valid() const;  ///< quadrilaterals only, all within the rules
  const CellMesh& mesh() const { return mesh_; }

 private:
  static constexpr int all_around = -1;
  struct Try {
    int room = 24;
    double leave_out = 1;
    bool join_anew = false;  ///< holes by new chords
    int places = 52;         ///< at most so many in the polygon, by leaving candidates out
    int inside = 0;          ///< nodes put inside: 0, 1, 2 or 4
    double slack = 0;        ///< how much more it may cost before nodes have been moved
  };
  bool divide_anew(int cell, const Try& what);
  void add_candidates(std::vector<Place>& places, int limit);
  bool add_nodes_inside(std::vector<Place>& places, int number, const std::vector<int>& cells);
  bool add_ring_inside(std::vector<Place>& places, const std::vector<Eigen::Vector2d>& outline);
  /// Places that a ring of nodes inside is put beside: corners, and more where the outline turns much.
  std::vector<std::size_t> ring_corners(const std::vector<Place>& places,
                                        const std::vector<SideShape>& shapes);
  /// Hangs a way through new nodes on a place.
  void hang(std::vector<Place>& places, std::size_t at, const std::vector<Eigen::Vector2d>& points);
  bool replace(const std::vector<int>& cells, const std::vector<Cell>& by, double gain,
               std::size_t nodes_before);
  /// Takes a part of the mesh that has become better: cells beside those that are gone, then new ones.
  void adopt(CellMesh part, const std::vector<double>& costs, const std::set<int>& gone,
             const std::set<int>& beside);
  double chance();
  bool may_move(const Node& node) const;

  const SearchInput* input_;
  CellMesh mesh_;
  Neighbours neighbours_;
  std::vector<double> costs_;
  Random random_;
  bool slide_;
};

}  // namespace isopatch::segmentation::planar
