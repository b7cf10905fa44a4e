#pragma once

#include <Eigen/Core>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/base/processor_stopwatch.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/decomposition/combinatorics/decomposition_search.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"

namespace isopatch::segmentation {

/// Cells of a search, each cut for itself: what the handles of `SearchCell` stand for.
class CellStore {
 public:
  /// @param time_limit  seconds of this process's computing from now, after which `cut` refuses everything
  CellStore(geometry::Brep source, const CutOptions& options, double time_limit)
      : source_(std::move(source)), options_(options), time_limit_(time_limit) {}

  /// A cell by itself.
  SearchCell add(const geometry::CellComplex& complex, geometry::CellId cell);

  /// Says where the places of a loop are to be, m.
  void propose(int handle, const CuttingLoop& loop, const std::vector<Eigen::Vector3d>& places);

  /// Cuts by geometry, and remembers what came of it and where places were.
  CutAnswer cut(const SearchCell& cell, const CuttingLoop& loop);

  struct Entry {
    geometry::CellComplex complex;
    geometry::CellId cell;
    CellSides sides;
    bool polyhedral = false;    ///< plane sides and straight edges: stays so, by plane cuts
    Eigen::Matrix3Xd boundary;  ///< its triangles, once they were asked for
  };
  const geometry::Brep& source() const { return source_; }
  const CutOptions& options() const { return options_; }
  const Entry& entry(int handle) const { return entries_[static_cast<std::size_t>(handle)]; }

  /// From now on cuts may be of free form; those refused before are tried again.
  void allow_free_form();

  double seconds() const { return watch_.seconds(); }
  double time_limit() const { return time_limit_; }
  void set_time_limit(double seconds) { time_limit_ = seconds; }
  bool time_is_up() const { return seconds() > time_limit_; }

  /// Why cuts were refused, each reason with how often, without its figures.
  const std::map<std::string, int>& refusals() const { return refusals_; }

  /// Where the places of a loop are that a cell was cut along, m.
  std::vector<Eigen::Vector3d> places(int handle, const CuttingLoop& loop) const;

 private:
  geometry::Brep source_;
  CutOptions options_;
  double time_limit_;
  ProcessorStopwatch watch_;
  CutAnswer refused(const std::string& why);
  CutAnswer make_cut(const SearchCell& cell, const CuttingLoop& loop);

  std::deque<Entry> entries_;
  std::map<std::string, int> refusals_;
  std::map<std::pair<int, CuttingLoop>, std::vector<Eigen::Vector3d>> proposed_, places_;
  std::map<std::pair<int, CuttingLoop>, CutAnswer> answers_;
};

}  // namespace isopatch::segmentation
