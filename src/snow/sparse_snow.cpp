#include "berm/snow/sparse_snow.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
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

/// Samples hold one point in 2^5, where that leaves enough.
constexpr unsigned kSampleBits = 5;
/// Of the brightest points so many tell their share of flakes to a few percent.
constexpr std::size_t kBrightSample = 256;

/// One point in 2^bits, chosen by the bits of its range, so that the order of points does not matter.
bool is_in_sample(float range_m, unsigned bits) {
  return (std::bit_cast<std::uint32_t>(range_m) * 2654435769U >> (32U - kSampleBits)) >> (kSampleBits - bits) == 0;
}

/// How alone a flake has to be.
struct Demand {
  float points;
  float share;
};

/// What `judge` goes by.
struct Rule {
  float max_range_m;
  float window;
  bool fade_with_range;
  bool spare_lines;
};

/// Writes 1 for each of the near points `which` that stands alone, else 0. First all neighbours are counted, without a
/// branch that nobody can foresee; then few points are left for a look at lines.
void judge(const NearPoints& near, std::span<const std::uint32_t> which, const Rule& rule, const Demand& demand,
           std::vector<std::uint32_t>& may_be_lines, std::uint8_t* alone) {
  may_be_lines.resize(which.size() + 1);
  std::size_t lines = 0;
  for (std::size_t k = 0; k < which.size(); ++k) {
    const float range_m = near.range_m(which[k]);
    const float share = rule.fade_with_range ? range_m / rule.max_range_m : 0.0F;
    const NearPoints::Around around = near.count_around(which[k], rule.window * range_m);
    const float limit = (demand.points + demand.share * static_cast<float>(around.all)) * (1.0F - share * share);
    const std::uint32_t is_few = static_cast<float>(around.like) < limit ? 1U : 0U;
    alone[k] = static_cast<std::uint8_t>(is_few);
    may_be_lines[lines] = static_cast<std::uint32_t>(k);
    lines += is_few & (around.like >= 2 ? 1U : 0U);
  }
  for (std::size_t l = 0; l < lines && rule.spare_lines; ++l) {
    const std::uint32_t k = may_be_lines[l];
    if (near.lies_on_line(which[k], kLineWindow * near.range_m(which[k]) + kLineNoise_m, kLineShare)) {
      alone[k] = 0;
    }
  }
}

std::size_t count_ones(std::span<const std::uint8_t> flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), std::uint8_t{1}));
}

}  // namespace

struct SparseSnow::State {
  explicit State(const SparseSnowConfig& c)
      : config(c),
        max_range_m(static_cast<float>(c.max_range_m)),
        rule{max_range_m, static_cast<float>(c.window), c.fade_with_range, c.spare_lines},
        dark{static_cast<float>(c.dark_points), static_cast<float>(c.dark_share)},
        bright{static_cast<float>(c.bright_points), static_cast<float>(c.bright_share)} {}

  /// Takes the memory that any scan of so many points can need.
  void reserve(std::size_t points);
  void find_levels(std::span<const float> intensity);
  void sort_by_level();
  void find_sample();
  /// Judges a part of `by_level`, or what was chosen; says how many stand alone.
  std::size_t judge_part(std::size_t begin, std::size_t end, const Demand& demand);
  [[nodiscard]] std::size_t judge_chosen(const Demand& demand);
  [[nodiscard]] float weigh_surfaces();
  [[nodiscard]] std::size_t find_dark();
  [[nodiscard]] bool snow_shows_beyond(std::size_t dark_points);
  void list_marks();
  [[nodiscard]] bool is_snowfall(double purity) const;

  SparseSnowConfig config;
  float max_range_m;
  Rule rule;
  Demand dark;
  Demand bright;

