#include "trace_profile.hpp"

#include <algorithm>
#include <cmath>

namespace berm {

void TraceProfile::clear() {
  index.clear();
  s_m.clear();
  h_m.clear();
  sums_.assign(1, Sums{});
}

void TraceProfile::add(std::uint32_t at, float s, float h) {
  index.push_back(at);
  s_m.push_back(s);
  h_m.push_back(h);
  const Sums& before = sums_.back();
  const double ds = double{s};
  const double dh = double{h};
  sums_.push_back({before.s + ds, before.h + dh, before.ss + ds * ds, before.sh + ds * dh, before.hh + dh * dh});
}

TraceProfile::Line TraceProfile::fit(std::size_t first, std::size_t last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  const auto n = static_cast<double>(last + 1 - first);
  const double s = (b.s - a.s) / n;
  const double h = (b.h - a.h) / n;
  const double ss = (b.ss - a.ss) / n - s * s;
  const double sh = (b.sh - a.sh) / n - s * h;
  const double hh = (b.hh - a.hh) / n - h * h;
  const double slope = ss > 1e-6 ? sh / ss : 0.0;
  return {.s0_m = static_cast<float>(s),
          .height_m = static_cast<float>(h),
          .slope = static_cast<float>(slope),
          .rms_m = static_cast<float>(std::sqrt(std::max(hh - slope * sh, 0.0)))};
}

}  // namespace berm
