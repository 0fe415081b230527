#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"
#include "berm/edge/edge.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/pipeline/scan_result.hpp"
#include "berm/piste/piste.hpp"

namespace berm {

/// What scans.csv says of a scan beside its name and stamp.
struct ScanFigures {
  LabelCounts counts;
  std::optional<SlopeAhead> slope;
  std::optional<double> obstacle_ahead_m;
  std::size_t left_vertices = 0;  ///< of the boundary
  std::size_t right_vertices = 0;
  std::optional<double> left_edge_m;  ///< horizontally from base_link to the nearest edge point of the road
  std::optional<double> right_edge_m;
  std::size_t edge_points = 0;
  std::optional<double> ground_tilt_rad;
  Degradations degraded;
};

[[nodiscard]] ScanFigures figures_of(const ScanResult& result, const Pose& T_base_sensor);

/// `text` as a field of a CSV file (RFC 4180): in quotes where it has to be.
[[nodiscard]] std::string csv_field(std::string_view text);

/// Seconds with nine decimals.
[[nodiscard]] std::string stamp_field(Stamp stamp_ns);

/// scans.csv: one line per labelled scan, an empty field for what is not known.
class ScanTable {
 public:
  explicit ScanTable(const std::filesystem::path& path);
  void add(const std::string& name, Stamp stamp_ns, const ScanFigures& figures);
  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
};

/// boundary.csv: the vertices of the boundary of the piste, scan by scan, in base_link.
class BoundaryTable {
 public:
  explicit BoundaryTable(const std::filesystem::path& path);
  void add(const std::string& name, std::span<const BoundaryPoint> left, std::span<const BoundaryPoint> right);
  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
};

/// edge_points.csv: the points on the edges of the road, scan by scan, in base_link.
class EdgePointTable {
 public:
  explicit EdgePointTable(const std::filesystem::path& path);
  void add(const std::string& name, std::span<const EdgePoint> points, const Pose& T_base_sensor);
  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
};

}  // namespace berm
