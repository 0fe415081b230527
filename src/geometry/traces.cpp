#include "berm/geometry/traces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

constexpr std::size_t kMaxLag = 64;    // lasers that take turns: 64 is the most that is built
constexpr std::size_t kProbes = 200;   // pairs that are looked at per lag
constexpr float kMaxStep_rad = 0.03F;  // between neighbours of a trace; the Mid-360 draws with 0.023
constexpr float kMinShare = 0.6F;      // of pairs that are neighbours, for an order to be believed
constexpr float kMinReach_m = 5.0F;
constexpr std::size_t kElevationBins = 1800;  // of 0.1 degrees
constexpr std::size_t kWidestRing = 4;        // bins: beams of a ring lie this near to each other,
constexpr std::size_t kMaxRings = 128;

/// Squared sine of the angle between two beams.
float squared_sine(const PointsView& points, std::size_t a, std::size_t b) {
  const float cx = points.y[a] * points.z[b] - points.z[a] * points.y[b];
  const float cy = points.z[a] * points.x[b] - points.x[a] * points.z[b];
  const float cz = points.x[a] * points.y[b] - points.y[a] * points.x[b];
  const float aa = points.x[a] * points.x[a] + points.y[a] * points.y[a] + points.z[a] * points.z[a];
  const float bb = points.x[b] * points.x[b] + points.y[b] * points.y[b] + points.z[b] * points.z[b];
  return (cx * cx + cy * cy + cz * cz) / (aa * bb);
}

/// Share of the pairs `lag` beams apart that are neighbours, and their mean squared distance in it; pairs without two
/// returns do not count.
struct Closeness {
  float share = 0.0F;
  float mean_squared_rad = 1.0F;
};

Closeness closeness(const PointsView& points, std::size_t lag) {
  if (points.size() <= lag) {
    return {};
  }
  const std::size_t last = points.size() - lag;
  const std::size_t stride = std::max<std::size_t>(1, last / kProbes);
  std::size_t pairs = 0;
  std::size_t close = 0;
  float sum = 0.0F;
  for (std::size_t i = 0; i < last; i += stride) {
    const float square = squared_sine(points, i, i + lag);
    if (!(square <= 1.0F)) {
      continue;  // not a number: no return
    }
    ++pairs;
    if (square < kMaxStep_rad * kMaxStep_rad) {
      ++close;
      sum += square;
    }
  }
  if (close == 0) {
    return {};
  }
  return {static_cast<float>(close) / static_cast<float>(pairs), sum / static_cast<float>(close)};
}

/// A trace breaks where beams are no neighbours, and where the next point lies much farther away than ground that is
/// as flat as the level would put it: dr = R^2 / h dphi.
BERM_MULTIVERSION void mark_breaks(float sensor_height_m, float max_squared_rad, Traces& traces) {
  const std::size_t size = traces.x.size();
  const float per_height = 3.0F / std::max(sensor_height_m, 0.1F);
  const float* x = traces.x.data();
  const float* y = traces.y.data();
  const float* z = traces.z.data();
  float* range = traces.range.data();
  float* step = traces.step.data();
  std::uint8_t* is_broken = traces.is_broken.data();
  for (std::size_t i = 0; i < size; ++i) {
    const float dz = z[i] - sensor_height_m;
    range[i] = std::sqrt(x[i] * x[i] + y[i] * y[i] + dz * dz);
  }
  for (std::size_t i = 1; i < size; ++i) {
    const float dx = x[i] - x[i - 1];
    const float dy = y[i] - y[i - 1];
    const float dz = z[i] - z[i - 1];
    const float dr = range[i] - range[i - 1];
    const float map2 = dx * dx + dy * dy;
    const float step2 = map2 + dz * dz;
    step[i] = std::sqrt(map2);
    const float squared_rad = std::max(step2 - dr * dr, 0.0F) / std::max(range[i] * range[i - 1], 0.01F);
    const float reach = 0.4F + per_height * std::sqrt(squared_rad) * range[i] * std::max(range[i], kMinReach_m);
    const bool breaks = squared_rad > max_squared_rad || step2 > reach * reach;
    is_broken[i] = breaks ? 1 : 0;
  }
}

