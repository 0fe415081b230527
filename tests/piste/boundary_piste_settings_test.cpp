// Whatever the settings, within their ranges: no crash, the contract on labels, numbers that are numbers.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/piste/boundary_piste.hpp"
#include "piste/boundary_scene.hpp"
#include "piste/mid70_scan.hpp"

namespace berm {
namespace {

using test::PisteScan;

/// Sets every field to an end of its range, or to something within, by the dice.
struct Setter {
  BoundaryPisteConfig& config;
  std::mt19937& random;

  template <typename Value>
  void operator()(std::string_view /*key*/, Value BoundaryPisteConfig::*member, const Range& range,
                  std::string_view /*text*/) const {
    const double share = static_cast<double>(random()) * 0x1p-32;
    switch (random() % 4) {
      case 0:
        config.*member = static_cast<Value>(range.min);
        break;
      case 1:
        config.*member = static_cast<Value>(range.max);
        break;
      case 2:
        config.*member = static_cast<Value>(range.min + share * (range.max - range.min));
        break;
      default:
        break;  // as it is by default
    }
  }
  void operator()(std::string_view /*key*/, bool BoundaryPisteConfig::*member, std::string_view /*text*/) const {
    config.*member = random() % 2 == 0;
  }
};

/// Sets one numeric field alone to an end of its range.
struct OneSetter {
  BoundaryPisteConfig& config;
  std::string_view wanted;
  bool to_max;

  template <typename Value>
  void operator()(std::string_view key, Value BoundaryPisteConfig::*member, const Range& range,
                  std::string_view /*text*/) const {
    if (key == wanted) {
      config.*member = static_cast<Value>(to_max ? range.max : range.min);
    }
  }
  void operator()(std::string_view /*key*/, bool BoundaryPisteConfig::* /*member*/, std::string_view /*text*/) const {}
};

struct KeyCollector {
  std::vector<std::string>& keys;

  template <typename Value>
  void operator()(std::string_view key, Value BoundaryPisteConfig::* /*member*/, const Range& /*range*/,
                  std::string_view /*text*/) const {
    keys.emplace_back(key);
  }
  void operator()(std::string_view /*key*/, bool BoundaryPisteConfig::* /*member*/, std::string_view /*text*/) const {}
};

/// A rosette, rings, and points in no order, with obstacles among the ground.
const std::vector<PisteScan>& scans() {
  static const std::vector<PisteScan> all = [] {
    const test::StraightPiste piste{.middle_y_m = 1.0};
    std::vector<PisteScan> made;
    made.push_back(test::look_at(piste, test::mid70_beams(0, 4000), test::groomer_mount()));
    made.push_back(test::look_at(piste, test::spinning_beams(16, -35.0, 5.0, 200), test::groomer_mount()));
    made.push_back(test::shuffled(made.front(), 1));
    for (PisteScan& scan : made) {
      for (std::size_t i = 0; i < scan.labels.size(); i += 29) {
        scan.labels[i] = scan.labels[i] == Label::drivable ? Label::obstacle : scan.labels[i];
      }
    }
    return made;
  }();
  return all;
}

/// What is wrong with a result; empty if nothing is.
std::string find_fault(const PisteInput& input, const PisteResult& result) {
  if (result.labels.size() != input.labels.size()) {
    return "not a label for each point";
  }
  for (std::size_t i = 0; i < input.labels.size(); ++i) {
    const bool split = input.labels[i] == Label::drivable && result.labels[i] == Label::terrain;
    if (result.labels[i] != input.labels[i] && !split) {
      return "a label changed that must not";
    }
  }
  for (const auto side : {result.left, result.right}) {
    for (const BoundaryPoint& point : side) {
      if (!std::isfinite(point.x_m) || !std::isfinite(point.y_m) || !std::isfinite(point.z_m) ||
          !(point.confidence >= 0.0F && point.confidence <= 1.0F)) {
        return "a boundary that is no number";
      }
    }
  }
  if (result.slope && !(std::isfinite(result.slope->slope_rad) && std::isfinite(result.slope->slope_sigma_rad) &&
                        std::isfinite(result.slope->cross_fall_rad.value_or(0.0)))) {
    return "a slope that is no number";
  }
  if (result.obstacle_ahead_m && !(*result.obstacle_ahead_m >= 0.0 && *result.obstacle_ahead_m <= 500.0)) {
    return "an obstacle nowhere";
  }
  return {};
}

TEST(BoundaryPisteSettings, MayBeAnythingWithinTheirRanges) {
  EXPECT_TRUE(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    BoundaryPisteConfig config;
    BoundaryPisteConfig::fields(Setter{config, random});
    BoundaryPiste piste(config);
    for (const PisteScan& scan : scans()) {
      const std::string fault = find_fault(scan.input(), piste.process(scan.input()));
      RC_ASSERT(fault == std::string());
    }
  }));
}

TEST(BoundaryPisteSettings, MayEachBeAtAnEndOfItsRange) {
  std::vector<std::string> keys;
  BoundaryPisteConfig::fields(KeyCollector{keys});
  ASSERT_GT(keys.size(), 5U);
  for (const std::string& key : keys) {
    for (const bool to_max : {false, true}) {
      BoundaryPisteConfig config;
      BoundaryPisteConfig::fields(OneSetter{config, key, to_max});
      BoundaryPiste piste(config);
      for (const PisteScan& scan : scans()) {
        EXPECT_EQ(find_fault(scan.input(), piste.process(scan.input())), "") << key << (to_max ? " max" : " min");
      }
    }
  }
}

}  // namespace
}  // namespace berm
