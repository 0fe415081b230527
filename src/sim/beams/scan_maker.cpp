#include "berm/sim/scan_maker.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "beam_footprint.hpp"
#include "beam_pose.hpp"
#include "berm/core/error.hpp"
#include "echo_maker.hpp"
#include "scan_scratch.hpp"

namespace berm::sim {
namespace {

/// How far below the sensor the ground is looked for.
constexpr double kHighest_m = 1000.0;

/// How many lasers fire in turn: the next beam of the same laser is that many on.
std::size_t lasers_of(const Beams& beams, const PatternConfig& pattern) {
  if (!beams.ring.empty()) {
    return std::size_t{*std::max_element(beams.ring.begin(), beams.ring.end())} + 1;
  }
  return pattern.kind == "swirl" ? static_cast<std::size_t>(pattern.fan_lasers) : 1;
}

void resize(PointChannels& points, std::size_t rings, std::size_t size) {
  for (std::vector<float>* channel : {&points.x, &points.y, &points.z, &points.intensity, &points.time}) {
    channel->resize(size);
  }
  points.ring.resize(rings);
}

/// Whether most of six rays, one to each side, meet something standing or moving from behind. A house without a floor
/// counts, a net or a board beside the sensor does not.
bool is_inside(const RayCaster& caster, const Eigen::Vector3d& origin_m, double time_s) {
  const Eigen::Vector3f origin = origin_m.cast<float>();
  RayPacket packet{};
  packet.x_m.fill(origin.x());
  packet.y_m.fill(origin.y());
  packet.z_m.fill(origin.z());
  packet.time_s.fill(time_s);
  packet.max_range_m.fill(-1.0F);
  for (std::size_t side = 0; side < 6; ++side) {
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
    direction[static_cast<Eigen::Index>(side / 2)] = side % 2 == 0 ? 1.0F : -1.0F;
    packet.dx[side] = direction.x();
    packet.dy[side] = direction.y();
    packet.dz[side] = direction.z();
    packet.max_range_m[side] = static_cast<float>(kHighest_m);
  }
  caster.cast(packet);
  int behind = 0;
  for (std::size_t side = 0; side < 6; ++side) {
    const RawHit& hit = packet.hits[side];
    behind += !hit.is_nothing() && hit.object != 0 && hit.normal.dot(packet.direction(side)) > 0.0F ? 1 : 0;
  }
  return behind >= 4;
}

}  // namespace

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

struct ScanMaker::Place {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();  ///< z axis of the sensor
};

ScanMaker::Place ScanMaker::aim(std::size_t index, Stamp stamp_ns, ScanScratch::Memory& memory) const {
  const Beams& beams = memory.beams;
  Place place;
  memory.rays.resize(beams.size());
  if (beams.size() == 0) {
    return place;
  }
  const std::vector<StampedPose>& poses = T_world_base_.poses();
  const Stamp last_ns = stamp_ns + from_seconds(static_cast<double>(beams.time_s.back()));
  if (poses.size() < 2 || stamp_ns < poses.front().stamp_ns || last_ns > poses.back().stamp_ns) {
    throw Error(ErrorCode::invalid_argument, fmt::format("scan {}: the trajectory does not cover {} to {} s", index,
                                                         to_seconds(stamp_ns), to_seconds(last_ns)));
  }
  auto next = std::upper_bound(poses.begin() + 1, poses.end() - 1, stamp_ns,
                               [](Stamp stamp, const StampedPose& pose) { return stamp < pose.stamp_ns; });
  Placed placed;
  std::size_t beam = 0;
  for (; beam < beams.size(); ++next) {
    const StampedPose& from = *(next - 1);
    const ScrewMotion motion(from.T_world_base, next->T_world_base, T_base_sensor_);
    const double start_s = to_seconds(stamp_ns - from.stamp_ns);
    const double lasts_s = to_seconds(next->stamp_ns - from.stamp_ns);
    const bool last = next + 1 == poses.end();
    DensePoses dense(motion, lasts_s);
    if (beam == 0) {
      motion.at(start_s / lasts_s, placed);
      place = {placed.origin_m, placed.rotation.col(2).cast<float>()};
    }
    for (; beam < beams.size(); ++beam) {
      const double since_s = start_s + static_cast<double>(beams.time_s[beam]);
      if (since_s > lasts_s && !last) {
        break;
      }
      dense.at(since_s, placed);
      const Eigen::Vector3d direction = Eigen::Vector3f{beams.x[beam], beams.y[beam], beams.z[beam]}.cast<double>();
      TracedRay& ray = memory.rays[beam];
      ray = {};
      ray.origin_m = placed.origin_m.cast<float>();
      ray.direction = (placed.rotation * direction).cast<float>();
      ray.time_s = to_seconds(stamp_ns) + static_cast<double>(beams.time_s[beam]);
      ray.beam = static_cast<std::uint32_t>(beam);
    }
  }
  return place;
}

void ScanMaker::cast(const Place& place, ScanScratch::Memory& memory) const {
  const auto max_range_m = static_cast<float>(sensor_.optics.max_range_m);
  const std::size_t lasers = lasers_of(memory.beams, sensor_.pattern);
  const std::size_t beams = memory.beams.size();
  cast_all(caster_, memory.rays, lasers, max_range_m);
  find_torn(caster_, memory.beams, lasers, sensor_.optics, memory.rays, memory.torn);
  const auto torn = static_cast<std::size_t>(std::count(memory.torn.begin(), memory.torn.end(), 1));
  memory.rays.resize(beams + kFootprintRays * torn);
  std::size_t first = beams;
  for (std::size_t beam = 0; beam < beams; ++beam) {
    if (memory.torn[beam] != 0) {
      const std::span<TracedRay> rays(&memory.rays[first], kFootprintRays);
      spread(memory.rays[beam], place.up, sensor_.optics, memory.randoms[beam], rays);
      // The middle is done: its light is in the others.
      memory.rays[beam].hit = {};
      first += kFootprintRays;
    }
  }
  cast_all(caster_, std::span(memory.rays).subspan(beams), 1, max_range_m);
  settle(caster_, memory.rays, max_range_m, memory.randoms, memory.pending);
}

void ScanMaker::make(std::size_t index, MadeScan& scan) const {
  ScanScratch::Memory& memory = *scan.scratch.memory_;
  scan.stamp_ns = from_seconds(static_cast<double>(index) / sensor_.pattern.scan_hz);
  pattern_.beams_of_scan(index, memory.beams);
  const Beams& beams = memory.beams;
  memory.randoms.clear();
  for (std::size_t beam = 0; beam < beams.size(); ++beam) {
    memory.randoms.emplace_back(seed_, Purpose::beam, index, beam);
  }
  const Place place = aim(index, scan.stamp_ns, memory);
  cast(place, memory);
  Hit below;
  const bool over_ground = caster_.cast(place.origin_m, -Eigen::Vector3d::UnitZ(), 0.0, kHighest_m, 0.0, below);
  const double height_m = over_ground ? below.range_m : kHighest_m;

  scan.beams = beams.size();
  write(height_m, memory, scan);
}

void ScanMaker::write(double height_m, ScanScratch::Memory& memory, MadeScan& scan) const {
  const Beams& beams = memory.beams;
  const EchoMaker maker(caster_, weather_, sensor_.optics);
  std::array<FiredBeam, EchoMaker::kBlock> fired;
  std::array<Return, EchoMaker::kBlock> returns;
  resize(scan.points, beams.ring.empty() ? 0 : beams.size(), beams.size());
  scan.labels.resize(beams.size());
  std::size_t spread = beams.size();
  std::size_t written = 0;
  for (std::size_t first = 0; first < beams.size(); first += EchoMaker::kBlock) {
    const std::size_t count = std::min(EchoMaker::kBlock, beams.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t beam = first + i;
      fired[i] = {{&memory.rays[beam], 1}, &memory.randoms[beam]};
      if (memory.torn[beam] != 0) {
        fired[i].rays = {&memory.rays[spread], kFootprintRays};
        spread += kFootprintRays;
      }
    }
    maker.returns_of({fired.data(), count}, height_m, memory.lanes, {returns.data(), count});
    for (std::size_t i = 0; i < count; ++i) {
      if (write_point(returns[i], beams, first + i, written, scan)) {
        ++written;
      }
    }
  }
  resize(scan.points, beams.ring.empty() ? 0 : written, written);
  scan.labels.resize(written);
}

bool ScanMaker::write_point(const Return& got, const Beams& beams, std::size_t beam, std::size_t at,
                            MadeScan& scan) const {
  if (got.range_m <= 0.0F && !sensor_.optics.keeps_no_returns) {
    return false;
  }
  PointChannels& points = scan.points;
  points.x[at] = got.range_m * beams.x[beam];
  points.y[at] = got.range_m * beams.y[beam];
  points.z[at] = got.range_m * beams.z[beam];
  points.intensity[at] = got.reflectivity;
  points.time[at] = beams.time_s[beam];
  if (!beams.ring.empty()) {
    points.ring[at] = beams.ring[beam];
  }
  scan.labels[at] = got.label;
  return true;
}

void ScanMaker::check_start(const Terrain& terrain) const {
  if (T_world_base_.empty()) {
    throw Error(ErrorCode::invalid_argument, "sensor: there is no trajectory");
  }
  const StampedPose& start = T_world_base_.poses().front();
  const Eigen::Vector3d origin_m = (start.T_world_base * T_base_sensor_).translation_m();
  const double below_m = terrain.at(origin_m.x(), origin_m.y()).height_m - origin_m.z();
  if (below_m >= 0.0) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("sensor: starts {:.2f} m below the terrain; mount it higher (mount.height_m), or start "
                            "elsewhere (vehicle.start_m)",
                            below_m));
  }
  if (is_inside(caster_, origin_m, to_seconds(start.stamp_ns))) {
    throw Error(ErrorCode::invalid_argument,
                "sensor: starts inside of something that stands there; start elsewhere (vehicle.start_m), or take "
                "another seed");
  }
}

}  // namespace berm::sim
