#pragma once

#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace berm {

/// True edge of a road or piste, as one polyline in the world frame.
struct Edge {
  bool left = true;  ///< as seen by who drives the road
  std::vector<Eigen::Vector3d> vertices_m;
};

/// Reads edges.csv: the header `side,x,y,z`, then a vertex a line, side `left` or `right`. A polyline ends where the
/// side changes, and at a blank line. Lines that start with '#' are skipped. Throws FileError with the number of the
/// line: another header or side, no finite number, a coordinate beyond `kMaxCoordinate_m`, a polyline of one vertex;
/// also if the file is not there or unreadable.
[[nodiscard]] std::vector<Edge> read_edges(const std::filesystem::path& path);

/// The same from a stream; `name` stands for the file in errors.
[[nodiscard]] std::vector<Edge> read_edges(std::istream& input, const std::string& name);

/// Writes edges.csv with three decimals, and a blank line between polylines. What is written reads back the same to
/// 0.5 mm. Throws Error(invalid_argument) for a polyline of fewer than two vertices, FileError(write_failed) as
/// AtomicFile.
void write_edges(const std::filesystem::path& path, std::span<const Edge> edges);

}  // namespace berm
