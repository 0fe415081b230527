#include "trace_profile.hpp"

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

}  // namespace berm
