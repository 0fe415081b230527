#include "truck_recording.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "berm/io/pcd.hpp"
#include "support/made_nmea.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm::test {
namespace {

constexpr double kSensorHeight_m = 4.0;
constexpr int kColumns = 900;
constexpr int kRings = 16;
constexpr Stamp kScan_ns = 100'000'000;

/// Corners of the profile across the road, to one side: road, berm of 1.2 m, level ground.
constexpr std::array<std::array<double, 2>, 5> kProfile = {
    {{0.0, 0.0}, {TruckDrive::kHalfWidth_m, 0.0}, {TruckDrive::kHalfWidth_m + 1.7, 1.2}, {11.4, 0.0}, {90.0, 0.0}}};

/// Range of a beam that goes `across` to the side and `up` per metre; 0 if it meets nothing.
double cast(double across, double up) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < kProfile.size(); ++i) {
    const auto [y0, z0] = kProfile[i];
    const auto [y1, z1] = kProfile[i + 1];
    const double slope = (z1 - z0) / (y1 - y0);
    // kSensorHeight_m + r up = z0 + slope (r across - y0)
    const double r = (z0 - slope * y0 - kSensorHeight_m) / (up - slope * across);
    if (r > 0.0 && r * across >= y0 && r * across <= y1) {
      nearest = std::min(nearest, r);
    }
  }
  return nearest < 100.0 ? nearest : 0.0;
}

}  // namespace

Pose TruckDrive::T_world_base(Stamp stamp_ns) const {
  const double way_m = kSpeed_mps * to_seconds(stamp_ns - start_ns);
  return Pose::from_yaw_pitch_roll(
      heading_rad, 0.0, 0.0, origin_m + way_m * Eigen::Vector3d(std::cos(heading_rad), std::sin(heading_rad), 0.0));
}

Trajectory TruckDrive::poses() const {
  Trajectory trajectory;
  for (std::size_t i = 0; i <= 2 * scans + 1; ++i) {
    const Stamp stamp_ns = start_ns + static_cast<Stamp>(i) * kScan_ns / 2;
    trajectory.append(stamp_ns, T_world_base(stamp_ns));
  }
  return trajectory;
}

double TruckDrive::offset_m(const Eigen::Vector3d& position_m) const {
  const Eigen::Vector3d from_m = position_m - origin_m;
  return std::cos(heading_rad) * from_m.y() - std::sin(heading_rad) * from_m.x();
}

double TruckDrive::chainage_m(const Eigen::Vector3d& position_m) const {
  const Eigen::Vector3d from_m = position_m - origin_m;
  return std::cos(heading_rad) * from_m.x() + std::sin(heading_rad) * from_m.y();
}

Machine haul_truck() {
  return read_machine(std::filesystem::path(BERM_MACHINES_FOLDER) / "haul_truck.yaml");
}

Scan truck_scan(std::size_t index) {
  PointChannels channels;
  std::mt19937 random(static_cast<std::uint32_t>(index) + 1);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (int column = 0; column < kColumns; ++column) {
    const double azimuth = std::numbers::pi - 2.0 * std::numbers::pi * (column + 0.5) / kColumns;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation = (2.0 * ring - 15.0) * kRadPerDeg;
      const double level = std::cos(elevation);
      const double hit = cast(level * std::abs(std::sin(azimuth)), std::sin(elevation));
      const double range = hit > 0.0 ? hit + noise(random) : 0.0;
      channels.x.push_back(static_cast<float>(range * level * std::cos(azimuth)));
      channels.y.push_back(static_cast<float>(range * level * std::sin(azimuth)));
      channels.z.push_back(static_cast<float>(range * std::sin(elevation)));
      channels.intensity.push_back(hit > 0.0 ? static_cast<float>(20 + (column + ring) % 30) : 0.0F);
      channels.time.push_back(static_cast<float>(0.1 * column / kColumns));
      channels.ring.push_back(static_cast<std::uint16_t>(ring));
    }
  }
  return {.stamp_ns = static_cast<Stamp>(index) * kScan_ns,
          .cloud = PointCloud(std::move(channels)),
          .T_base_sensor = haul_truck().mount.T_base_sensor()};
}

void make_truck_recording(const std::filesystem::path& folder, const TruckDrive& drive) {
  std::filesystem::create_directories(folder / "scans");
  std::string times;
  for (std::size_t i = 0; i < drive.scans; ++i) {
    write_pcd(folder / "scans" / (scan_name(i) + ".pcd"), truck_scan(i).cloud.view());
    times += fmt::format("{:.9f}\n", to_seconds(drive.start_ns + static_cast<Stamp>(i) * kScan_ns));
  }
  spill(folder / "times.txt", times);
}

std::string as_tum(const Trajectory& poses) {
  std::string text;
  for (const StampedPose& pose : poses.poses()) {
    const Eigen::Vector3d& p = pose.T_world_base.translation_m();
    const Eigen::Quaterniond& q = pose.T_world_base.rotation();
    text += fmt::format("{:.9f} {:.6f} {:.6f} {:.6f} {:.9f} {:.9f} {:.9f} {:.9f}\n", to_seconds(pose.stamp_ns), p.x(),
                        p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

std::string as_csv(const Trajectory& poses) {
  std::string text = "t_ns,x,y,z,qx,qy,qz,qw\n";
  for (const StampedPose& pose : poses.poses()) {
    const Eigen::Vector3d& p = pose.T_world_base.translation_m();
    const Eigen::Quaterniond& q = pose.T_world_base.rotation();
    text += fmt::format("{},{:.6f},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f},{:.9f}\n", pose.stamp_ns, p.x(), p.y(), p.z(),
                        q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

std::string as_nmea(const Trajectory& poses, const Geodetic& datum) {
  const LocalFrame frame(datum);
  std::string text;
  for (const StampedPose& pose : poses.poses()) {
    const Geodetic place = frame.to_geodetic(pose.T_world_base.translation_m());
    const Stamp ms = pose.stamp_ns / 1'000'000;
    const auto degrees_minutes = [](double value_deg, int width) {
      const double whole_deg = std::floor(std::abs(value_deg));
      return fmt::format("{:0{}.0f}{:011.8f}", whole_deg, width, 60.0 * (std::abs(value_deg) - whole_deg));
    };
    text += sentence(fmt::format("GNGGA,{:02}{:02}{:02}.{:03},{},{},{},{},4,14,0.7,{:.4f},M,0.0,M,1.0,0001",
                                 ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60, ms % 1000,
                                 degrees_minutes(place.lat_deg, 2), place.lat_deg < 0.0 ? 'S' : 'N',
                                 degrees_minutes(place.lon_deg, 3), place.lon_deg < 0.0 ? 'W' : 'E', place.h_m));
    const Eigen::Vector3d forward = pose.T_world_base.rotation() * Eigen::Vector3d::UnitX();
    const double heading_deg = std::fmod(450.0 - std::atan2(forward.y(), forward.x()) / kRadPerDeg, 360.0);
    text += sentence(fmt::format("GNHDT,{:.5f},T", heading_deg));
  }
  return text;
}

}  // namespace berm::test