/// Numbers the rings of a scan that does not tell them: most spinning sensors have beams at the elevations of a table,
/// with nothing between. Returns how many; 0: there are no such elevations.
std::size_t number_by_elevation(const PointsView& points, std::span<const Label> labels,
                                std::vector<std::uint32_t>& rings) {
  std::array<std::uint32_t, kElevationBins> number_of{};
  rings.resize(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    rings[i] = 0;
    if (labels[i] == Label::drivable) {
      const float elevation_rad =
          std::atan2(points.z[i], std::sqrt(points.x[i] * points.x[i] + points.y[i] * points.y[i]));
      const float place = (elevation_rad / std::numbers::pi_v<float> + 0.5F) * static_cast<float>(kElevationBins);
      rings[i] = static_cast<std::uint32_t>(std::clamp(place, 0.0F, static_cast<float>(kElevationBins - 1)));
      number_of[rings[i]] = 1;
    }
  }
  std::uint32_t count = 0;
  std::size_t width = 0;
  for (std::uint32_t& number : number_of) {
    width = number != 0 ? width + 1 : 0;
    count += width == 1 ? 1U : 0U;
    if (width > kWidestRing || count > kMaxRings) {
      return 0;
    }
    number = count > 0 ? count - 1 : 0;
  }
  for (std::uint32_t& ring : rings) {
    ring = number_of[ring];
  }
  return count > 1 ? count : 0;
}

/// In the order of the scan.
void list_ground(std::span<const Label> labels, std::vector<std::uint32_t>& index) {
  index.resize(labels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    // Written in any case and kept if ground: cheaper than a branch that nobody can foresee.
    index[count] = static_cast<std::uint32_t>(i);
    count += labels[i] == Label::drivable ? 1U : 0U;
  }
  index.resize(count);
}

void gather_channel(std::span<const std::uint32_t> index, const std::vector<float>& from, std::vector<float>& to) {
  to.resize(index.size());
  const float* __restrict source = from.data();
  float* __restrict target = to.data();
  for (std::size_t i = 0; i < index.size(); ++i) {
    target[i] = source[index[i]];
  }
}

bool is_mostly_broken(std::span<const std::uint8_t> is_broken) {
  const auto broken = std::count(is_broken.begin(), is_broken.end(), std::uint8_t{1});
  return static_cast<float>(broken) > (1.0F - kMinShare) * static_cast<float>(is_broken.size());
}

bool has_rings(const PointsView& points) {
  return !points.ring.empty() && std::any_of(points.ring.begin(), points.ring.end(),
                                             [&](std::uint16_t ring) { return ring != points.ring[0]; });
}

}  // namespace

const Traces& TraceFinder::process(const PointsView& points, std::span<const Label> labels, const LevelPoints& level,
                                   const bearing_grid::SectorTable& sectors) {
  choose_order(points);
  switch (traces_.kind) {
    case TraceKind::firing:
      list_ground(labels, traces_.index);
      break;
    case TraceKind::interleaved:
      keys_.resize(points.size());
      for (std::size_t i = 0; i < keys_.size(); ++i) {
        keys_[i] = static_cast<std::uint32_t>(i % lag_);
      }
      order_by(keys_, lag_, labels);
      break;
    case TraceKind::rings:
      keys_.assign(points.ring.begin(), points.ring.end());
      order_by(keys_, std::size_t{*std::max_element(keys_.begin(), keys_.end())} + 1, labels);
      break;
    case TraceKind::radial:
      if (const std::size_t rings = number_by_elevation(points, labels, keys_); rings > 0) {
        traces_.kind = TraceKind::rings;
        order_by(keys_, rings, labels);
      } else {
        order_radially(labels, level, sectors);
      }
      break;
  }
  gather(level);
  find_breaks(level);
  if (traces_.kind == TraceKind::rings && is_mostly_broken(traces_.is_broken)) {
    order_around(level);  // rings, but not in firing order
    gather(level);
    find_breaks(level);
  }
  if (traces_.kind == TraceKind::rings && is_mostly_broken(traces_.is_broken)) {
    traces_.kind = TraceKind::radial;
    order_radially(labels, level, sectors);
    gather(level);
    find_breaks(level);
  }
  return traces_;
}

