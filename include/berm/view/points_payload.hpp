#pragma once

#include <cstdint>
#include <string>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"

namespace berm {

/// Channels of a payload that are real.
enum PayloadChannel : std::uint32_t {
  kPayloadIntensity = 1,
  kPayloadLabel = 2,
  kPayloadTime = 4,
  kPayloadRing = 8,
};

inline constexpr std::uint32_t kPayloadMagic = 0x314D5242;  ///< "BRM1"
inline constexpr std::size_t kPayloadHeaderBytes = 16;
inline constexpr std::size_t kPayloadPointBytes = 16;

/// Beyond this nothing can be drawn in floats; no sensor measures it.
inline constexpr float kMaxPayloadCoordinate_m = 1e6F;

/// Whether a point is in a payload: it is finite and within `kMaxPayloadCoordinate_m`, and its beam met something.
[[nodiscard]] bool is_in_payload(float x, float y, float z);

/// Points as the front end takes them (docs/view_api.md), moved by `T_target_source`: 16 bytes a point.
[[nodiscard]] std::string make_points_payload(const PointsView& points, const Pose& T_target_source);

}  // namespace berm