  NearPoints near;
  std::vector<std::uint8_t> level;  ///< of intensity, of every near point
  /// How many near points of even and of odd number have a level.
  std::array<std::array<std::uint32_t, 2>, kLevels> level_counts{};
  std::array<std::uint32_t, kLevels + 1> level_begin{};  ///< of a level in `by_level`
  std::vector<std::uint32_t> by_level;                   ///< near points, sorted by level
  std::vector<std::uint8_t> alone;                       ///< of the first of `by_level`: 1 for a flake
  std::vector<std::uint32_t> sample;                     ///< near points, one in 32
  std::vector<std::uint32_t> chosen;                     ///< of the sample
  std::vector<std::uint8_t> chosen_alone;
  std::vector<std::uint32_t> may_be_lines;
  std::vector<std::uint32_t> marks;  ///< near points that were found to be flakes
  std::vector<std::uint8_t> falling;
};

void SparseSnow::State::reserve(std::size_t points) {
  for (auto* flags : {&level, &alone, &chosen_alone}) {
    flags->reserve(points);
  }
  for (auto* indices : {&by_level, &sample, &chosen, &may_be_lines, &marks}) {
    indices->reserve(points + 1);
  }
}

void SparseSnow::State::find_levels(std::span<const float> intensity) {
  const std::span<const std::uint32_t> index = near.indices();
  level.resize(index.size());
  const float* __restrict from = intensity.data();
  std::uint8_t* __restrict to = level.data();
  std::array<std::array<std::uint32_t, 2>, kLevels>& counts = level_counts;
  counts.fill({});
  for (std::size_t i = 0; i < index.size(); ++i) {
    const std::uint8_t l = level_of(from[index[i]]);
    to[i] = l;
    ++counts[l][i % 2];
  }
}

/// Each level has two sums and two places, for near points of even and of odd number, so that neighbours of one level
/// need not wait for each other.
void SparseSnow::State::sort_by_level() {
  const std::size_t size = near.size();
  std::array<std::array<std::uint32_t, 2>, kLevels>& place = level_counts;
  std::uint32_t sum = 0;
  for (std::size_t l = 0; l < kLevels; ++l) {
    level_begin[l] = sum;
    for (std::uint32_t& part : place[l]) {
      sum += std::exchange(part, sum);
    }
  }
  level_begin[kLevels] = sum;
  by_level.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    by_level[place[level[i]][i % 2]++] = static_cast<std::uint32_t>(i);
  }
}

void SparseSnow::State::find_sample() {
  const std::size_t size = near.size();
  sample.resize(size + 1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; ++i) {
    // Written in any case and kept if it belongs: cheaper than a branch that nobody can foresee.
    sample[count] = static_cast<std::uint32_t>(i);
    count += is_in_sample(near.range_m(i), kSampleBits) ? 1U : 0U;
  }
  sample.resize(count);
}

std::size_t SparseSnow::State::judge_part(std::size_t begin, std::size_t end, const Demand& demand) {
  judge(near, std::span(by_level).subspan(begin, end - begin), rule, demand, may_be_lines, alone.data() + begin);
  return count_ones(std::span(alone).subspan(begin, end - begin));
}

std::size_t SparseSnow::State::judge_chosen(const Demand& demand) {
  chosen_alone.resize(chosen.size());
  judge(near, chosen, rule, demand, may_be_lines, chosen_alone.data());
  return count_ones(chosen_alone);
}

/// What a surface point counts against a flake, at least as much as makes the brightest tenth of the points a loss:
/// they are no flakes, and where beams are sparse many of them look like some all the same.
float SparseSnow::State::weigh_surfaces() {
  if (near.size() == 0) {
    return static_cast<float>(config.surface_weight);
  }
  const std::size_t tenth = near.size() - std::max<std::size_t>(1, near.size() / 10);
  const std::size_t first = level_begin[level[by_level[tenth]]];
  unsigned bits = 0;
  while (bits < kSampleBits && (near.size() - first) >> (bits + 1) >= kBrightSample) {
    ++bits;
  }
  chosen.clear();
  for (std::size_t k = first; k < near.size(); ++k) {
    if (is_in_sample(near.range_m(by_level[k]), bits)) {
      chosen.push_back(by_level[k]);
    }
  }
  const std::size_t found = judge_chosen(dark);
  const auto odds = static_cast<double>(found) / static_cast<double>(chosen.size() - found + 1);
  return static_cast<float>(std::max(config.surface_weight, kMostOdds * odds));
}

