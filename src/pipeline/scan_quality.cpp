#include "scan_quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

namespace berm {
namespace {

/// Fewer returns than this, or a smaller share of the beams, say little about a scene.
constexpr std::size_t kFewReturns = 100;
constexpr double kFewReturnsShare = 0.02;
constexpr double kManyInvalidShare = 0.01;

// The rule of `berm info` for scans without order, with fewer samples: the beam moves from one point to the next, at
// the best of 16 distances in the list, by more than a fifth of the way between points that have nothing in common.
constexpr std::size_t kMaxLag = 16;
constexpr std::size_t kSamples = 128;
constexpr std::size_t kMinSamples = 32;
constexpr double kUnorderedShare = 0.2;
/// A prime, so that pairs of points spread over the whole scan.
constexpr std::size_t kScatter = 7919;

constexpr std::array kAll = {
    Degradation::no_points,        Degradation::few_returns,     Degradation::no_ground,
    Degradation::invalid_points,   Degradation::no_intensity,    Degradation::no_returns_dropped,
    Degradation::no_time,          Degradation::no_firing_order, Degradation::snow_hides_the_scene,
    Degradation::mount_implausible};
static_assert(kAll.size() == kDegradations);

/// Whether no two of the values differ; NaN is none.
bool is_constant(std::span<const float> values) {
  const auto first = std::find_if_not(values.begin(), values.end(), [](float value) { return std::isnan(value); });
  return std::none_of(first, values.end(), [first](float value) { return value < *first || value > *first; });
}

std::optional<Eigen::Vector3f> direction(const PointsView& points, std::size_t i) {
  const Eigen::Vector3f point(points.x[i], points.y[i], points.z[i]);
  const float range_m = point.norm();
  if (!(range_m > 0.0F) || !std::isfinite(range_m)) {
    return std::nullopt;
  }
  return Eigen::Vector3f(point / range_m);
}

/// Cosines between the beams of pairs of points; the middle one.
class PairSample {
 public:
  void add(const PointsView& points, std::size_t i, std::size_t j) {
    const auto a = direction(points, i);
    const auto b = direction(points, j);
    if (a && b) {
      cosines_[count_++] = a->dot(*b);
    }
  }

  [[nodiscard]] std::optional<double> median_rad() {
    if (count_ < kMinSamples) {
      return std::nullopt;
    }
    const auto middle = cosines_.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
    std::nth_element(cosines_.begin(), middle, cosines_.begin() + static_cast<std::ptrdiff_t>(count_));
    return std::acos(std::clamp(static_cast<double>(*middle), -1.0, 1.0));
  }

 private:
  std::array<float, kSamples> cosines_{};
  std::size_t count_ = 0;
};

/// std::count in blocks whose sum fits into a byte: sixteen labels are compared at a time.
std::size_t count_of(std::span<const Label> labels, Label label) {
  constexpr std::size_t kBlock = 240;
  std::size_t count = 0;
  while (!labels.empty()) {
    std::uint8_t in_block = 0;
    for (const Label it : labels.first(std::min(labels.size(), kBlock))) {
      in_block = static_cast<std::uint8_t>(in_block + (it == label ? 1 : 0));
    }
    count += in_block;
    labels = labels.subspan(std::min(labels.size(), kBlock));
  }
  return count;
}

}  // namespace

bool has_firing_order(const PointsView& points) {
  const std::size_t n = points.size();
  if (n < kSamples + kMaxLag) {
    return true;
  }
  const auto place = [n](std::size_t sample) { return sample * (n - kMaxLag) / kSamples; };
  PairSample strangers;
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    strangers.add(points, place(sample), (place(sample) * kScatter + n / 2) % n);
  }
  const std::optional<double> far_rad = strangers.median_rad();
  if (!far_rad) {
    return true;
  }
  bool told = false;
  for (std::size_t lag = 1; lag <= kMaxLag; ++lag) {
    PairSample neighbours;
    for (std::size_t sample = 0; sample < kSamples; ++sample) {
      neighbours.add(points, place(sample), place(sample) + lag);
    }
    const std::optional<double> near_rad = neighbours.median_rad();
    if (near_rad && *near_rad <= kUnorderedShare * *far_rad) {
      return true;
    }
    told |= near_rad.has_value();
  }
  return !told;
}

Degradations find_degradations(const PointsView& points, const SnowLimits& limits, const ScanResult& result) {
  Degradations found;
  const auto add_if = [&found](bool condition, Degradation degradation) {
    if (condition) {
      found.add(degradation);
    }
  };
  if (points.empty()) {
    found.add(Degradation::no_points);
    return found;
  }
  const LabelCounts& counts = result.counts;
  const std::size_t solid = counts.returns() - counts.falling_snow;
  const auto all = static_cast<double>(points.size());
  const bool few = counts.returns() < kFewReturns || static_cast<double>(counts.returns()) < kFewReturnsShare * all;
  add_if(few, Degradation::few_returns);
  add_if(!few && counts.drivable + counts.terrain == 0, Degradation::no_ground);
  add_if(static_cast<double>(counts.invalid) > kManyInvalidShare * all, Degradation::invalid_points);
  add_if(limits.no_intensity, Degradation::no_intensity);
  add_if(limits.no_returns_dropped, Degradation::no_returns_dropped);
  add_if(points.size() > 1 && is_constant(points.time), Degradation::no_time);
  add_if(!has_firing_order(points), Degradation::no_firing_order);
  add_if(counts.falling_snow > solid, Degradation::snow_hides_the_scene);
  add_if(result.mount.verdict == MountVerdict::implausible, Degradation::mount_implausible);
  return found;
}

LabelCounts count_labels(std::span<const Label> labels) {
  const auto of = [labels](Label label) { return count_of(labels, label); };
  return {.drivable = of(Label::drivable),
          .terrain = of(Label::terrain),
          .obstacle = of(Label::obstacle),
          .falling_snow = of(Label::falling_snow),
          .no_return = of(Label::no_return),
          .invalid = of(Label::unlabeled)};
}

std::string_view to_string(Degradation degradation) {
  switch (degradation) {
    case Degradation::no_points:
      return "no_points";
    case Degradation::few_returns:
      return "few_returns";
    case Degradation::no_ground:
      return "no_ground";
    case Degradation::invalid_points:
      return "invalid_points";
    case Degradation::no_intensity:
      return "no_intensity";
    case Degradation::no_returns_dropped:
      return "no_returns_dropped";
    case Degradation::no_time:
      return "no_time";
    case Degradation::no_firing_order:
      return "no_firing_order";
    case Degradation::snow_hides_the_scene:
      return "snow_hides_the_scene";
    case Degradation::mount_implausible:
      break;
  }
  return "mount_implausible";
}

std::string Degradations::text() const {
  std::string text;
  for (const Degradation degradation : kAll) {
    if (has(degradation)) {
      text += (text.empty() ? "" : "+") + std::string(to_string(degradation));
    }
  }
  return text;
}

}  // namespace berm
