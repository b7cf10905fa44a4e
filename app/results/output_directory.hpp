#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "geometry/base/made_folders.hpp"
#include "geometry/io/byte_sink.hpp"

namespace isopatch::app {

/// Refuses a directory that could not be written, before any long work. Leaves the file system as it was.
/// @throws Error io, naming the directory and the reason
void check_writable(const std::filesystem::path& directory);

/// An output directory that one process alone writes to as long as the object lives.
class OutputFolder {
 public:
  /// Makes it with its parents and takes it.
  /// @throws Error io  naming the directory: it cannot be written, or another run writes to it
  explicit OutputFolder(std::filesystem::path directory);
  /// Gives it free. Folders that were made for it go again if nothing came into them; so they do where the
  /// program is interrupted.
  ~OutputFolder();
  OutputFolder(OutputFolder&&) = delete;

 private:
  std::filesystem::path directory_;
  std::vector<std::filesystem::path> made_;  ///< the outermost first
  MadeFolders removed_on_interrupt_;
  int descriptor_ = -1;
};

/// Removes the fields that an earlier run wrote, first their collections. Leaves all other files alone.
void remove_earlier_fields(const std::filesystem::path& directory);

/// The folder in which every load case has one of its own, where a study has cases.
inline constexpr const char* case_folder = "cases";

/// Removes all that an earlier run wrote, and first of all its summary, which would vouch for files that are
/// being replaced. Leaves all other files alone.
void remove_earlier_results(const std::filesystem::path& directory);

/// The folder in which every natural mode has one of its own.
inline constexpr const char* modes_folder = "modes";

/// Removes what an earlier `isopatch modes` wrote, first modes.json. Leaves all other files alone.
void remove_earlier_modes(const std::filesystem::path& directory);

/// Removes what an earlier comparison wrote. Leaves all other files alone.
void remove_earlier_comparison(const std::filesystem::path& directory);

/// Moves a file, relative to its folder, into another folder of the same file system.
/// @throws Error io
void move_in(const std::filesystem::path& from, const std::filesystem::path& to,
             const std::filesystem::path& file);

/// Writes a file of the directory, making its folder; it appears whole or not at all.
/// @param content  gives the bytes to a sink, piece by piece
/// @throws Error io
void write_in(const std::filesystem::path& directory, const std::filesystem::path& file,
              std::string_view bytes);
void write_in(const std::filesystem::path& directory, const std::filesystem::path& file,
              const std::function<void(const geometry::ByteSink&)>& content);
/// The same for bytes in any order.
void write_in_places(const std::filesystem::path& directory, const std::filesystem::path& file,
                     const std::function<void(const geometry::PlacedByteSink&)>& content);

}  // namespace isopatch::app
