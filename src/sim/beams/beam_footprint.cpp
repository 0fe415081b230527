#include "beam_footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace berm::sim {
namespace {

/// Beams farther apart than this are no neighbours. Several times the usual footprint, since a sparse pattern has
/// nobody nearer.
constexpr float kNear_rad = 0.025F;
/// The same between the rings of a spinning sensor, whose neighbours along the ring are near anyway.
constexpr float kRingsNear_rad = 0.01F;
/// More rings than any sensor has.
constexpr std::size_t kMostRings = 1024;
/// How far the neighbour may lie off the plane: steps below this melt into one echo in every receiver, ...
constexpr float kTerrainStep_m = 0.1F;
/// ... and crowns and vehicles are no planes.
constexpr float kThingsStep_m = 0.3F;
/// What the curvature of the ground adds for every metre between the two.
constexpr float kCurvature = 0.01F;

bool is_crown(const RayCaster& caster, const RawHit& hit) {
  return caster.material_of(hit).surface == Surface::foliage;
}

/// Whether two rays met the same thing, on the same plane. Crowns before crowns count as one: beams go some way into
/// them, and through them to the next, wherever in the footprint they enter.
bool agree(const RayCaster& caster, const TracedRay& a, const TracedRay& b) {
  if (a.hit.object != b.hit.object) {
    return false;
  }
  if (a.hit.is_nothing()) {
    return true;
  }
  const Eigen::Vector3f between_m = b.origin_m - a.origin_m + b.hit.range_m * b.direction - a.hit.range_m * a.direction;
  const float off_m = std::min(std::abs(a.hit.normal.dot(between_m)), std::abs(b.hit.normal.dot(between_m)));
  if (off_m <= (a.hit.object == 0 ? kTerrainStep_m : kThingsStep_m) + kCurvature * between_m.norm()) {
    return true;
  }
  return a.hit.object != 0 && is_crown(caster, a.hit) && is_crown(caster, b.hit);
}

class TornFinder {
 public:
  TornFinder(const RayCaster& caster, const OpticsConfig& optics, std::span<const TracedRay> rays,
             std::vector<std::uint8_t>& torn)
      : caster_(caster),
        rays_(rays),
        torn_(torn),
        reach_rad_(static_cast<float>(0.5e-3 * std::hypot(optics.divergence_x_mrad, optics.divergence_y_mrad))) {}

  /// The beams before and after lie `step` apart.
  void compare(std::size_t i, std::size_t k, std::size_t step, float near_rad) {
    if (distance2(i, k) < near_rad * near_rad && !agree(caster_, rays_[i], rays_[k])) {
      torn_[i] = 1;
      torn_[k] = 1;
      for (std::size_t n = i; n >= step && distance2(n - step, i) < reach_rad_ * reach_rad_; n -= step) {
        torn_[n - step] = 1;
      }
      for (std::size_t n = k + step; n < rays_.size() && distance2(n, k) < reach_rad_ * reach_rad_; n += step) {
        torn_[n] = 1;
      }
    }
  }

 private:
  [[nodiscard]] float distance2(std::size_t i, std::size_t k) const {
    return (rays_[i].direction - rays_[k].direction).squaredNorm();
  }

  const RayCaster& caster_;
  std::span<const TracedRay> rays_;
  std::vector<std::uint8_t>& torn_;
  float reach_rad_;
};

}  // namespace

void find_torn(const RayCaster& caster, const Beams& beams, std::size_t lasers, const OpticsConfig& optics,
               std::span<const TracedRay> rays, std::vector<std::uint8_t>& torn) {
  torn.assign(rays.size(), 0);
  TornFinder finder(caster, optics, rays, torn);
  const std::size_t rings = beams.ring.empty() ? 0 : lasers;
  for (std::size_t i = lasers; i < rays.size(); ++i) {
    finder.compare(i - lasers, i, lasers, kNear_rad);
  }
  // Lasers with rings fire column by column, in an order of their own.
  std::array<std::size_t, kMostRings> place{};
  if (rings == 0 || rings > std::min(kMostRings, rays.size())) {
    return;
  }
  for (std::size_t i = 0; i < rings; ++i) {
    place[beams.ring[i]] = i;
  }
  for (std::size_t column = 0; column + rings <= rays.size(); column += rings) {
    for (std::size_t ring = 1; ring < rings; ++ring) {
      finder.compare(column + place[ring - 1], column + place[ring], rays.size(), kRingsNear_rad);
    }
  }
}

void spread(const TracedRay& middle, const Eigen::Vector3f& up, const OpticsConfig& optics, Random& random,
            std::span<TracedRay> rays) {
  const auto width_rad = static_cast<float>(optics.divergence_x_mrad * 1e-3);
  const auto height_rad = static_cast<float>(optics.divergence_y_mrad * 1e-3);
  const Eigen::Vector3f& forward = middle.direction;
  Eigen::Vector3f aside = up.cross(forward);
  aside = aside.squaredNorm() > 1e-6F ? aside.normalized() : forward.unitOrthogonal();
  const Eigen::Vector3f upward = forward.cross(aside);
  // Parts about as wide as high: 4 x 1, 2 x 2 or 1 x 4.
  std::size_t columns = 1;
  while (columns < rays.size() &&
         width_rad * static_cast<float>(rays.size()) > 2.0F * height_rad * static_cast<float>(columns * columns)) {
    columns *= 2;
  }
  const std::size_t rows = rays.size() / columns;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::uint64_t bits = random.bits();
    const float u = static_cast<float>(bits >> 40U) * 0x1p-24F;
    const float v = static_cast<float>((bits >> 8U) & 0xffffffU) * 0x1p-24F;
    const float across = width_rad * ((static_cast<float>(i % columns) + u) / static_cast<float>(columns) - 0.5F);
    const std::size_t row = i / columns;
    const float along = height_rad * ((static_cast<float>(row) + v) / static_cast<float>(rows) - 0.5F);
    rays[i] = middle;
    rays[i].hit = {};
    rays[i].casts = 0;
    rays[i].direction = (forward + across * aside + along * upward).normalized();
  }
}

}  // namespace berm::sim
