#include "piste/bad_scans.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

#include "berm/core/angle.hpp"
#include "piste/mid70_scan.hpp"
#include "support/random_points.hpp"

namespace berm::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

PointChannels copy_of(const PointsView& view) {
  PointChannels channels;
  channels.x.assign(view.x.begin(), view.x.end());
  channels.y.assign(view.y.begin(), view.y.end());
  channels.z.assign(view.z.begin(), view.z.end());
  return channels;
}

/// Snow sends back 150, a few flakes less than 4.
PointChannels good_scan() {
  PointChannels channels = copy_of(mid70_scan().cloud.view());
  for (std::size_t i = 0; i < channels.x.size(); ++i) {
    const bool none = is_no_return(channels.x[i], channels.y[i], channels.z[i]);
    channels.intensity.push_back(none ? 0.0F : 150.0F);
    channels.time.push_back(static_cast<float>(i) * 1e-5F);
  }
  return channels;
}

template <typename Value>
void pick(std::vector<Value>& values, const std::vector<std::size_t>& order) {
  if (values.empty()) {
    return;
  }
  std::vector<Value> picked;
  for (const std::size_t i : order) {
    picked.push_back(values[i]);
  }
  values = std::move(picked);
}

/// Points `order[0]`, `order[1]`, ... of `channels`.
PointChannels picked(PointChannels channels, const std::vector<std::size_t>& order) {
  pick(channels.x, order);
  pick(channels.y, order);
  pick(channels.z, order);
  pick(channels.intensity, order);
  pick(channels.time, order);
  return channels;
}

PointChannels shuffled(const PointChannels& channels) {
  std::vector<std::size_t> order(channels.x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(1);
  for (std::size_t i = order.size(); i > 1; --i) {  // std::shuffle differs between standard libraries
    std::swap(order[i - 1], order[random() % i]);
  }
  return picked(channels, order);
}

PointChannels without_no_returns(const PointChannels& channels) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < channels.x.size(); ++i) {
    if (!is_no_return(channels.x[i], channels.y[i], channels.z[i])) {
      order.push_back(i);
    }
  }
  return picked(channels, order);
}

/// Turned about the sensor, as if it hung otherwise than the mount says.
PointChannels turned(PointChannels channels, double yaw_deg, double pitch_deg, double roll_deg) {
  const Pose turn =
      Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg, {0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < channels.x.size(); ++i) {
    const Eigen::Vector3d p = turn * Eigen::Vector3d(channels.x[i], channels.y[i], channels.z[i]);
    channels.x[i] = static_cast<float>(p.x());
    channels.y[i] = static_cast<float>(p.y());
    channels.z[i] = static_cast<float>(p.z());
  }
  return channels;
}

/// Two sensors in one cloud, one after the other, the second looking to the left.
PointChannels merged(const PointChannels& first) {
  PointChannels both = first;
  const PointChannels second = turned(first, 90.0, 0.0, 0.0);
  both.x.insert(both.x.end(), second.x.begin(), second.x.end());
  both.y.insert(both.y.end(), second.y.begin(), second.y.end());
  both.z.insert(both.z.end(), second.z.begin(), second.z.end());
  both.intensity.insert(both.intensity.end(), second.intensity.begin(), second.intensity.end());
  both.time.insert(both.time.end(), second.time.begin(), second.time.end());
  return both;
}

/// That share of the beams meets a flake within 12 m.
PointChannels in_snowfall(PointChannels channels, double share) {
  const std::vector<Eigen::Vector3d> directions = mid70_beams().directions;
  std::mt19937 random(2);
  const auto uniform = [&random] { return static_cast<double>(random()) * 0x1p-32; };
  for (std::size_t i = 0; i < channels.x.size(); ++i) {
    if (uniform() < share) {
      const Eigen::Vector3d p = (0.5 + 11.5 * uniform()) * directions[i];
      channels.x[i] = static_cast<float>(p.x());
      channels.y[i] = static_cast<float>(p.y());
      channels.z[i] = static_cast<float>(p.z());
      channels.intensity[i] = static_cast<float>(random() % 5);
    }
  }
  return channels;
}

