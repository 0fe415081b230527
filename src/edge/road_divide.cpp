#include "road_divide.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace berm {
namespace {

constexpr float kTurn_rad = 2.0F * std::numbers::pi_v<float>;

/// Place of the median 0 among `count` sectors from `first` on, wrapping around.
std::optional<std::size_t> median_free(std::span<const std::uint8_t> has_edge, std::size_t first, std::size_t count) {
  std::size_t free = 0;
  for (std::size_t i = 0; i < count; ++i) {
    free += has_edge[(first + i) % has_edge.size()] == 0 ? 1U : 0U;
  }
  std::size_t before = free / 2;
  for (std::size_t i = 0; i < count && free > 0; ++i) {
    if (has_edge[(first + i) % has_edge.size()] == 0 && before-- == 0) {
      return (first + i) % has_edge.size();
    }
  }
  return std::nullopt;
}

}  // namespace

bool RoadDivide::is_left(float x_m, float y_m) const {
  // Counterclockwise from ahead to behind.
  const auto from_ahead = [this](float bearing_rad) {
    const float turn = std::fmod(bearing_rad - ahead_rad, kTurn_rad);
    return turn < 0.0F ? turn + kTurn_rad : turn;
  };
  return from_ahead(std::atan2(y_m, x_m)) < from_ahead(behind_rad);
}

RoadDivide divide_road(std::span<const std::uint8_t> has_edge) {
  const std::size_t quarter = has_edge.size() / 4;
  const auto bearing = [&](std::size_t sector) {
    return (static_cast<float>(sector) + 0.5F) * kTurn_rad / static_cast<float>(has_edge.size()) - 0.5F * kTurn_rad;
  };
  RoadDivide divide;
  if (const auto ahead = median_free(has_edge, quarter, 2 * quarter)) {
    divide.ahead_rad = bearing(*ahead);
  }
  if (const auto behind = median_free(has_edge, 3 * quarter, has_edge.size() - 2 * quarter)) {
    divide.behind_rad = bearing(*behind);
  }
  return divide;
}

}  // namespace berm
