#include "berm/io/datum.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

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

TEST(WorldName, BringsTheDatumBackToTheLastBit) {
  EXPECT_EQ(world_name(std::nullopt), "");
  EXPECT_EQ(world_name(Geodetic{-23.5, 148.25, 310.0}), "WGS84 lat -23.5 lon 148.25 h 310");
  EXPECT_EQ(world_name(Geodetic{-0.0, 0.0, -0.0}), "WGS84 lat 0 lon 0 h 0");
  EXPECT_TRUE(rc::check("any place", [] {
    const auto between = [](double least, double most) {
      const double share = static_cast<double>(*rc::gen::arbitrary<std::uint64_t>() >> 11U) * 0x1p-53;
      return least + share * (most - least);
    };
    const Geodetic datum{between(-90.0, 90.0), between(-360.0, 360.0), between(-1e5, 1e5) * between(0.0, 1e-3)};
    const std::string name = world_name(datum);
    RC_ASSERT(name.size() <= 200U);
    RC_ASSERT(name.find_first_of("\n\r") == std::string::npos);
    const auto again = datum_of(name);
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->lat_deg == datum.lat_deg);
    RC_ASSERT(again->lon_deg == datum.lon_deg);
    RC_ASSERT(again->h_m == datum.h_m);
  }));
}

TEST(WorldName, OfAnotherKindHasNoDatum) {
  for (const char* name :
       {"", "EPSG:32750", "WGS84", "WGS84 lat 1 lon 2", "WGS84 lat 1 lon 2 h", "WGS84 lon 1 lat 2 h 3",
        "WGS84 lat 91 lon 2 h 3", "WGS84 lat nan lon 2 h 3", "WGS84 lat 1 lon 2 h 3 4"}) {
    EXPECT_FALSE(datum_of(name)) << name;
  }
  EXPECT_THROW((void)world_name(Geodetic{91.0, 0.0, 0.0}), Error);
}

}  // namespace
}  // namespace berm
