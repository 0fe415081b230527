#pragma once

#include <cstdint>

namespace berm::sim {

/// What a random number is for: numbers of different purposes never depend on each other.
enum class Purpose : std::uint64_t { route, terrain, things, movers, vehicle, gnss, weather, beam };

/// Random numbers that depend on what they are for and not on when they are drawn: seed, purpose and two indices
/// (of a scan and a beam, say) name a sequence of their own. Hence the same numbers on any number of threads, on every
/// platform, and no state to carry from beam to beam. SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  Random(std::uint64_t seed, Purpose purpose, std::uint64_t index = 0, std::uint64_t subindex = 0)
      : state_(mix(mix(mix(mix(seed) + static_cast<std::uint64_t>(purpose) + 1) + index) + subindex)) {}

  [[nodiscard]] std::uint64_t bits() {
    state_ += kGolden;
    return mix(state_);
  }
  /// In [0, 1).
  [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// In [low, high).
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1.
  [[nodiscard]] double normal();
  /// Mean 1.
  [[nodiscard]] double exponential();
  [[nodiscard]] bool chance(double probability) { return uniform() < probability; }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;

  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace berm::sim
