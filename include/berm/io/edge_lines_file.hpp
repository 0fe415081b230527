#pragma once

#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include "berm/core/edge.hpp"

namespace berm {

/// Reads the edges.csv of a run: the header `line,side,x,y,z,confidence,berm_height_m`, then a vertex a line; the last
/// column may be empty, or left out with its name. A line ends where the number changes; numbers rise. Throws FileError
/// with the number of the line: another header, a number that is no whole one or falls, a side that changes within a
/// line, a coordinate beyond `kMaxCoordinate_m`, a confidence outside of 0..1, a height that is no number, a line of
/// one vertex; also if the file is not there or unreadable.
[[nodiscard]] std::vector<EdgeLine> read_edge_lines(const std::filesystem::path& path);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] std::vector<EdgeLine> read_edge_lines(std::istream& input, const std::string& name);

/// Writes edges.csv, lines numbered from 0, with three decimals. What is written reads back the same to half a unit of
/// the last. Throws Error(invalid_argument) for a line of fewer than two vertices, a coordinate that is not finite or
/// beyond `kMaxCoordinate_m`, a confidence outside of 0..1, a height that is
/// not finite or beyond `kMaxCoordinate_m`; FileError(write_failed) as AtomicFile.
void write_edge_lines(const std::filesystem::path& path, std::span<const EdgeLine> lines);

}  // namespace berm
