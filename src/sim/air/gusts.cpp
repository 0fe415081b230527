#include "gusts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "berm/core/multiversion.hpp"

namespace berm::sim {
namespace {

/// Where the wind has moved the lattice by the time of the first beam, in nodes, and how fast it does.
struct Drifted {
  float x;
  float y;
  float x_per_s;
  float y_per_s;
};

/// std::floor is a call of the library unless built for newer processors.
[[gnu::always_inline]] inline std::int32_t whole_below(float x) {
  const auto towards_zero = static_cast<std::int32_t>(x);
  return towards_zero - (static_cast<float>(towards_zero) > x ? 1 : 0);
}

[[gnu::always_inline]] inline float reached(float from, float direction, float end_m, float range_m) {
  return from + direction * (end_m < range_m ? end_m : range_m);
}

// Bilinear between nodes of mean 1, hence of mean 1 itself.
BERM_MULTIVERSION void look_up(const AirLanes& beams, const float* __restrict nodes, std::int32_t mask,
                               float nodes_per_m, float range_m, Drifted drifted, float gustiness,
                               float* __restrict factors) {
  for (std::size_t i = 0; i < beams.padded(); ++i) {
    const auto since_s = static_cast<float>(beams.time_s[i] - beams.time_s[0]);
    const float x = reached(beams.x_m[i], beams.dx[i], beams.end_m[i], range_m) * nodes_per_m -
                    (drifted.x + drifted.x_per_s * since_s);
    const float y = reached(beams.y_m[i], beams.dy[i], beams.end_m[i], range_m) * nodes_per_m -
                    (drifted.y + drifted.y_per_s * since_s);
    const std::int32_t column = whole_below(x);
    const std::int32_t row = whole_below(y);
    const float right = x - static_cast<float>(column);
    const float up = y - static_cast<float>(row);
    const std::int32_t left_at = column & mask;
    const std::int32_t right_at = (column + 1) & mask;
    const std::int32_t low_at = (row & mask) * (mask + 1);
    const std::int32_t high_at = ((row + 1) & mask) * (mask + 1);
    const float low = nodes[low_at + left_at] + right * (nodes[low_at + right_at] - nodes[low_at + left_at]);
    const float high = nodes[high_at + left_at] + right * (nodes[high_at + right_at] - nodes[high_at + left_at]);
    factors[i] = 1.0F - gustiness + gustiness * (low + up * (high - low));
  }
}

}  // namespace

// Half of the nodes have nothing, the others up to four times the mean. They are
// scaled so that the mean of the lattice is 1 and not about 1.
Gusts::Gusts(const SnowfallConfig& snowfall, std::uint64_t seed)
    : gustiness_(snowfall.gustiness), nodes_per_m_(1.0 / snowfall.gust_size_m) {
  const double from_rad = snowfall.wind_from_deg * std::numbers::pi / 180.0;
  velocity_x_m_per_s_ = -snowfall.wind_m_per_s * std::sin(from_rad);
  velocity_y_m_per_s_ = -snowfall.wind_m_per_s * std::cos(from_rad);
  Random random(seed, Purpose::weather);
  nodes_.resize(static_cast<std::size_t>(kNodes * kNodes));
  double sum = 0.0;
  for (float& value : nodes_) {
    value = random.chance(0.5) ? 0.0F : static_cast<float>(random.uniform());
    sum += static_cast<double>(value);
  }
  const auto scale = static_cast<float>(static_cast<double>(nodes_.size()) / sum);
  for (float& value : nodes_) {
    value *= scale;
  }
}

void Gusts::along(const AirLanes& beams, float range_m, std::span<float> factors) const {
  if (gustiness_ <= 0.0) {
    std::fill(factors.begin(), factors.end(), 1.0F);
    return;
  }
  // Whole lattices are dropped: what is left is exact after hours of wind.
  const auto nodes_after = [&](double velocity_m_per_s) {
    return static_cast<float>(std::fmod(velocity_m_per_s * nodes_per_m_ * beams.time_s[0], kNodes));
  };
  const Drifted drifted{nodes_after(velocity_x_m_per_s_), nodes_after(velocity_y_m_per_s_),
                        static_cast<float>(velocity_x_m_per_s_ * nodes_per_m_),
                        static_cast<float>(velocity_y_m_per_s_ * nodes_per_m_)};
  look_up(beams, nodes_.data(), kNodes - 1, static_cast<float>(nodes_per_m_), range_m, drifted,
          static_cast<float>(gustiness_), factors.data());
}

}  // namespace berm::sim
