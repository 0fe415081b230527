#include "trace_windows.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

constexpr std::size_t kMinPoints = 4;
constexpr float kLengthPerRange = 0.05F;
constexpr float kMinDirection_m = 0.15F;  // shorter windows have no slope to speak of

/// Sums over the points of a window, relative to its first.
struct Sums {
  float x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;

  void add(float dx, float dy, float dz) {
    x += dx;
    y += dy;
    z += dz;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    xz += dx * dz;
    yz += dy * dz;
    zz += dz * dz;
  }
};

void add_window(const Traces& t, std::size_t first, std::size_t last, const Sums& sums, float window_m,
                TraceWindows& windows, std::size_t place) {
  const auto n = static_cast<float>(last - first + 1);
  const float mx = sums.x / n;
  const float my = sums.y / n;
  const float mz = sums.z / n;
  const float x = t.x[first] + mx;
  const float y = t.y[first] + my;
  const float range = std::max(std::sqrt(x * x + y * y), 0.01F);
  float ux = t.x[last] - t.x[first];
  float uy = t.y[last] - t.y[first];
  const float length = std::sqrt(ux * ux + uy * uy);
  const bool has_direction = length >= kMinDirection_m;
  ux = has_direction ? ux / length : x / range;
  uy = has_direction ? uy / length : y / range;

  const float tt =
      ux * ux * (sums.xx - n * mx * mx) + 2.0F * ux * uy * (sums.xy - n * mx * my) + uy * uy * (sums.yy - n * my * my);
  const float tz = ux * (sums.xz - n * mx * mz) + uy * (sums.yz - n * my * mz);
  const float zz = sums.zz - n * mz * mz;
  const float slope = has_direction && tt > 0.0F ? tz / tt : 0.0F;

  windows.x[place] = x;
  windows.y[place] = y;
  windows.z[place] = t.z[first] + mz;
  windows.along_x[place] = ux;
  windows.along_y[place] = uy;
  windows.slope[place] = slope;
  windows.variance_m2[place] = std::max(zz - slope * tz, 0.0F) / (n - 2.0F);
  windows.length_m[place] = length;
  windows.nominal_m[place] = std::max(window_m, kLengthPerRange * range);
  windows.range_m[place] = range;
}

}  // namespace

void TraceWindows::resize(std::size_t size) {
  for (auto* channel : {&x, &y, &z, &along_x, &along_y, &slope, &variance_m2, &length_m, &nominal_m, &range_m}) {
    channel->resize(size);
  }
}

void cut_windows(const Traces& traces, double window_m, TraceWindows& windows) {
  const auto nominal_m = static_cast<float>(window_m);
  const std::size_t size = traces.index.size();
  windows.resize(size / kMinPoints);
  std::size_t count = 0;
  std::size_t first = 0;
  while (first < size) {
    const float limit = std::max(nominal_m, kLengthPerRange * traces.range[first]);
    Sums sums;
    float length = 0.0F;
    std::size_t next = first + 1;
    for (; next < size && traces.is_broken[next] == 0; ++next) {
      length += traces.step[next];
      if (length > limit && next - first >= kMinPoints) {
        break;
      }
      sums.add(traces.x[next] - traces.x[first], traces.y[next] - traces.y[first], traces.z[next] - traces.z[first]);
    }
    if (next - first >= kMinPoints) {
      add_window(traces, first, next - 1, sums, nominal_m, windows, count);
      ++count;
    }
    first = next;
  }
  windows.resize(count);
}

}  // namespace berm
