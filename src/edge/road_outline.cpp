#include "road_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace berm {
namespace {

constexpr float kWholeTurn_rad = 2.0F * std::numbers::pi_v<float>;
constexpr float kMargin_m = 0.4F;
constexpr float kLeastSine = 0.3F;

std::size_t sector_of(float x_m, float y_m) {
  const float turn = std::atan2(y_m, x_m) / kWholeTurn_rad + 0.5F;
  return std::min(static_cast<std::size_t>(turn * static_cast<float>(RoadOutline::kSectors)),
                  RoadOutline::kSectors - 1);
}

}  // namespace

RoadOutline::RoadOutline() {
  for (std::size_t i = 0; i < kSectors; ++i) {
    const float bearing_rad = ((static_cast<float>(i) + 0.5F) / static_cast<float>(kSectors) - 0.5F) * kWholeTurn_rad;
    rays_[i] = {std::cos(bearing_rad), std::sin(bearing_rad), 1.0F};
  }
  clear();
}

void RoadOutline::clear() {
  nearest_.fill(Place{});
  limit_m_.fill(std::numeric_limits<float>::max());
}

void RoadOutline::add(float x_m, float y_m) {
  const float range_m = std::hypot(x_m, y_m);
  Place& place = nearest_[sector_of(x_m, y_m)];
  if (place.range_m == 0.0F || range_m < place.range_m) {
    place = {x_m, y_m, range_m};
  }
}

void RoadOutline::close(const RoadDivide& divide, float min_radius_m) {
  for (std::size_t i = 0; i < kSectors; ++i) {
    const Place& a = nearest_[i];
    if (a.range_m == 0.0F) {
      continue;
    }
    const bool left = divide.is_left(a.x_m, a.y_m);
    for (std::size_t step = 2; step < kSectors / 2; ++step) {
      const Place& b = nearest_[(i + step) % kSectors];
      if (b.range_m > 0.0F && divide.is_left(b.x_m, b.y_m) == left) {
        limit_between(i, step, min_radius_m);
      }
    }
  }
}

void RoadOutline::limit_between(std::size_t first, std::size_t steps, float min_radius_m) {
  const Place& a = nearest_[first];
  const Place& b = nearest_[(first + steps) % kSectors];
  const float dx = b.x_m - a.x_m;
  const float dy = b.y_m - a.y_m;
  const float length_m = std::hypot(dx, dy);
  const float margin_m = kMargin_m + length_m * length_m / (8.0F * min_radius_m);
  const float across = (a.x_m * dy - a.y_m * dx) / length_m;
  for (std::size_t k = 1; k < steps; ++k) {
    // Where the ray of the sector meets the chord, by cross products with the direction of the chord.
    const std::size_t sector = (first + k) % kSectors;
    const float sine = (rays_[sector].x_m * dy - rays_[sector].y_m * dx) / length_m;
    if (std::abs(sine) > kLeastSine && across / sine > 0.0F) {
      limit_m_[sector] = std::min(limit_m_[sector], across / sine + margin_m / std::abs(sine));
    }
  }
}

bool RoadOutline::is_beyond(float x_m, float y_m) const {
  return std::hypot(x_m, y_m) > limit_m_[sector_of(x_m, y_m)];
}

}  // namespace berm
