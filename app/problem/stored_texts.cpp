#include "app/problem/stored_texts.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

#include "geometry/base/error.hpp"

namespace isopatch::app {

// As whole numbers of eight bytes, before them how many bytes there are.
void write_bytes(geometry::Hdf5Writer& file, const std::string& path, const std::string& bytes) {
  std::vector<std::int64_t> numbers(1 + (bytes.size() + 7) / 8, 0);
  numbers[0] = static_cast<std::int64_t>(bytes.size());
  if (!bytes.empty()) std::memcpy(&numbers[1], bytes.data(), bytes.size());
  file.write(path, numbers);
}

std::string read_bytes(const geometry::Hdf5Reader& file, const std::string& path) {
  const std::vector<std::int64_t> numbers = file.integers(path);
  const std::size_t room = numbers.empty() ? 0 : 8 * (numbers.size() - 1);
  const std::int64_t size = numbers.empty() ? -1 : numbers[0];
  if (size < 0 || static_cast<std::size_t>(size) > room)
    throw Error(ErrorCode::bad_format, fmt::format("'{}' has too few bytes", path));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (size > 0) std::memcpy(bytes.data(), &numbers[1], bytes.size());
  return bytes;
}

// One after the other, and their lengths.
void write_texts(geometry::Hdf5Writer& file, const std::string& path, const std::vector<std::string>& texts) {
  std::vector<std::int64_t> lengths;
  std::string all;
  for (const std::string& text : texts) {
    lengths.push_back(static_cast<std::int64_t>(text.size()));
    all += text;
  }
  file.write(path + "_lengths", lengths);
  write_bytes(file, path, all);
}

std::vector<std::string> read_texts(const geometry::Hdf5Reader& file, const std::string& path) {
  const std::string all = read_bytes(file, path);
  std::vector<std::string> texts;
  std::size_t begin = 0;
  for (const std::int64_t length : file.integers(path + "_lengths")) {
    if (length < 0 || static_cast<std::size_t>(length) > all.size() - begin)
      throw Error(ErrorCode::bad_format, fmt::format("'{}' has too few bytes", path));
    texts.push_back(all.substr(begin, static_cast<std::size_t>(length)));
    begin += static_cast<std::size_t>(length);
  }
  return texts;
}

}  // namespace isopatch::app