/// Goes up the levels of intensity and judges their points, until surfaces clearly outweigh flakes. Dark ends where the
/// flakes won most. Leaves the dark points judged; says how many these are, 0 if flakes never won.
std::size_t SparseSnow::State::find_dark() {
  const float surface_weight = weigh_surfaces();
  const auto lost = kLostShare * static_cast<float>(near.size());
  alone.resize(near.size());
  std::size_t flakes = 0;
  float best = 0.0F;
  std::size_t dark_points = 0;
  for (std::size_t l = 0; l < kLevels; ++l) {
    const std::size_t begin = level_begin[l];
    const std::size_t end = level_begin[l + 1];
    flakes += judge_part(begin, end, dark);
    const float sum = static_cast<float>(flakes) - surface_weight * static_cast<float>(end - flakes);
    if (sum > best) {
      best = sum;
      dark_points = end;
    }
    if (sum < best - lost) {
      break;
    }
  }
  alone.resize(dark_points);
  return dark_points;
}

/// Looks at a sample.
bool SparseSnow::State::snow_shows_beyond(std::size_t dark_points) {
  chosen.clear();
  for (const std::uint32_t i : sample) {
    if (level_begin[level[i]] >= dark_points) {
      chosen.push_back(i);
    }
  }
  return static_cast<double>(judge_chosen(bright)) > kShownShare * static_cast<double>(chosen.size());
}

/// Lists what stands alone.
void SparseSnow::State::list_marks() {
  marks.resize(alone.size() + 1);
  std::size_t count = 0;
  for (std::size_t k = 0; k < alone.size(); ++k) {
    marks[count] = by_level[k];
    count += alone[k];
  }
  marks.resize(count);
}

/// `purity`: share of the dark points that stand alone.
bool SparseSnow::State::is_snowfall(double purity) const {
  Spread spread(near);
  for (const std::uint32_t i : marks) {
    spread.add(near.sector(i));
  }
  const double heap_share = purity >= kPure ? kPureHeapShare : kHeapShare;
  const double needed = kLeastShare + heap_share * (1.0 - spread.evenness());
  return !config.ask_for_spread || static_cast<double>(marks.size()) >= needed * static_cast<double>(near.size());
}

SparseSnow::SparseSnow(const SparseSnowConfig& config) : config_(config) {
  config_.check();
  state_ = std::make_unique<State>(config_);
}

SparseSnow::~SparseSnow() = default;

SnowResult SparseSnow::process(const PointsView& points, const Pose& /*T_base_sensor*/) {
  State& s = *state_;
  const SnowLimits limits = find_limits(points);
  s.reserve(points.size());
  s.falling.assign(points.size(), 0);
  s.near.build(points, s.max_range_m);
  double purity = 0.0;
  if (limits.no_intensity || !config_.use_intensity) {
    s.by_level.resize(s.near.size());
    std::iota(s.by_level.begin(), s.by_level.end(), 0U);
    s.alone.resize(s.near.size());
    s.judge_part(0, s.near.size(), s.bright);
  } else {
    s.find_levels(points.intensity);
    s.sort_by_level();
    s.find_sample();
    const std::size_t dark_points = s.find_dark();
    if (dark_points > 0) {
      purity = static_cast<double>(count_ones(s.alone)) / static_cast<double>(dark_points);
    }
    if (s.snow_shows_beyond(dark_points)) {
      s.alone.resize(s.near.size());
      s.judge_part(dark_points, s.near.size(), s.bright);
    }
  }
  s.list_marks();
  if (!s.is_snowfall(purity)) {
    s.marks.clear();
  }
  for (const std::uint32_t i : s.marks) {
    s.falling[s.near.index(i)] = 1;
  }
  return {.falling = s.falling, .count = s.marks.size(), .limits = limits};
}

}  // namespace berm
