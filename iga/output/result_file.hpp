#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/io/byte_sink.hpp"
#include "geometry/patch_connections.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::iga {

/// What a result file holds, enough to post-process without solving again.
struct StoredResult {
  ElasticField field;
  std::vector<Multiplier> multipliers;
  geometry::PatchConnections connections;  ///< of the field's patches, with the study's names of faces
  std::string study;                       ///< text of the study file
  std::string summary;                     ///< text of summary.json
};

/// The multi-patch model of the results: patches joined and named as in the study.
geometry::MultiPatch model_of(const StoredResult& result);

/// Encodes results as an HDF5 file; write the bytes with isopatch::write_file.
std::string to_hdf5(const StoredResult& result);

/// The same without a copy of the results: the bytes go to a sink, for example of an isopatch::AtomicWriter.
void write_hdf5(const ElasticField& field, const std::vector<Multiplier>& multipliers,
                const geometry::PatchConnections& connections, const std::string& study,
                const std::string& summary, const geometry::ByteSink& sink);

/// Reads a result file and verifies its data against checksums.
/// @throws Error io, bad_format, unsupported, naming the file and what is missing or wrong
StoredResult read_result(const std::filesystem::path& path);

}  // namespace isopatch::iga
