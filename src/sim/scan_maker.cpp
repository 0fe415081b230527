#include "berm/sim/scan_maker.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "beam_pose.hpp"
#include "berm/core/error.hpp"
#include "scan_scratch.hpp"

namespace berm::sim {

ScanScratch::ScanScratch() : memory_(std::make_unique<Memory>()) {}
ScanScratch::~ScanScratch() = default;
ScanScratch::ScanScratch(ScanScratch&&) noexcept = default;
ScanScratch& ScanScratch::operator=(ScanScratch&&) noexcept = default;

ScanMaker::ScanMaker(const Sensor& sensor, const Pose& T_base_sensor, const RayCaster& caster, const Weather& weather,
                     const Trajectory& T_world_base, std::uint64_t seed)
    : sensor_(sensor),
      pattern_(sensor.pattern),
      T_base_sensor_(T_base_sensor),
      caster_(caster),
      weather_(weather),
      T_world_base_(T_world_base),
      seed_(seed) {
  sensor_.check();
}

void ScanMaker::aim(std::size_t index, Stamp stamp_ns, ScanScratch::Memory& memory) const {
  pattern_.beams_of_scan(index, memory.beams);
  const Beams& beams = memory.beams;
  WorldRays& rays = memory.rays;
  rays.resize(beams.size());
  if (beams.size() == 0) {
    return;
  }
  const std::vector<StampedPose>& poses = T_world_base_.poses();
  const Stamp last_ns = stamp_ns + from_seconds(static_cast<double>(beams.time_s.back()));
  if (poses.size() < 2 || stamp_ns < poses.front().stamp_ns || last_ns > poses.back().stamp_ns) {
    throw Error(ErrorCode::invalid_argument, fmt::format("scan {}: the trajectory does not cover {} to {} s", index,
                                                         to_seconds(stamp_ns), to_seconds(last_ns)));
  }
  auto next = std::upper_bound(poses.begin() + 1, poses.end() - 1, stamp_ns,
                               [](Stamp stamp, const StampedPose& pose) { return stamp < pose.stamp_ns; });
  std::size_t beam = 0;
  while (beam < beams.size()) {
    const StampedPose& from = *(next - 1);
    const ScrewMotion motion(from.T_world_base, next->T_world_base, T_base_sensor_);
    const double start_s = to_seconds(stamp_ns - from.stamp_ns);
    const double lasts_s = to_seconds(next->stamp_ns - from.stamp_ns);
    const bool last = next + 1 == poses.end();
    Placed placed;
    for (; beam < beams.size(); ++beam) {
      const double since_s = start_s + static_cast<double>(beams.time_s[beam]);
      if (since_s > lasts_s && !last) {
        break;
      }
      motion.at(since_s / lasts_s, placed);
      const Eigen::Vector3d direction{beams.x[beam], beams.y[beam], beams.z[beam]};
      const Eigen::Vector3f turned = (placed.rotation * direction).cast<float>();
      rays.x_m[beam] = static_cast<float>(placed.origin_m.x());
      rays.y_m[beam] = static_cast<float>(placed.origin_m.y());
      rays.z_m[beam] = static_cast<float>(placed.origin_m.z());
      rays.dx[beam] = turned.x();
      rays.dy[beam] = turned.y();
      rays.dz[beam] = turned.z();
      rays.time_s[beam] = to_seconds(stamp_ns) + static_cast<double>(beams.time_s[beam]);
    }
    ++next;
  }
}

void ScanMaker::make(std::size_t index, MadeScan& scan) const {
  ScanScratch::Memory& memory = *scan.scratch.memory_;
  scan.stamp_ns = from_seconds(static_cast<double>(index) / sensor_.pattern.scan_hz);
  aim(index, scan.stamp_ns, memory);
  const Beams& beams = memory.beams;
  const WorldRays& rays = memory.rays;
  scan.beams = beams.size();
  scan.points.clear();
  scan.labels.clear();
  for (std::size_t beam = 0; beam < beams.size(); ++beam) {
    Hit hit;
    const bool met =
        caster_.cast({rays.x_m[beam], rays.y_m[beam], rays.z_m[beam]}, {rays.dx[beam], rays.dy[beam], rays.dz[beam]},
                     sensor_.optics.min_range_m, sensor_.optics.max_range_m, rays.time_s[beam], hit);
    if (!met && !sensor_.optics.keeps_no_returns) {
      continue;
    }
    const auto range_m = static_cast<float>(met ? hit.range_m : 0.0);
    scan.points.x.push_back(range_m * beams.x[beam]);
    scan.points.y.push_back(range_m * beams.y[beam]);
    scan.points.z.push_back(range_m * beams.z[beam]);
    scan.points.intensity.push_back(
        met ? static_cast<float>(std::min(255.0, optics_of(hit.material.surface).reflectivity)) : 0.0F);
    scan.points.time.push_back(beams.time_s[beam]);
    if (!beams.ring.empty()) {
      scan.points.ring.push_back(beams.ring[beam]);
    }
    scan.labels.push_back(met ? hit.material.truth_id : truth::kNone);
  }
}

void ScanMaker::check_start(const Terrain& terrain) const {
  if (T_world_base_.empty()) {
    throw Error(ErrorCode::invalid_argument, "sensor: there is no trajectory");
  }
  const Pose T_world_sensor = T_world_base_.poses().front().T_world_base * T_base_sensor_;
  const Eigen::Vector3d origin_m = T_world_sensor.translation_m();
  const double above_m = origin_m.z() - terrain.at(origin_m.x(), origin_m.y()).height_m;
  if (above_m <= 0.0) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("sensor: starts {:.2f} m below the terrain; mount it higher, or start elsewhere "
                            "(vehicle.start_m)",
                            -above_m));
  }
}

}  // namespace berm::sim