void TraceFinder::choose_order(const PointsView& points) {
  lag_ = 1;
  if (has_rings(points)) {
    traces_.kind = TraceKind::rings;
    return;
  }
  Closeness best = closeness(points, 1);
  if (best.share >= kMinShare) {
    traces_.kind = TraceKind::firing;
    return;
  }
  for (std::size_t lag = 2; lag <= kMaxLag; ++lag) {
    const Closeness candidate = closeness(points, lag);
    if (candidate.share >= kMinShare && candidate.mean_squared_rad < best.mean_squared_rad) {
      best = candidate;
      lag_ = lag;
    }
  }
  traces_.kind = lag_ > 1 ? TraceKind::interleaved : TraceKind::radial;
}

/// Counting sort of the ground points by `keys`; the firing order stays within a key. Leaves in `starts_` where each
/// key ends.
void TraceFinder::order_by(std::span<const std::uint32_t> keys, std::size_t key_count, std::span<const Label> labels) {
  starts_.assign(key_count + 1, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    starts_[keys[i] + 1] += labels[i] == Label::drivable ? 1U : 0U;
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  traces_.index.resize(starts_.back());
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == Label::drivable) {
      traces_.index[starts_[keys[i]]++] = i;
    }
  }
}

/// Each ring by azimuth, clockwise as most sensors turn.
void TraceFinder::order_around(const LevelPoints& level) {
  std::uint32_t begin = 0;
  for (const std::uint32_t end : starts_) {
    std::sort(traces_.index.begin() + begin, traces_.index.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
      return level.turn[a] != level.turn[b] ? level.turn[a] > level.turn[b] : a < b;
    });
    begin = end;
  }
}

void TraceFinder::order_radially(std::span<const Label> labels, const LevelPoints& level,
                                 const bearing_grid::SectorTable& sectors) {
  keys_.resize(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    keys_[i] = labels[i] == Label::drivable ? std::uint32_t{sectors[level.turn[i]]} : 0;
  }
  order_by(keys_, bearing_grid::kSectors, labels);

  std::uint32_t begin = 0;
  for (std::size_t key = 0; key + 1 < starts_.size(); ++key) {
    std::sort(traces_.index.begin() + begin, traces_.index.begin() + starts_[key],
              [&](std::uint32_t a, std::uint32_t b) {
                const float range_a = level.range2[a];
                const float range_b = level.range2[b];
                return range_a != range_b ? range_a < range_b : a < b;
              });
    begin = starts_[key];
  }
}

void TraceFinder::gather(const LevelPoints& level) {
  gather_channel(traces_.index, level.x, traces_.x);
  gather_channel(traces_.index, level.y, traces_.y);
  gather_channel(traces_.index, level.z, traces_.z);
}

void TraceFinder::find_breaks(const LevelPoints& level) {
  traces_.range.resize(traces_.index.size());
  traces_.step.resize(traces_.index.size());
  traces_.is_broken.resize(traces_.index.size());
  const float max_squared_rad = traces_.kind == TraceKind::radial ? 4.0F : kMaxStep_rad * kMaxStep_rad;
  mark_breaks(level.sensor_height_m, max_squared_rad, traces_);
  if (!traces_.is_broken.empty()) {
    traces_.is_broken[0] = 1;
    traces_.step[0] = 0.0F;
  }
  if (traces_.kind == TraceKind::firing) {
    return;
  }
  for (const std::uint32_t end : starts_) {
    if (end < traces_.is_broken.size()) {
      traces_.is_broken[end] = 1;
    }
  }
}

}  // namespace berm
