#include "void_view.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

constexpr std::size_t kEvery = 3;  // points: five to ten of a ring lie in a sector
constexpr int kFirst = 2;          // sectors of 2 degrees onward: the trace itself reaches into the first ones
constexpr int kLast = 5;           // a beam that a puddle or a dark stone swallows leaves a narrower gap
constexpr float kNearer_m = 0.1F;  // the lip comes nearer there, or the trace would still be on the road
constexpr float kEndless_m2 = 1e12F;
constexpr float kHigh_m = 0.3F;  // what stands so high hides what is behind
constexpr float kAround = 0.5F;  // sine between beam and trace: outward, the range of the sensor ends as a lip does

}  // namespace

void VoidView::process(const Traces& traces, std::span<const float> height_m, float min_drop_m) {
  farthest2_.fill(0.0F);
  for (std::size_t i = 0; i < height_m.size(); i += kEvery) {
    if (height_m[i] > -min_drop_m) {
      float& farthest2 = farthest2_[static_cast<std::size_t>(sectors_.of(traces.x[i], traces.y[i]))];
      const float range2 = traces.x[i] * traces.x[i] + traces.y[i] * traces.y[i];
      farthest2 = height_m[i] > kHigh_m ? kEndless_m2 : std::max(farthest2, range2);
    }
  }
}

bool VoidView::ends_at(const Traces& traces, std::size_t before, std::size_t end) const {
  const float x = traces.x[end];
  const float y = traces.y[end];
  const float dx = x - traces.x[before];
  const float dy = y - traces.y[before];
  const float range_m = std::sqrt(x * x + y * y);
  const float around = (x * dy - y * dx) / std::max(range_m * std::sqrt(dx * dx + dy * dy), 1e-3F);
  if (std::abs(around) < kAround) {
    return false;
  }
  const float free_m = range_m - kNearer_m;
  const int sector = static_cast<int>(sectors_.of(x, y));
  const int count = static_cast<int>(kSectors);
  for (int step = kFirst; step <= kLast; ++step) {
    const int onward = around > 0.0F ? sector + step : sector - step;
    const float farthest2 = farthest2_[static_cast<std::size_t>((onward + count) % count)];
    if (farthest2 > free_m * free_m || (farthest2 == 0.0F && step == kFirst)) {
      return false;
    }
  }
  return true;
}

}  // namespace berm
