#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/study/stage.hpp"

namespace isopatch::app {

/// How a stage came to its result.
struct StageReport {
  Stage stage = Stage::solid;
  bool kept = false;                ///< by an earlier run, and taken as it was
  std::filesystem::path file = {};  ///< that has it; empty where nothing is kept
  std::string made = {};            ///< when: "2026-11-30 09:40 UTC"; "" where nothing is kept
  double seconds = 0;               ///< that making it took, then
  std::uint64_t content = 0;        ///< number of the file's bytes
  std::string problem = {};         ///< why it could not be kept
  bool operator==(const StageReport&) const = default;
};

/// "solids.h5", ...: what the file of a stage is called; of the solution it is in the folder above.
const char* stage_file(Stage stage);

/// A number that another build of the program does not have: of its version, and of size and time of its
/// files.
std::uint64_t build_stamp();

/// The results of stages in a folder, one file for each stage, of the last run that made it. `stages.json`
/// beside them says what they were made of; a file counts if its bytes are those that are written down there.
///
/// Files appear whole or not at all. Of several processes one may write; the others see a stage as it was or
/// as it is, or not at all.
class StageFolder {
 public:
  explicit StageFolder(StageOptions options) : options_(std::move(options)) {}

  /// Whether anything is kept at all.
  bool is_used() const { return !options_.folder.empty(); }
  /// The result that an earlier run kept, if it was made of the same and is not to be made anew.
  /// @param key  of all that the result depends on
  std::optional<StageReport> kept(Stage stage, std::uint64_t key) const;
  /// Whatever an earlier run kept, for pictures.
  std::optional<StageReport> last(Stage stage) const;
  /// Keeps a result in the place of an earlier one. Never throws: the report says what went wrong.
  StageReport keep(Stage stage, std::uint64_t key, std::string_view bytes, double seconds) const;

 private:
  std::filesystem::path path(Stage stage) const;
  StageOptions options_;
};

/// "solid as before (2026-11-30 09:40 UTC); hexahedra in 4.2 s; kept in results/stages", for people.
std::string stages_text(const std::vector<StageReport>& stages);

}  // namespace isopatch::app
