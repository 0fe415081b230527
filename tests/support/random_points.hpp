#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "berm/core/point_cloud.hpp"

namespace berm::test {

/// Which of the optional channels a cloud has.
struct ChannelSet {
  bool intensity = false;
  bool time = false;
  bool ring = false;
  bool label = false;

  static ChannelSet all() { return {true, true, true, true}; }
  /// The low four bits, so that a random number makes any combination.
  static ChannelSet from_bits(unsigned bits) {
    return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0, (bits & 8U) != 0};
  }
};

/// A float that is nasty now and then: NaN, Inf, denormal, the largest, minus zero.
[[nodiscard]] inline float random_float(std::mt19937& engine) {
  using Limits = std::numeric_limits<float>;
  switch (engine() % 16) {
    case 0:
      return Limits::quiet_NaN();
    case 1:
      return engine() % 2 == 0 ? Limits::infinity() : -Limits::infinity();
    case 2:
      return Limits::denorm_min() * static_cast<float>(engine() % 1000);
    case 3:
      return engine() % 2 == 0 ? Limits::max() : Limits::lowest();
    case 4:
      return -0.0F;
    default:
      return std::uniform_real_distribution<float>(-120.0F, 120.0F)(engine);
  }
}

/// Times lie in 0..0.1 s, in no order, some unknown; labels are those that have an id of their own.
[[nodiscard]] inline PointChannels random_points(std::size_t points, std::uint32_t seed, const ChannelSet& set) {
  constexpr Label kLabels[] = {Label::unlabeled, Label::falling_snow, Label::drivable, Label::terrain, Label::obstacle};
  std::mt19937 engine(seed);
  PointChannels channels;
  for (std::size_t i = 0; i < points; ++i) {
    channels.x.push_back(random_float(engine));
    channels.y.push_back(random_float(engine));
    channels.z.push_back(random_float(engine));
    if (set.intensity) {
      channels.intensity.push_back(random_float(engine));
    }
    if (set.time) {
      channels.time.push_back(i > 0 && engine() % 16 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                          : std::uniform_real_distribution<float>(0.0F, 0.1F)(engine));
    }
    if (set.ring) {
      channels.ring.push_back(static_cast<std::uint16_t>(engine()));
    }
    if (set.label) {
      channels.label.push_back(kLabels[engine() % 5]);
    }
  }
  return channels;
}

template <typename Value>
[[nodiscard]] bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

/// The same but that any NaN equals any other: text knows only one.
[[nodiscard]] inline bool same_values(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool both_nan = a[i] != a[i] && b[i] != b[i];
    if (!both_nan && std::memcmp(&a[i], &b[i], sizeof(float)) != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace berm::test
