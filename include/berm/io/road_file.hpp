#pragma once

#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/road.hpp"

namespace berm {

/// How a verdict is written: "holds", "uncertain", "broken"; empty for unknown.
[[nodiscard]] std::string_view verdict_name(RuleVerdict verdict);

/// Writes road.csv, a station a line, see docs/road.md: metres with three decimals, the heading in degrees, slopes in
/// percent; an empty field for what is not known. What is written reads back the same to half a unit of the last.
/// Throws Error(invalid_argument) for what `read_road` would not read; FileError(write_failed) as AtomicFile.
void write_road(const std::filesystem::path& path, std::span<const RoadStation> stations);

/// Reads what `write_road` wrote. Throws FileError with the number of the line: another header, a number of columns
/// that is not the header's, a piece or a chainage that falls, a coordinate beyond `kMaxCoordinate_m`, a value without
/// its sigma, a sigma below 0, a word that is no verdict; also if the file is not there or unreadable.
[[nodiscard]] std::vector<RoadStation> read_road(const std::filesystem::path& path);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] std::vector<RoadStation> read_road(std::istream& input, const std::string& name);

}  // namespace berm
