#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "geometry/io/byte_sink.hpp"

namespace isopatch::app {

/// Refuses a directory that could not be written, before any long work. Leaves the file system as it was.
/// @throws Error io, naming the directory and the reason
void check_writable(const std::filesystem::path& directory);

/// Removes the fields that an earlier run wrote, first their collections. Leaves all other files alone.
void remove_earlier_fields(const std::filesystem::path& directory);

/// Removes all that an earlier run wrote, and first of all its summary, which would vouch for files that are
/// being replaced. Leaves all other files alone.
void remove_earlier_results(const std::filesystem::path& directory);

/// Removes what an earlier comparison wrote. Leaves all other files alone.
void remove_earlier_comparison(const std::filesystem::path& directory);

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
