#include "stand_alone.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace berm {
namespace {

constexpr float kNear_m = 3.0F;      // to toes on neighbouring traces: the rings of a VLP-16 lie 2.4 m apart at 16 m
constexpr float kNearShare = 0.25F;  // or a quarter of the range
constexpr float kBefore_m = 1.5F;    // what lies so far before the line of two others is no part of it
constexpr float kLongest_m = 40.0F;  // of such lines

/// How far `c` lies before the chord from a to b, seen from the sensor, where it lies between their ends; 0 elsewhere.
float before_chord_m(const ToePlace& a, const ToePlace& b, const ToePlace& c, float min_radius_m) {
  const float dx = b.x_m - a.x_m;
  const float dy = b.y_m - a.y_m;
  const float length_m = std::hypot(dx, dy);
  if (length_m < kNear_m || length_m > kLongest_m) {
    return 0.0F;
  }
  const float along = ((c.x_m - a.x_m) * dx + (c.y_m - a.y_m) * dy) / length_m;
  if (along < 0.0F || along > length_m) {
    return 0.0F;
  }
  const float side_of_toe = ((c.x_m - a.x_m) * dy - (c.y_m - a.y_m) * dx) / length_m;
  const float side_of_sensor = (a.y_m * dx - a.x_m * dy) / length_m;
  const float before_m = side_of_sensor > 0.0F ? side_of_toe : -side_of_toe;
  return before_m - length_m * length_m / (8.0F * min_radius_m);
}

void find_supporters_of(ToePlace& toe, std::span<const ToePlace> toes) {
  const float near_m = std::max(kNear_m, kNearShare * std::hypot(toe.x_m, toe.y_m));
  float nearest2 = near_m * near_m;
  const float near2 = nearest2;
  toe.supporters = 0;
  for (const ToePlace& other : toes) {
    const float dx = other.x_m - toe.x_m;
    const float dy = other.y_m - toe.y_m;
    const float distance2 = dx * dx + dy * dy;
    if (&other == &toe || other.left != toe.left || distance2 > near2) {
      continue;
    }
    ++toe.supporters;
    if (distance2 < nearest2 && distance2 > 0.0F) {
      nearest2 = distance2;
      toe.along_x = dx / std::sqrt(distance2);
      toe.along_y = dy / std::sqrt(distance2);
    }
  }
}

}  // namespace

void find_supporters(std::span<ToePlace> toes) {
  for (ToePlace& toe : toes) {
    find_supporters_of(toe, toes);
  }
}

bool stands_alone(const ToePlace& toe, std::span<const ToePlace> toes, float min_radius_m) {
  if (toe.supporters > 0) {
    return false;
  }
  for (std::size_t i = 0; i < toes.size(); ++i) {
    for (std::size_t k = i + 1; k < toes.size(); ++k) {
      if (toes[i].left == toe.left && toes[k].left == toe.left &&
          before_chord_m(toes[i], toes[k], toe, min_radius_m) > kBefore_m) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace berm
