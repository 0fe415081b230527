#include "berm/pipeline/mount_check.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "berm/geometry/moments.hpp"
#include "berm/geometry/plane_fit.hpp"

namespace berm {
namespace {

/// The surroundings that count, in m from the sensor; the second if the first hold too little.
constexpr float kNear_m = 20.0F;
constexpr float kFar_m = 40.0F;
/// What is nearer is the machine.
constexpr float kOwn_m = 1.0F;
/// One point per cube of space counts, so that dense things have no more say than large ones.
constexpr int kCubes = 80;
constexpr std::size_t kLookedAt = 8192;
constexpr std::size_t kKept = 300;
constexpr std::size_t kTooFew = 60;
constexpr int kTriples = 160;
/// Ground rolls: it may lie off the plane by this, and more with the distance.
constexpr float kTolerance_m = 0.1F;
constexpr float kToleranceShare = 0.02F;
/// A plane that fewer agree on tells nothing.
constexpr float kLeastScore = 0.3F;
/// A plane about where the mount has it is the ground if it has this share of the best plane's score.
constexpr float kUprightShare = 0.6F;
/// Sensors are never lower above their ground.
constexpr float kLowest_m = 0.2F;
/// Planes as steep as this against the mount are walls rather than ground.
constexpr double kWall_rad = 0.9;
/// Heights may differ by this factor and by this much: hollows, crests, snow.
constexpr double kHeightFactor = 2.0;
constexpr double kHeightSlack_m = 0.7;

float as_float(double value) {
  return static_cast<float>(value);
}

/// Numbers that are scattered enough to choose triples by.
class Scatter {
 public:
  std::size_t below(std::size_t n) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>((state_ >> 33U) % n);
  }

 private:
  std::uint64_t state_ = 1;
};

template <typename Values>
void keep_every(Values& values, std::size_t kept) {
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < kept; ++i) {
    values[i] = values[i * n / kept];
  }
  values.resize(kept);
}

MountEstimate compare(const Eigen::Vector3d& normal_base, double height_m) {
  return {.tilt_rad = std::acos(std::clamp(normal_base.z(), -1.0, 1.0)),
          .pitch_rad = std::atan2(-normal_base.x(), normal_base.z()),
          .roll_rad = std::atan2(normal_base.y(), normal_base.z()),
          .height_m = height_m};
}

bool fits(double height_m, double mount_height_m) {
  // A mount without a height says nothing about it.
  if (mount_height_m <= static_cast<double>(kLowest_m) || std::abs(height_m - mount_height_m) < kHeightSlack_m) {
    return true;
  }
  return height_m < kHeightFactor * mount_height_m && mount_height_m < kHeightFactor * height_m;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::string_view to_string(MountVerdict verdict) {
  switch (verdict) {
    case MountVerdict::plausible:
      return "plausible";
    case MountVerdict::implausible:
      return "implausible";
    case MountVerdict::unknown:
      break;
  }
  return "unknown";
}

void MountCheck::collect(const PointsView& points, std::span<const std::uint8_t> falling, float max_range_m) {
  x_.clear();
  y_.clear();
  z_.clear();
  tolerance_m_.clear();
  taken_.assign(static_cast<std::size_t>(kCubes) * kCubes * kCubes / 64, 0);
  const std::size_t looked_at = std::min(points.size(), kLookedAt);
  const float cubes_per_m = static_cast<float>(kCubes) / (2.0F * max_range_m);
  const auto cube = [&](float value_m) { return static_cast<std::size_t>((value_m + max_range_m) * cubes_per_m); };
  for (std::size_t sample = 0; sample < looked_at; ++sample) {
    const std::size_t i = sample * points.size() / looked_at;
    // Not std::hypot, which guards against an overflow that costs ten times as much.
    const float range_m = std::sqrt(points.x[i] * points.x[i] + points.y[i] * points.y[i] + points.z[i] * points.z[i]);
    // Written so that NaN is left out.
    if (!(range_m > kOwn_m && range_m < 0.999F * max_range_m) || (!falling.empty() && falling[i] != 0)) {
      continue;
    }
    const std::size_t place = (cube(points.x[i]) * kCubes + cube(points.y[i])) * kCubes + cube(points.z[i]);
    const std::uint64_t bit = std::uint64_t{1} << (place % 64);
    if ((taken_[place / 64] & bit) != 0) {
      continue;
    }
    taken_[place / 64] |= bit;
    x_.push_back(points.x[i]);
    y_.push_back(points.y[i]);
    z_.push_back(points.z[i]);
    tolerance_m_.push_back(kTolerance_m + kToleranceShare * range_m);
  }
  if (x_.size() > kKept) {
    for (std::vector<float>* values : {&x_, &y_, &z_, &tolerance_m_}) {
      keep_every(*values, kKept);
    }
  }
}

/// The share of points on the plane, less that of points beyond it: nothing shines through the ground.
void MountCheck::score(Plane& plane) const {
  int on = 0;
  int beyond = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const float above_m =
        plane.normal.x() * x_[i] + plane.normal.y() * y_[i] + plane.normal.z() * z_[i] + plane.height_m;
    on += std::fabs(above_m) < tolerance_m_[i] ? 1 : 0;
    beyond += above_m < -2.0F * tolerance_m_[i] ? 1 : 0;
  }
  plane.score = static_cast<float>(on - beyond) / static_cast<float>(x_.size());
}

