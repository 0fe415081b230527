#include "berm/snow/sparse_snow.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "near_points.hpp"
#include "returns.hpp"
#include "spread.hpp"

namespace berm {
namespace {

constexpr int kLevels = 256;

/// Points of a pole differ in range by so much of it, and by the noise.
constexpr float kLineWindow = 0.01F;
constexpr float kLineNoise_m = 0.02F;
/// A thin pole fills at least so much of a cell.
constexpr float kLineShare = 0.12F;

/// Snow that is spread evenly is believed from this share of the near points on ...
constexpr double kLeastShare = 0.0005;
/// ... and a single heap from this one,
constexpr double kHeapShare = 0.03;
/// or from this one if hardly anything is as dark that does not stand alone: few beams, thin snowfall. Of the dark
/// points of simulated snowfall 99.5 % stand alone, of those of a room 55 %.
constexpr double kPureHeapShare = 0.002;
constexpr double kPure = 0.95;

/// Dark levels have so many times more flakes to a surface point than the brightest.
constexpr double kMostOdds = 3.0;

/// Flakes that are not dark are looked for if more than this share of a sample shows some.
constexpr double kShownShare = 0.02;

/// Looking for the level goes on until surfaces outweigh what was won by this share of the near points.
constexpr float kLostShare = 0.02F;

/// NaN is as dark as nothing.
std::uint8_t level_of(float intensity) {
  return static_cast<std::uint8_t>(std::min(255.0F, std::max(0.0F, intensity)));
}

/// One point in 32, chosen by the bits of its range, so that the order of points does not matter.
bool is_in_sample(float range_m) {
  return std::bit_cast<std::uint32_t>(range_m) * 2654435769U >> 27U == 0;
}

/// How alone a flake has to be.
struct Demand {
  float points;
  float share;
};

}  // namespace

struct SparseSnow::State {
  explicit State(const SparseSnowConfig& c)
      : config(c),
        max_range_m(static_cast<float>(c.max_range_m)),
        window(static_cast<float>(c.window)),
        dark{static_cast<float>(c.dark_points), static_cast<float>(c.dark_share)},
        bright{static_cast<float>(c.bright_points), static_cast<float>(c.bright_share)} {}

  [[nodiscard]] bool stands_alone(std::size_t i, const Demand& demand) const;
  void find_levels(std::span<const float> intensity);
  [[nodiscard]] float weigh_surfaces() const;
  [[nodiscard]] int find_dark_level();
  [[nodiscard]] bool snow_shows_above(int dark_level) const;
  void judge_above(int dark_level);
  [[nodiscard]] double purity(int dark_level) const;
  [[nodiscard]] bool is_snowfall(double purity) const;

  SparseSnowConfig config;
  float max_range_m;
  float window;
  Demand dark;
  Demand bright;

