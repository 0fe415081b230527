#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/io/recording_info.hpp"

namespace berm {

/// How many points of a scan are what.
struct PointCounts {
  std::size_t points = 0;
  std::size_t no_return_zero = 0;
  std::size_t no_return_inf = 0;
  std::size_t nan = 0;
  std::size_t duplicates = 0;             ///< at the very place of another, the repeated point left out
  std::optional<RepeatedPoint> repeated;  ///< its share is of this scan
};

/// Direction of one real return, seen from the sensor.
struct Beam {
  std::uint32_t index = 0;  ///< in the scan; files of more points are refused long before
  float azimuth_rad = 0.0F;
  float elevation_rad = 0.0F;
  float range_m = 0.0F;
};

/// Counts the points of a scan and finds the repeated one, if a share of at least 0.5 % lies at one place.
[[nodiscard]] PointCounts count_points(const PointsView& points);

/// The real returns in firing order. Where a no-return was moved along with the cloud, it marks the place of the
/// sensor: directions are then seen from there.
[[nodiscard]] std::vector<Beam> real_beams(const PointsView& points, const std::optional<RepeatedPoint>& repeated);

/// Angle between two beams.
[[nodiscard]] double angle_between_rad(const Beam& a, const Beam& b);

/// Extent of the directions; none for fewer than 100 beams.
[[nodiscard]] std::optional<FieldOfView> field_of_view(std::span<const Beam> beams);

}  // namespace berm
