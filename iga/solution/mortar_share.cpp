#include "iga/solution/mortar_share.hpp"

#include <algorithm>

namespace isopatch::iga {
MortarShare mortar_share(const MortarConstraints& all, const std::vector<PatchLayers>& parts) {
  MortarShare result;
  MortarConstraints& own = result.constraints;
  own.ties = ties_of(all.ties, parts);
  own.first_row.push_back(0);
  for (const MortarFace& face : own.ties.faces) {
    const auto f = static_cast<std::size_t>(
        std::find_if(all.ties.faces.begin(), all.ties.faces.end(),
                     [&](const MortarFace& other) { return other.slave == face.slave; }) -
        all.ties.faces.begin());
    for (int row = all.first_row[f]; row < all.first_row[f + 1]; ++row) {
      result.rows.push_back(row);
      own.component.push_back(all.component[static_cast<std::size_t>(row)]);
      own.size.push_back(all.size[static_cast<std::size_t>(row)]);
    }
    own.first_row.push_back(static_cast<int>(result.rows.size()));
  }
  own.jumps.resize(static_cast<Eigen::Index>(result.rows.size()), all.jumps.cols());
  own.jumps.reserve(all.jumps.nonZeros());
  for (std::size_t row = 0; row < result.rows.size(); ++row)
    own.jumps.row(static_cast<Eigen::Index>(row)) = all.jumps.row(result.rows[row]);
  own.jumps.makeCompressed();
  return result;
}

std::vector<int> processes_of_mortar(const MortarConstraints& all, const Distribution& distribution) {
  std::vector<int> result(static_cast<std::size_t>(all.rows()), 0);
  for (std::size_t f = 0; f < all.ties.faces.size(); ++f)
    for (std::size_t process = 0; process < distribution.size(); ++process)
      for (const PatchShare& share : distribution[process])
        if (share.couples && share.patch == all.ties.faces[f].slave.patch.value)
          std::fill(result.begin() + all.first_row[f], result.begin() + all.first_row[f + 1],
                    static_cast<int>(process));
  return result;
}

Eigen::VectorXd whole_mortar(const MortarShare& share, const Eigen::VectorXd& values, int all_rows,
                             const solvers::Processes& processes) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(all_rows);
  for (std::size_t i = 0; i < share.rows.size(); ++i)
    result[share.rows[i]] = values[static_cast<Eigen::Index>(i)];
  if (processes.count() > 1) processes.sum(result);
  return result;
}

}  // namespace isopatch::iga