/// Every `step`-th point has one bad coordinate, or all of them.
PointChannels with_bad_numbers(PointChannels channels, std::size_t step) {
  constexpr float kBad[] = {kNan, kInf, -kInf, std::numeric_limits<float>::max(), 1e20F, 1e-42F};
  for (std::size_t i = 0; i < channels.x.size(); i += step) {
    const float bad = kBad[i / step % 6];
    const std::size_t which = i / step / 6 % 4;
    channels.x[i] = which == 0 || which == 3 ? bad : channels.x[i];
    channels.y[i] = which == 1 || which == 3 ? bad : channels.y[i];
    channels.z[i] = which == 2 || which == 3 ? bad : channels.z[i];
    channels.intensity[i] = kBad[(i / step + 1) % 6];
    channels.time[i] = kBad[(i / step + 2) % 6];
  }
  return channels;
}

PointChannels all_equal(float x_m, float y_m, float z_m, std::size_t count) {
  PointChannels channels;
  channels.x.assign(count, x_m);
  channels.y.assign(count, y_m);
  channels.z.assign(count, z_m);
  channels.intensity.assign(count, 0.0F);
  channels.time.assign(count, 0.0F);
  return channels;
}

}  // namespace

std::vector<BadScan> bad_scans() {
  const PointChannels good = good_scan();
  PointChannels no_intensity = good;
  no_intensity.intensity.clear();
  PointChannels dark = good;
  std::fill(dark.intensity.begin(), dark.intensity.end(), 0.0F);
  PointChannels even = good;
  std::fill(even.intensity.begin(), even.intensity.end(), 100.0F);
  PointChannels no_time = good;
  no_time.time.clear();
  PointChannels bare = without_no_returns(no_time);
  bare.intensity.clear();

  std::vector<BadScan> scans;
  const auto add = [&scans](const char* name, PointChannels channels) {
    scans.push_back({name, PointCloud(std::move(channels))});
  };
  add("as_it_should_be", good);
  add("no_firing_order", shuffled(good));
  add("no_reflectivity", no_intensity);
  add("reflectivity_0", dark);
  add("reflectivity_all_equal", even);
  add("no_returns_dropped", without_no_returns(good));
  add("no_time", no_time);
  add("coordinates_alone_in_no_order", shuffled(bare));
  add("two_sensors_merged", merged(good));
  add("some_nan", with_bad_numbers(good, 100));
  add("much_nan", with_bad_numbers(good, 3));
  add("nothing_but_nan", all_equal(kNan, kNan, kNan, 10000));
  add("nothing_but_infinity", all_equal(kInf, -kInf, kInf, 10000));
  add("nothing_but_no_returns", all_equal(0.0F, 0.0F, 0.0F, 10000));
  add("flakes_60_percent", in_snowfall(good, 0.6));
  add("nothing_but_flakes", in_snowfall(good, 1.0));
  add("upside_down", turned(good, 0.0, 0.0, 180.0));
  add("nose_30_degrees_too_low", turned(good, 0.0, 30.0, 0.0));
  add("nose_30_degrees_too_high", turned(good, 0.0, -30.0, 0.0));
  add("rolled_by_30_degrees", turned(good, 0.0, 0.0, 30.0));
  add("looking_backwards", turned(good, 180.0, 0.0, 0.0));
  add("empty", {});
  add("one_point", all_equal(10.0F, 1.0F, -1.0F, 1));
  add("two_equal_points", all_equal(10.0F, 1.0F, -1.0F, 2));
  add("all_points_equal", all_equal(10.0F, 1.0F, -1.0F, 10000));
  add("all_points_below", all_equal(0.0F, 0.0F, -2.3F, 10000));
  add("any_numbers", random_points(10000, 3, ChannelSet{.intensity = true, .time = true}));
  return scans;
}

}  // namespace berm::test
