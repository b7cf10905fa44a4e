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
  ElasticField field;                        ///< of the case that was asked for
  std::vector<Multiplier> multipliers;       ///< likewise
  geometry::PatchConnections connections;    ///< of the field's patches, with the study's names of faces
  std::string study;                         ///< text of the study file
  std::string summary;                       ///< text of summary.json
  std::string case_name = {};                ///< the load case of field and multipliers; "" without cases
  std::vector<std::string> case_names = {};  ///< of all cases and combinations in the file
};

/// The solution of a load case, as a file takes it.
struct CaseToStore {
  std::string name;
  const ElasticField& field;
  const std::vector<Multiplier>& multipliers;
};

/// The multi-patch model of the results: patches joined and named as in the study.
geometry::MultiPatch model_of(const StoredResult& result);

/// Encodes the results of one case as an HDF5 file; write the bytes with isopatch::write_file.
std::string to_hdf5(const StoredResult& result);

/// The same without a copy of the results: the bytes go to a sink, for example of an isopatch::AtomicWriter.
/// @param cases  at least one, all of one discretization; the first is what a reader without cases sees
void write_hdf5(const std::vector<CaseToStore>& cases, const geometry::PatchConnections& connections,
                const std::string& study, const std::string& summary, const geometry::ByteSink& sink);

/// Reads a result file and verifies its data against checksums.
/// @param case_name  the load case or combination that is wanted; "": the first
/// @throws Error io, bad_format, unsupported, naming the file and what is missing or wrong
/// @throws Error invalid_argument  a case that the file does not have, naming those that it has
StoredResult read_result(const std::filesystem::path& path, const std::string& case_name = "");

}  // namespace isopatch::iga
