#include "scan_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "berm/core/angle.hpp"

namespace berm {
namespace {

std::string field(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : std::string();
}

std::string degrees(const std::optional<double>& angle_rad) {
  return angle_rad ? field(*angle_rad * kDegPerRad) : std::string();
}

Eigen::Vector3d in_base_m(const EdgePoint& point, const Pose& T_base_sensor) {
  return T_base_sensor * Eigen::Vector3d(double{point.x_m}, double{point.y_m}, double{point.z_m});
}

std::optional<double> nearest_m(std::span<const EdgePoint> points, EdgeSide side, const Pose& T_base_sensor) {
  std::optional<double> nearest;
  for (const EdgePoint& point : points) {
    if (point.side == side) {
      const double distance_m = in_base_m(point, T_base_sensor).head<2>().norm();
      nearest = nearest ? std::min(*nearest, distance_m) : distance_m;
    }
  }
  return nearest;
}

}  // namespace

ScanFigures figures_of(const ScanResult& result, const Pose& T_base_sensor) {
  return {.counts = result.counts,
          .slope = result.piste.slope,
          .obstacle_ahead_m = result.piste.obstacle_ahead_m,
          .left_vertices = result.piste.left.size(),
          .right_vertices = result.piste.right.size(),
          .left_edge_m = nearest_m(result.edge.edges, EdgeSide::left, T_base_sensor),
          .right_edge_m = nearest_m(result.edge.edges, EdgeSide::right, T_base_sensor),
          .edge_points = result.edge.edges.size(),
          .ground_tilt_rad = result.ground_tilt_rad,
          .degraded = result.degraded};
}

std::string stamp_field(Stamp stamp_ns) {
  constexpr std::uint64_t kSecond_ns = 1'000'000'000;
  const bool negative = stamp_ns < 0;
  const auto size_ns = negative ? 0 - static_cast<std::uint64_t>(stamp_ns) : static_cast<std::uint64_t>(stamp_ns);
  return fmt::format("{}{}.{:09d}", negative ? "-" : "", size_ns / kSecond_ns, size_ns % kSecond_ns);
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of("\",\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

ScanTable::ScanTable(const std::filesystem::path& path) : file_(path) {
  file_.write(
      "scan,stamp,points,returns,no_return,invalid,falling_snow,drivable,terrain,obstacle,slope_deg,slope_sigma_deg,"
      "cross_fall_deg,cross_fall_sigma_deg,obstacle_ahead_m,left_vertices,right_vertices,"
      "left_edge_m,right_edge_m,edge_points,ground_tilt_deg,degraded\n");
}

void ScanTable::add(const std::string& name, Stamp stamp_ns, const ScanFigures& figures) {
  const LabelCounts& counts = figures.counts;
  std::string line = fmt::format("{},{},{},{},{},{},{},{},{},{}", csv_field(name), stamp_field(stamp_ns),
                                 counts.points(), counts.returns(), counts.no_return, counts.invalid,
                                 counts.falling_snow, counts.drivable, counts.terrain, counts.obstacle);
  std::optional<double> slope_rad;
  std::optional<double> slope_sigma_rad;
  std::optional<double> cross_fall_rad;
  std::optional<double> cross_fall_sigma_rad;
  if (figures.slope) {
    slope_rad = figures.slope->slope_rad;
    slope_sigma_rad = figures.slope->slope_sigma_rad;
    cross_fall_rad = figures.slope->cross_fall_rad;
    if (cross_fall_rad) {
      cross_fall_sigma_rad = figures.slope->cross_fall_sigma_rad;
    }
  }
  line += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{}\n", degrees(slope_rad), degrees(slope_sigma_rad),
                      degrees(cross_fall_rad), degrees(cross_fall_sigma_rad), field(figures.obstacle_ahead_m),
                      figures.left_vertices, figures.right_vertices, field(figures.left_edge_m),
                      field(figures.right_edge_m), figures.edge_points, degrees(figures.ground_tilt_rad),
                      figures.degraded.text());
  file_.write(line);
}

BoundaryTable::BoundaryTable(const std::filesystem::path& path) : file_(path) {
  file_.write("scan,side,x,y,z,confidence\n");
}

void BoundaryTable::add(const std::string& name, std::span<const BoundaryPoint> left,
                        std::span<const BoundaryPoint> right) {
  const std::string scan = csv_field(name);
  const auto write = [&](std::string_view side, std::span<const BoundaryPoint> points) {
    for (const BoundaryPoint& point : points) {
      file_.write(fmt::format("{},{},{:.3f},{:.3f},{:.3f},{:.2f}\n", scan, side, point.x_m, point.y_m, point.z_m,
                              point.confidence));
    }
  };
  write("left", left);
  write("right", right);
}

EdgePointTable::EdgePointTable(const std::filesystem::path& path) : file_(path) {
  file_.write("scan,side,kind,x,y,z,time,confidence,height,width\n");
}

void EdgePointTable::add(const std::string& name, std::span<const EdgePoint> points, const Pose& T_base_sensor) {
  const std::string scan = csv_field(name);
  for (const EdgePoint& point : points) {
    const Eigen::Vector3d p = in_base_m(point, T_base_sensor);
    file_.write(fmt::format("{},{},{},{:.3f},{:.3f},{:.3f},{:.6f},{:.2f},{:.2f},{:.2f}\n", scan,
                            point.side == EdgeSide::left ? "left" : "right",
                            point.kind == EdgeKind::rise ? "rise" : "drop", p.x(), p.y(), p.z(), point.time_s,
                            point.confidence, point.height_m, point.width_m));
  }
}

}  // namespace berm
