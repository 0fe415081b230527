#include "berm/core/config.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

struct MadeConfig {
  double length_m = 1.0;
  int count = 3;
  bool on = true;
  std::string method = "default";
  std::string name = "car";

  static void fields(auto&& field) {
    field("length_m", &MadeConfig::length_m, Range{0.5, 200.0}, "a length");
    field("count", &MadeConfig::count, Range{1, 10}, "a number of things");
    field("on", &MadeConfig::on, "a switch");
    field("method", &MadeConfig::method, Choices{{"default", "reference", "none"}}, "a choice");
    field("name", &MadeConfig::name, TextLimit{8}, "a text");
  }
  void check() const { check_fields(*this, "made"); }
};

/// The message of the ConfigError that `config` causes; empty if none.
std::string complaint(const MadeConfig& config) {
  try {
    config.check();
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.code(), ErrorCode::config);
    return error.what();
  }
  return {};
}

TEST(Config, AllowsDefaultsAndBothEnds) {
  EXPECT_EQ(complaint({}), "");
  EXPECT_EQ(complaint({.length_m = 0.5, .count = 1}), "");
  EXPECT_EQ(complaint({.length_m = 200.0, .count = 10, .on = false}), "");
}

TEST(Config, RefusesWhatIsJustOutside) {
  const double above = std::nextafter(200.0, 300.0);
  const double below = std::nextafter(0.5, 0.0);
  EXPECT_NE(complaint({.length_m = above}), "");
  EXPECT_NE(complaint({.length_m = below}), "");
  EXPECT_NE(complaint({.count = 0}), "");
  EXPECT_NE(complaint({.count = 11}), "");
}

TEST(Config, SaysKeyValueAndRange) {
  EXPECT_EQ(complaint({.length_m = 0.25}), "made.length_m: 0.25 is not allowed, expected 0.5 to 200");
  EXPECT_EQ(complaint({.count = -4}), "made.count: -4 is not allowed, expected 1 to 10");
}

TEST(Config, NeverPrintsAnEndOfTheRangeForAValueOutside) {
  EXPECT_NE(complaint({.length_m = std::nextafter(200.0, 300.0)}).find("200.00000000000003"), std::string::npos);
}

TEST(Config, RefusesWhatIsNoNumber) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(complaint({.length_m = value}), "") << value;
    EXPECT_NE(find_problem(value, Range{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}), "");
  }
}

TEST(Config, TakesOnlyTheNamedChoices) {
  EXPECT_EQ(complaint({.method = "none"}), "");
  EXPECT_EQ(complaint({.method = "Default"}),
            "made.method: 'Default' is not allowed, expected default, reference or none");
  EXPECT_NE(complaint({.method = ""}), "");
}

TEST(Config, LimitsText) {
  EXPECT_EQ(complaint({.name = "12345678"}), "");
  EXPECT_EQ(complaint({.name = ""}), "");
  EXPECT_NE(complaint({.name = "123456789"}), "");
  EXPECT_NE(complaint({.name = "a\nb"}), "");
  EXPECT_NE(complaint({.name = std::string("a\0b", 3)}), "");
  EXPECT_EQ(complaint({.name = "h\xc3\xb6he"}), "") << "letters beyond ASCII are text";
}

}  // namespace
}  // namespace berm