void MountCheck::consider(Plane plane, const Eigen::Vector3f& up, Plane& best, Plane& best_upright) const {
  score(plane);
  if (plane.score > best.score) {
    best = plane;
  }
  if (plane.score > best_upright.score && plane.normal.dot(up) > as_float(std::cos(kMaxTilt_rad))) {
    best_upright = plane;
  }
}

/// Least squares over the points on the plane.
void MountCheck::refine(Plane& plane) const {
  Moments moments;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const Eigen::Vector3f point(x_[i], y_[i], z_[i]);
    if (std::fabs(plane.normal.dot(point) + plane.height_m) < tolerance_m_[i]) {
      moments.add(point.cast<double>());
    }
  }
  const std::optional<PlaneFit> fit = fit_plane(moments);
  if (!fit) {
    return;
  }
  const double side = fit->normal.dot(plane.normal.cast<double>()) < 0.0 ? -1.0 : 1.0;
  plane.normal = (side * fit->normal).cast<float>();
  plane.height_m = as_float(-side * fit->normal.dot(fit->centroid_m));
}

MountCheckResult MountCheck::process(const PointsView& points, std::span<const std::uint8_t> falling,
                                     const Pose& T_base_sensor) {
  collect(points, falling, kNear_m);
  if (x_.size() < kTooFew) {
    collect(points, falling, kFar_m);
  }
  if (x_.size() < kTooFew) {
    return {};
  }
  const Eigen::Vector3f up = (T_base_sensor.rotation().conjugate() * Eigen::Vector3d::UnitZ()).cast<float>();
  const double mount_height_m = T_base_sensor.translation_m().z();
  Plane best;
  Plane best_upright;
  consider({.normal = up, .height_m = std::max(as_float(mount_height_m), kLowest_m)}, up, best, best_upright);
  Scatter scatter;
  for (int triple = 0; triple < kTriples; ++triple) {
    const auto pick = [&] {
      const std::size_t i = scatter.below(x_.size());
      return Eigen::Vector3f(x_[i], y_[i], z_[i]);
    };
    const Eigen::Vector3f a = pick();
    const Eigen::Vector3f b = pick();
    const Eigen::Vector3f c = pick();
    const Eigen::Vector3f cross = (b - a).cross(c - a);
    const float area_m2 = cross.norm();
    if (!(area_m2 > 0.1F)) {
      continue;
    }
    const float side = cross.dot(a) > 0.0F ? -1.0F : 1.0F;
    const Eigen::Vector3f normal = side / area_m2 * cross;
    const float height_m = -normal.dot(a);
    if (height_m > kLowest_m) {
      consider({.normal = normal, .height_m = height_m}, up, best, best_upright);
    }
  }
  const bool upright = best_upright.score >= kUprightShare * best.score;
  Plane plane = upright ? best_upright : best;
  if (plane.score < kLeastScore) {
    return {};
  }
  refine(plane);
  MountCheckResult result;
  result.estimate =
      compare(T_base_sensor.rotation() * plane.normal.cast<double>(), static_cast<double>(plane.height_m));
  const double tilt_rad = result.estimate->tilt_rad;
  const bool wall = tilt_rad > kWall_rad && tilt_rad < EIGEN_PI - kWall_rad;
  if (wall || plane.height_m < kLowest_m) {
    return {};
  }
  const bool plausible = tilt_rad < kMaxTilt_rad && fits(result.estimate->height_m, mount_height_m);
  result.verdict = plausible ? MountVerdict::plausible : MountVerdict::implausible;
  return result;
}

void MountStatistics::add(const MountCheckResult& result) {
  ++scans_;
  if (result.estimate) {
    estimates_.push_back(*result.estimate);
    implausible_ += result.verdict == MountVerdict::implausible ? 1U : 0U;
  }
}

MountSummary MountStatistics::summarize() const {
  MountSummary summary{.scans = estimates_.size()};
  if (estimates_.empty()) {
    return summary;
  }
  const auto middle = [this](double MountEstimate::*member) {
    std::vector<double> values(estimates_.size());
    std::transform(estimates_.begin(), estimates_.end(), values.begin(),
                   [member](const MountEstimate& estimate) { return estimate.*member; });
    return median(std::move(values));
  };
  summary.estimate = MountEstimate{.tilt_rad = middle(&MountEstimate::tilt_rad),
                                   .pitch_rad = middle(&MountEstimate::pitch_rad),
                                   .roll_rad = middle(&MountEstimate::roll_rad),
                                   .height_m = middle(&MountEstimate::height_m)};
  if (10 * estimates_.size() >= scans_) {
    summary.verdict = 2 * implausible_ > estimates_.size() ? MountVerdict::implausible : MountVerdict::plausible;
  }
  return summary;
}

}  // namespace berm