  NearPoints near;
  std::vector<std::uint8_t> level;                       ///< of intensity, of every near point
  std::array<std::uint32_t, kLevels + 1> level_begin{};  ///< of a level in `by_level`
  std::vector<std::uint32_t> by_level;                   ///< near points, sorted by level
  std::vector<std::uint8_t> alone;                       ///< whether a near point was found to be a flake
  std::vector<std::uint8_t> falling;
};

bool SparseSnow::State::stands_alone(std::size_t i, const Demand& demand) const {
  const NearPoints::Block block = near.block_of(i);
  const float range_m = near.range_m(i);
  const float share = config.fade_with_range ? range_m / max_range_m : 0.0F;
  const float most = (demand.points + demand.share * static_cast<float>(block.all)) * (1.0F - share * share);
  const auto limit = static_cast<std::uint32_t>(std::ceil(most));
  const std::uint32_t like = near.count_like(i, block, window * range_m, limit);
  if (like >= limit) {
    return false;
  }
  return !config.spare_lines || like < 2 ||
         !near.lies_on_line(i, block, kLineWindow * range_m + kLineNoise_m, kLineShare);
}

void SparseSnow::State::find_levels(std::span<const float> intensity) {
  // Two sums of each level, so that neighbours of one level need not wait for each other.
  std::array<std::array<std::uint32_t, kLevels>, 2> counts{};
  level.resize(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    level[i] = level_of(intensity[near.index(i)]);
    ++counts[i % 2][level[i]];
  }
  std::array<std::uint32_t, kLevels> place{};
  for (std::size_t l = 0; l < kLevels; ++l) {
    place[l] = level_begin[l];
    level_begin[l + 1] = level_begin[l] + counts[0][l] + counts[1][l];
  }
  by_level.resize(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    by_level[place[level[i]]++] = static_cast<std::uint32_t>(i);
  }
}

/// What a surface point counts against a flake, at least as much as makes the brightest tenth of the points a loss:
/// they are no flakes, and where beams are sparse many of them look like some all the same.
float SparseSnow::State::weigh_surfaces() const {
  const std::size_t first = near.size() - near.size() / 10;
  std::size_t seen = 0;
  std::size_t found = 0;
  for (std::size_t l = 0; l < kLevels; ++l) {
    for (std::size_t k = level_begin[l]; k < level_begin[l + 1] && level_begin[l + 1] > first; ++k) {
      if (is_in_sample(near.range_m(by_level[k]))) {
        ++seen;
        found += stands_alone(by_level[k], dark) ? 1U : 0U;
      }
    }
  }
  const auto odds = static_cast<double>(found) / static_cast<double>(seen - found + 1);
  return static_cast<float>(std::max(config.surface_weight, kMostOdds * odds));
}

/// Goes up the levels of intensity and judges their points, until surfaces clearly outweigh flakes. The dark level is
/// where the flakes won most; -1 if they never did.
int SparseSnow::State::find_dark_level() {
  const float surface_weight = weigh_surfaces();
  const auto lost = kLostShare * static_cast<float>(near.size());
  float sum = 0.0F;
  float best = 0.0F;
  int best_level = -1;
  for (std::size_t l = 0; l < kLevels; ++l) {
    for (std::size_t k = level_begin[l]; k < level_begin[l + 1]; ++k) {
      const bool found = stands_alone(by_level[k], dark);
      alone[by_level[k]] = found ? 1 : 0;
      sum += found ? 1.0F : -surface_weight;
    }
    if (sum > best) {
      best = sum;
      best_level = static_cast<int>(l);
    }
    if (sum < best - lost) {
      break;
    }
  }
  for (std::size_t k = level_begin[static_cast<std::size_t>(best_level + 1)]; k < near.size(); ++k) {
    alone[by_level[k]] = 0;
  }
  return best_level;
}

/// Looks at a sample.
bool SparseSnow::State::snow_shows_above(int dark_level) const {
  std::size_t seen = 0;
  std::size_t found = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (level[i] > dark_level && is_in_sample(near.range_m(i))) {
      ++seen;
      found += stands_alone(i, bright) ? 1U : 0U;
    }
  }
  return static_cast<double>(found) > kShownShare * static_cast<double>(seen);
}

void SparseSnow::State::judge_above(int dark_level) {
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (level[i] > dark_level) {
      alone[i] = stands_alone(i, bright) ? 1 : 0;
    }
  }
}

/// Share of the dark points that stand alone.
double SparseSnow::State::purity(int dark_level) const {
  const std::size_t dark_points = level_begin[static_cast<std::size_t>(dark_level + 1)];
  std::size_t found = 0;
  for (std::size_t k = 0; k < dark_points; ++k) {
    found += alone[by_level[k]];
  }
  return dark_points > 0 ? static_cast<double>(found) / static_cast<double>(dark_points) : 0.0;
}

bool SparseSnow::State::is_snowfall(double purity) const {
  Spread spread(near);
  std::size_t marks = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (alone[i] != 0) {
      spread.add(near.sector(i));
      ++marks;
    }
  }
  const double heap_share = purity >= kPure ? kPureHeapShare : kHeapShare;
  const double needed = kLeastShare + heap_share * (1.0 - spread.evenness());
  return !config.ask_for_spread || static_cast<double>(marks) >= needed * static_cast<double>(near.size());
}

SparseSnow::SparseSnow(const SparseSnowConfig& config) : config_(config) {
  config_.check();
  state_ = std::make_unique<State>(config_);
}

SparseSnow::~SparseSnow() = default;

SnowResult SparseSnow::process(const PointsView& points, const Pose& /*T_base_sensor*/) {
  State& s = *state_;
  const SnowLimits limits = find_limits(points);
  s.falling.assign(points.size(), 0);
  s.near.build(points, s.max_range_m);
  s.alone.assign(s.near.size(), 0);
  double purity = 0.0;
  if (limits.no_intensity || !config_.use_intensity) {
    s.level.assign(s.near.size(), 0);
    s.judge_above(-1);
  } else {
    s.find_levels(points.intensity);
    const int dark_level = s.find_dark_level();
    purity = s.purity(dark_level);
    if (s.snow_shows_above(dark_level)) {
      s.judge_above(dark_level);
    }
  }
  std::size_t count = 0;
  if (s.is_snowfall(purity)) {
    for (std::size_t i = 0; i < s.near.size(); ++i) {
      s.falling[s.near.index(i)] = s.alone[i];
      count += s.alone[i];
    }
  }
  return {.falling = s.falling, .count = count, .limits = limits};
}

}  // namespace berm
