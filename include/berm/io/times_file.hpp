#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include "berm/core/stamp.hpp"

namespace berm {

/// What times.txt holds. Only the first `max_kept` stamps are kept, all are counted and checked.
struct TimesFile {
  std::vector<Stamp> stamps;
  std::size_t lines = 0;  ///< lines that hold a stamp
};

/// Reads times.txt: one number a line, the start of a scan in s, strictly increasing. Blank lines and lines that start
/// with '#' are skipped. Throws FileError with the number of the line.
[[nodiscard]] TimesFile read_times(const std::filesystem::path& path, std::size_t max_kept);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] TimesFile read_times(std::istream& input, const std::string& name, std::size_t max_kept);

/// Writes one stamp a line, s with 9 decimals. Throws FileError(write_failed) as AtomicFile.
void write_times(const std::filesystem::path& path, std::span<const Stamp> stamps);

}  // namespace berm
