#pragma once

#include <filesystem>
#include <string>

#include "iga/solve_elasticity.hpp"

namespace isopatch::iga {

/// What a result file holds, enough to post-process without solving again.
struct StoredResult {
  ElasticField field;
  std::vector<Multiplier> multipliers;
  std::string study;    ///< text of the study file
  std::string summary;  ///< text of summary.json
};

/// The bytes of an HDF5 file; place them with isopatch::write_file.
std::string to_hdf5(const StoredResult& result);

/// @throws Error io, bad_format, naming the file and what is missing or wrong
StoredResult read_result(const std::filesystem::path& path);

}  // namespace isopatch::iga
