#include "berm/io/datum.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

TEST(LocalFrame, ThereAndBackIsTheSame) {
  EXPECT_TRUE(rc::check("within 100 km, poles and the date line too", [] {
    const Geodetic datum{*rc::gen::inRange(-9000, 9001) / 100.0, *rc::gen::inRange(-18000, 18001) / 100.0,
                         *rc::gen::inRange(-400, 5000) / 1.0};
    const LocalFrame frame(datum);
    const Eigen::Vector3d local_m(*rc::gen::inRange(-60'000'000, 60'000'000) / 1000.0,
                                  *rc::gen::inRange(-60'000'000, 60'000'000) / 1000.0,
                                  *rc::gen::inRange(-500'000, 500'000) / 1000.0);
    const Geodetic place = frame.to_geodetic(local_m);
    RC_ASSERT(std::abs(place.lon_deg) <= 180.0);
    RC_ASSERT((frame.to_local_m(place) - local_m).norm() < 1e-6);
    RC_ASSERT(frame.to_local_m(datum).norm() < 1e-8);
  }));
}

TEST(LocalFrame, RefusesWhatIsNoPlace) {
  for (const Geodetic& place : {Geodetic{91.0, 0.0, 0.0}, Geodetic{0.0, 361.0, 0.0}, Geodetic{0.0, 0.0, 2e5},
                                Geodetic{std::nan(""), 0.0, 0.0}, Geodetic{0.0, HUGE_VAL, 0.0}}) {
    EXPECT_THROW(LocalFrame{place}, Error);
  }
}

TEST(DatumConfig, IsGivenOrNot) {
  DatumConfig config;
  config.lat_deg = 48.0;
  EXPECT_FALSE(config.given());
  config.origin = "given";
  EXPECT_EQ(config.given()->lat_deg, 48.0);
  config.lat_deg = 90.5;
  EXPECT_THROW(config.check(), ConfigError);
}

}  // namespace
}  // namespace berm
