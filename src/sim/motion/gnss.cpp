#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "berm/core/angle.hpp"
#include "berm/sim/motion.hpp"
#include "berm/sim/random.hpp"
#include "motion_noise.hpp"

namespace berm::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

/// Satellites are above: heights are known half as well.
constexpr double kHeightFactor = 2.0;
/// Times between outages lie within this share of their mean.
constexpr double kSpread = 0.5;

/// Nobody means less by a rate or a time that is not 0.
constexpr double kMinRate_hz = 0.1;
constexpr double kMinOutageEvery_s = 1.0;

/// When there is nothing to be had.
class Outages {
 public:
  Outages(const GnssConfig& config, std::uint64_t seed) : config_(config), random_(seed, Purpose::gnss, 0) {
    plan_after(0.0);
  }

  [[nodiscard]] bool is_out(double time_s) {
    while (time_s >= starts_s_ + config_.outage_s) {
      plan_after(starts_s_ + config_.outage_s);
    }
    return time_s >= starts_s_;
  }

 private:
  void plan_after(double time_s) {
    starts_s_ = config_.outage_every_s > 0.0
                    ? time_s + config_.outage_every_s * random_.uniform(1.0 - kSpread, 1.0 + kSpread)
                    : std::numeric_limits<double>::infinity();
  }

  const GnssConfig& config_;
  Random random_;
  double starts_s_ = 0.0;
};

Vector3d jump(const GnssConfig& config, std::uint64_t seed) {
  Random random(seed, Purpose::gnss, 1);
  const double direction_rad = random.uniform(0.0, 2.0 * std::numbers::pi);
  return config.jump_m * Vector3d(std::cos(direction_rad), std::sin(direction_rad), 0.0);
}

Pose disturb(const Pose& T_world_base, const GnssConfig& config, const Vector3d& offset_m, Random& random) {
  const Vector3d noise_m = config.noise_m * Vector3d(random.normal(), random.normal(), kHeightFactor * random.normal());
  const double heading_rad = config.heading_noise_deg * kRadPerDeg * random.normal();
  const double pitch_rad = config.attitude_noise_deg * kRadPerDeg * random.normal();
  const double roll_rad = config.attitude_noise_deg * kRadPerDeg * random.normal();
  const Eigen::Quaterniond rotation = AngleAxisd(heading_rad, Vector3d::UnitZ()) * T_world_base.rotation() *
                                      AngleAxisd(pitch_rad, Vector3d::UnitY()) *
                                      AngleAxisd(roll_rad, Vector3d::UnitX());
  return {rotation, T_world_base.translation_m() + offset_m + noise_m};
}

}  // namespace

void GnssConfig::check() const {
  check_fields(*this, "gnss");
  if (rate_hz != 0.0 && rate_hz < kMinRate_hz) {
    check_problem("gnss", "rate_hz", "is too small, expected 0 (none) or 0.1 to 200");
  }
  if (outage_every_s != 0.0 && outage_every_s < kMinOutageEvery_s) {
    check_problem("gnss", "outage_every_s", "is too small, expected 0 (none) or 1 to 36000");
  }
}

Trajectory measure_gnss(const Trajectory& truth, const GnssConfig& config, std::uint64_t seed) {
  config.check();
  Trajectory measured;
  if (config.rate_hz <= 0.0 || truth.empty()) {
    return measured;
  }
  const Stamp first_ns = truth.poses().front().stamp_ns;
  const Stamp last_ns = truth.poses().back().stamp_ns;
  const Stamp halfway_ns = first_ns + (last_ns - first_ns) / 2;
  const double step_s = 1.0 / config.rate_hz;
  Drift drifts[3] = {Drift(config.drift_s, step_s, Random(seed, Purpose::gnss, 2)),
                     Drift(config.drift_s, step_s, Random(seed, Purpose::gnss, 3)),
                     Drift(config.drift_s, step_s, Random(seed, Purpose::gnss, 4))};
  Outages outages(config, seed);
  const Vector3d jump_m = jump(config, seed);
  for (std::size_t i = 0;; ++i) {
    const double time_s = static_cast<double>(i) / config.rate_hz;
    const Stamp stamp_ns = first_ns + from_seconds(time_s);
    if (stamp_ns > last_ns) {
      return measured;
    }
    Vector3d offset_m = config.drift_m * Vector3d(drifts[0].next(), drifts[1].next(), drifts[2].next());
    if (stamp_ns >= halfway_ns) {
      offset_m += jump_m;
    }
    // A sequence of its own for each pose: what an outage leaves out changes no other.
    Random random(seed, Purpose::gnss, 5, i);
    const Pose pose = disturb(*truth.at(stamp_ns), config, offset_m, random);
    if (!outages.is_out(time_s)) {
      measured.append(stamp_ns, pose);
    }
  }
}

}  // namespace berm::sim
