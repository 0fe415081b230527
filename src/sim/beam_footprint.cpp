#include "beam_footprint.hpp"

#include <algorithm>
#include <cmath>

namespace berm::sim {
namespace {

/// Beams farther apart than this are no neighbours. Several times the usual footprint, since a sparse pattern has
/// nobody nearer.
constexpr float kNear_rad = 0.025F;
/// The same between the rings of a spinning sensor, whose neighbours along the ring are near anyway.
constexpr float kRingsNear_rad = 0.01F;
/// How far the neighbour may lie off the plane: steps below this melt into one echo in every receiver, ...
constexpr float kTerrainStep_m = 0.1F;
/// ... and crowns and vehicles are no planes.
constexpr float kThingsStep_m = 0.3F;
/// What the curvature of the ground adds for every metre between the two.
constexpr float kCurvature = 0.01F;

bool agree(const TracedRay& a, const TracedRay& b) {
  if (a.hit.object != b.hit.object) {
    return false;
  }
  if (a.hit.is_nothing()) {
    return true;
  }
  const Eigen::Vector3f between_m = b.origin_m - a.origin_m + b.hit.range_m * b.direction - a.hit.range_m * a.direction;
  const float off_m = std::min(std::abs(a.hit.normal.dot(between_m)), std::abs(b.hit.normal.dot(between_m)));
  return off_m <= (a.hit.object == 0 ? kTerrainStep_m : kThingsStep_m) + kCurvature * between_m.norm();
}

class TornFinder {
 public:
  TornFinder(std::span<const TracedRay> rays, std::vector<std::uint8_t>& torn) : rays_(rays), torn_(torn) {}

  void compare(std::size_t i, std::size_t k, float near_rad) {
    const float chord2 = (rays_[i].direction - rays_[k].direction).squaredNorm();
    if (chord2 < near_rad * near_rad && !agree(rays_[i], rays_[k])) {
      torn_[i] = 1;
      torn_[k] = 1;
    }
  }

 private:
  std::span<const TracedRay> rays_;
  std::vector<std::uint8_t>& torn_;
};

}  // namespace

void find_torn(const Beams& beams, std::size_t lasers, std::span<const TracedRay> rays,
               std::vector<std::uint8_t>& torn) {
  torn.assign(rays.size(), 0);
  TornFinder finder(rays, torn);
  if (beams.ring.empty()) {
    for (std::size_t i = lasers; i < rays.size(); ++i) {
      finder.compare(i - lasers, i, kNear_rad);
    }
    return;
  }
  // Lasers fire column by column, in an order of their own.
  const std::size_t rings = std::size_t{*std::max_element(beams.ring.begin(), beams.ring.end())} + 1;
  for (std::size_t i = rings; i < rays.size(); ++i) {
    finder.compare(i - rings, i, kNear_rad);
  }
  std::vector<std::size_t> place(rings, rays.size());
  for (std::size_t i = 0; i < std::min(rings, rays.size()); ++i) {
    place[beams.ring[i]] = i;
  }
  for (std::size_t column = 0; column + rings <= rays.size(); column += rings) {
    for (std::size_t ring = 1; ring < rings; ++ring) {
      if (place[ring - 1] < rings && place[ring] < rings) {
        finder.compare(column + place[ring - 1], column + place[ring], kRingsNear_rad);
      }
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
  // Parts about as wide as high: 8 x 1, 4 x 2, 2 x 4 or 1 x 8.
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
    const float along = height_rad * ((static_cast<float>(i / columns) + v) / static_cast<float>(rows) - 0.5F);
    rays[i] = middle;
    rays[i].hit = {};
    rays[i].casts = 0;
    rays[i].direction = (forward + across * aside + along * upward).normalized();
  }
}

}  // namespace berm::sim
