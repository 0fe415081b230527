#include "road_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berm {
namespace {

constexpr float kHigh_m = 0.5F;
constexpr float kViewMargin_m = 0.5F;
constexpr float kMarginShare = 0.02F;

}  // namespace

void RoadView::clear() {
  range2_.fill(std::numeric_limits<float>::max());
}

void RoadView::add(float x_m, float y_m) {
  float& range2 = range2_[sector_of(x_m, y_m)];
  range2 = std::min(range2, x_m * x_m + y_m * y_m);
}

void RoadView::add_high(const Traces& traces, std::span<const float> height_m) {
  for (std::size_t i = 0; i < height_m.size(); ++i) {
    if (height_m[i] > kHigh_m) {
      add(traces.x[i], traces.y[i]);
    }
  }
}

bool RoadView::hides(float x_m, float y_m) const {
  const float range_m = std::sqrt(x_m * x_m + y_m * y_m);
  const float free_m = range_m - kViewMargin_m - kMarginShare * range_m;
  return free_m > 0.0F && range2_[sector_of(x_m, y_m)] < free_m * free_m;
}

}  // namespace berm
