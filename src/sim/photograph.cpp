#include "berm/sim/photograph.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "berm/core/ordered_parallel.hpp"

namespace berm::sim {
namespace {

using Eigen::Vector3d;

/// Nothing is drawn beyond; the haze hides where the world ends.
constexpr double kSight_m = 1500.0;
constexpr double kHaze_m = 700.0;
/// A ray on its way on starts this far behind what it met.
constexpr double kStep_m = 0.02;
/// Half the width of the line along the edge of what is drivable, at least, and in pixels.
constexpr double kLine_m = 0.06;
constexpr double kLine_px = 1.0;
constexpr double kTint = 0.14;
constexpr double kAmbient = 0.42;
const Vector3d kSun = Vector3d(-0.35, -0.65, 0.62).normalized();

const Vector3d kSky(0.60, 0.74, 0.90);
const Vector3d kHorizon(0.84, 0.89, 0.94);
const Vector3d kDrivable(0.10, 0.66, 0.50);
const Vector3d kEdge(0.95, 0.45, 0.05);

Vector3d color_of(Surface surface) {
  switch (surface) {
    case Surface::groomed_snow:
      return {0.95, 0.97, 1.00};
    case Surface::rough_snow:
      return {0.87, 0.90, 0.96};
    case Surface::asphalt:
      return {0.36, 0.36, 0.38};
    case Surface::gravel:
      return {0.64, 0.57, 0.48};
    case Surface::rock:
      return {0.52, 0.47, 0.43};
    case Surface::water:
      return {0.28, 0.38, 0.48};
    case Surface::foliage:
      return {0.20, 0.34, 0.21};
    case Surface::bark:
      return {0.38, 0.29, 0.22};
    case Surface::net:
      return {0.93, 0.42, 0.12};
    case Surface::metal:
      return {0.62, 0.64, 0.67};
    case Surface::paint:
      return {0.85, 0.64, 0.12};
    case Surface::cloth:
      return {0.24, 0.38, 0.70};
    case Surface::concrete:
      return {0.74, 0.72, 0.69};
  }
  return {1.0, 0.0, 1.0};
}

Vector3d mix(const Vector3d& a, const Vector3d& b, double share) {
  return a + share * (b - a);
}

/// The directions of the pixels of a camera.
class Lens {
 public:
  explicit Lens(const Camera& camera)
      : forward_((camera.target_m - camera.eye_m).normalized()),
        right_(forward_.cross(Vector3d::UnitZ()).normalized()),
        up_(right_.cross(forward_)),
        pixel_rad_(2.0 * std::tan(0.5 * camera.width_rad) / camera.width_px),
        column_(0.5 * (camera.width_px - 1)),
        row_(0.5 * (camera.height_px - 1)) {}

  [[nodiscard]] Vector3d direction(int column, int row) const {
    return (forward_ + (column - column_) * pixel_rad_ * right_ + (row_ - row) * pixel_rad_ * up_).normalized();
  }

  /// What a pixel in the middle spans.
  [[nodiscard]] double pixel_rad() const { return pixel_rad_; }

 private:
  Vector3d forward_;
  Vector3d right_;
  Vector3d up_;
  double pixel_rad_;
  double column_;
  double row_;
};

class Photographer {
 public:
  Photographer(const RayCaster& caster, const Camera& camera) : caster_(caster), camera_(camera), lens_(camera) {}

  [[nodiscard]] Vector3d color_at(int column, int row) const {
    const Vector3d direction = lens_.direction(column, row);
    const Vector3d sky = mix(kHorizon, kSky, std::clamp(3.0 * direction.z(), 0.0, 1.0));
    Hit hit;
    double from_m = kStep_m;
    while (caster_.cast(camera_.eye_m, direction, from_m, kSight_m, camera_.time_s, hit)) {
      // A net is drawn in every other pixel, so that what is behind it shows.
      if (hit.material.surface != Surface::net || (column + row) % 2 == 0) {
        const double haze = 1.0 - std::exp(-hit.range_m / kHaze_m);
        return mix(lit(hit, camera_.eye_m + hit.range_m * direction), sky, haze);
      }
      from_m = hit.range_m + kStep_m;
    }
    return sky;
  }

 private:
  [[nodiscard]] Vector3d lit(const Hit& hit, const Vector3d& place_m) const {
    Vector3d color = color_of(hit.material.surface);
    if (hit.object == 0) {
      const bool on_line = std::fabs(hit.inside_m) < std::max(kLine_m, kLine_px * lens_.pixel_rad() * hit.range_m);
      color = on_line ? kEdge : hit.inside_m > 0.0 ? mix(color, kDrivable, kTint) : color;
    }
    const double towards_sun = hit.normal.cast<double>().dot(kSun);
    Hit shade;
    const bool sunny =
        towards_sun > 0.0 && !caster_.cast(place_m + kStep_m * kSun, kSun, kStep_m, kSight_m, camera_.time_s, shade);
    // The sky lights what faces up more than what faces down.
    const double ambient = kAmbient * (0.75 + 0.25 * static_cast<double>(hit.normal.z()));
    return color * (ambient + (sunny ? (1.0 - kAmbient) * towards_sun * 1.25 : 0.0));
  }

  const RayCaster& caster_;
  const Camera& camera_;
  Lens lens_;
};

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

Camera camera_behind(const World& world, double along_m) {
  constexpr double kBehind_m = 16.0;
  constexpr double kAbove_m = 9.0;
  constexpr double kAhead_m = 26.0;
  const RoutePoint here = world.route.at(along_m);
  const Vector3d forward(std::cos(here.heading_rad), std::sin(here.heading_rad), 0.0);
  const Vector3d middle(here.x_m, here.y_m, here.z_m);
  Camera camera;
  camera.eye_m = middle - kBehind_m * forward;
  camera.target_m = middle + kAhead_m * forward;
  camera.target_m.z() = world.terrain->at(camera.target_m.x(), camera.target_m.y()).height_m;
  camera.eye_m.z() = kAbove_m + std::max(here.z_m, world.terrain->at(camera.eye_m.x(), camera.eye_m.y()).height_m);
  return camera;
}

Photograph photograph(const RayCaster& caster, const Camera& camera, std::size_t threads) {
  Photograph picture{camera.width_px, camera.height_px, {}};
  const Photographer photographer(caster, camera);
  OrderedParallel<std::vector<std::uint8_t>> rows(
      static_cast<std::size_t>(camera.height_px), std::max<std::size_t>(1, threads),
      [&](std::size_t /*worker*/, std::size_t row, std::vector<std::uint8_t>& pixels) {
        pixels.clear();
        for (int column = 0; column < camera.width_px; ++column) {
          const Vector3d color = photographer.color_at(column, static_cast<int>(row));
          pixels.insert(pixels.end(), {to_byte(color.x()), to_byte(color.y()), to_byte(color.z())});
        }
      },
      [&picture](std::size_t /*row*/, const std::vector<std::uint8_t>& pixels) {
        picture.rgb.insert(picture.rgb.end(), pixels.begin(), pixels.end());
        return true;
      });
  rows.run();
  return picture;
}

}  // namespace berm::sim
