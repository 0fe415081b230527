#include "void_view.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"

namespace berm {
namespace {

constexpr float kMinDrop_m = 0.6F;

/// Rings on level road, walked clockwise.
struct Rings {
  Traces traces;
  std::vector<float> height_m;

  void add(double range_m, double from_deg, double to_deg, float height = 0.0F) {
    for (double deg = from_deg; deg >= to_deg; deg -= 0.2) {
      traces.x.push_back(static_cast<float>(range_m * std::cos(deg * kRadPerDeg)));
      traces.y.push_back(static_cast<float>(range_m * std::sin(deg * kRadPerDeg)));
      height_m.push_back(height);
    }
  }
};

/// Whether the ring of 15 m, which is the first and ends at -20 degrees, ends at nothing.
bool ends(const Rings& rings) {
  VoidView view;
  view.process(rings.traces, rings.height_m, kMinDrop_m);
  std::size_t end = 0;
  while (std::hypot(rings.traces.x[end + 1], rings.traces.y[end + 1]) > 14.9F) {
    ++end;
  }
  return view.ends_at(rings.traces, end - 8, end);
}

/// Of a road whose right edge is a lip: nearer rings reach farther around.
Rings beside_a_lip() {
  Rings rings;
  rings.add(15.0, 20.0, -20.0);
  rings.add(12.0, 20.0, -27.0);
  return rings;
}

TEST(VoidView, BeginsWhereOnlyNearerRingsGoOn) {
  EXPECT_TRUE(ends(beside_a_lip()));
}

TEST(VoidView, GroundFarBelowIsNotThere) {
  Rings rings = beside_a_lip();
  rings.add(40.0, -20.0, -60.0, -8.0F);
  EXPECT_TRUE(ends(rings));
}

TEST(VoidView, EndsWhereSomethingIsSeenBehind) {
  Rings puddle = beside_a_lip();
  puddle.add(20.0, 20.0, -60.0);
  EXPECT_FALSE(ends(puddle));
  Rings itself = beside_a_lip();
  itself.add(14.99, -26.0, -60.0);
  EXPECT_FALSE(ends(itself));
}

TEST(VoidView, AShadowIsNone) {
  Rings rings = beside_a_lip();
  rings.add(9.0, -20.0, -40.0, 1.5F);
  EXPECT_FALSE(ends(rings));
}

TEST(VoidView, TheEndOfTheFieldOfViewIsNone) {
  Rings rings;
  rings.add(15.0, 20.0, -20.0);
  rings.add(12.0, 20.0, -20.0);
  EXPECT_FALSE(ends(rings));
}

TEST(VoidView, OutwardTracesEndForOtherReasons) {
  Rings rings = beside_a_lip();
  VoidView view;
  view.process(rings.traces, rings.height_m, kMinDrop_m);
  const std::size_t end = 200;
  Traces outward = rings.traces;
  outward.x[end - 8] = 0.95F * outward.x[end];
  outward.y[end - 8] = 0.95F * outward.y[end];
  EXPECT_FALSE(view.ends_at(outward, end - 8, end));
}

}  // namespace
}  // namespace berm
