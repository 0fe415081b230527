#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/pcd.hpp"
#include "support/file_error.hpp"
#include "support/made_pcd.hpp"

namespace berm {
namespace {

using test::expect_file_error;
using test::MadePcd;

ScanRecord with_time(const std::string& name, char type, std::size_t size, std::vector<long double> values,
                     const std::string& encoding = "binary") {
  MadePcd pcd = test::made_xyz(values.size());
  pcd.fields.push_back({name, type, size, 1, std::move(values)});
  return parse_pcd(test::as_bytes(pcd.encoded(encoding)), "scan.pcd");
}

bool has_time_note(const ScanRecord& record, const std::string& part) {
  return std::any_of(record.notes.begin(), record.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

void expect_times(const ScanRecord& record, const std::vector<float>& expected) {
  ASSERT_EQ(record.channels.time.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_FLOAT_EQ(record.channels.time[i], expected[i]) << i;
  }
}

TEST(PcdTime, RelativeNamesOfDrivers) {
  for (const char* name : {"t", "offset_time"}) {
    const ScanRecord record = with_time(name, 'U', 4, {0, 50'000'000, 99'999'999});
    expect_times(record, {0.0F, 0.05F, 0.099999999F});
    EXPECT_FALSE(record.start_ns);
    EXPECT_TRUE(has_time_note(record, std::string("field ") + name + " (U4), taken as ns"));
  }
  expect_times(with_time("time_stamp", 'U', 4, {0, 50'000'000}), {0.0F, 0.05F});
  expect_times(with_time("time", 'F', 4, {0.0L, 0.05L}), {0.0F, 0.05F});
  expect_times(with_time("time", 'F', 8, {0.0L, 0.05L}), {0.0F, 0.05F});
  expect_times(with_time("time", 'F', 4, {-0.1L, 0.0L}), {-0.1F, 0.0F});
}

TEST(PcdTime, AbsoluteTimeIsCountedFromTheEarliestPoint) {
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    const ScanRecord seconds =
        with_time("timestamp", 'F', 8, {1635236489.5L, 1635236489.25L, 1635236489.75L}, encoding);
    EXPECT_EQ(seconds.start_ns, 1'635'236'489'250'000'000);
    expect_times(seconds, {0.25F, 0.0F, 0.5F});
    const ScanRecord whole = with_time(
        "timestamp", 'U', 8, {1635236489000000007.0L, 1635236489000000009.0L, 1635236489000001007.0L}, encoding);
    EXPECT_EQ(whole.start_ns, 1'635'236'489'000'000'007) << encoding;
    expect_times(whole, {0.0F, 2e-9F, 1e-6F});
  }
}

TEST(PcdTime, LivoxWritesNanosecondsAsDouble) {
  const ScanRecord record = with_time("timestamp", 'F', 8, {1.6352364892e18L, 1.6352364893e18L});
  EXPECT_EQ(record.start_ns, 1'635'236'489'200'000'000);
  expect_times(record, {0.0F, 0.1F});
  EXPECT_TRUE(has_time_note(record, "taken as ns"));
  // Microseconds are neither.
  const ScanRecord neither = with_time("timestamp", 'F', 8, {1.6352364892e15L, 1.6352364892001e15L});
  EXPECT_TRUE(neither.channels.time.empty());
  EXPECT_TRUE(has_time_note(neither, "no point carries a usable time"));
}

TEST(PcdTime, AbsoluteTimeWinsOverRelative) {
  MadePcd pcd = test::made_xyz(2);
  pcd.fields.push_back({"time", 'F', 4, 1, {0.5L, 0.75L}});
  pcd.fields.push_back({"timestamp", 'F', 8, 1, {1000.0L, 1000.125L}});
  const ScanRecord record = parse_pcd(test::as_bytes(pcd.binary()), "scan.pcd");
  EXPECT_EQ(record.start_ns, 1'000'000'000'000);
  expect_times(record, {0.0F, 0.125F});
}

TEST(PcdTime, SpanBeyondASecondIsRefused) {
  const auto refused = [](const std::string& name, char type, std::size_t size, std::vector<long double> values,
                          const std::string& part) {
    SCOPED_TRACE(name);
    expect_file_error(ErrorCode::unsupported, part, [&] { (void)with_time(name, type, size, values); });
  };
  refused("timestamp", 'F', 8, {1000.0L, 1001.5L}, "span 1.5 s");
  refused("timestamp", 'I', 8, {-9223372036854775807.0L, 9223372036854775807.0L}, "span 1.84467e+10 s");
  refused("t", 'U', 4, {0, 1'500'000'000}, "from 0 to 1.5 s");
  refused("time", 'F', 4, {0.0L, 100.0L}, "from 0 to 100 s");    // ms
  refused("time", 'F', 8, {1.6e9L, 1.6e9L}, "from 1.6e+09 to");  // absolute under the name of relative
  refused("time", 'F', 4, {-5.0L, -5.0L}, "from -5 to -5 s");
  refused("time", 'F', 4, {-0.75L, 0.75L}, "from -0.75 to 0.75 s");
}

TEST(PcdTime, UnitThatNobodyAgreedOnIsLeftOut) {
  for (const auto& [name, type] :
       {std::pair("time", 'U'), std::pair("timestamp", 'U'), std::pair("offset_time", 'F')}) {
    const ScanRecord record = with_time(name, type, 4, {0, 1});
    EXPECT_TRUE(record.channels.time.empty());
    EXPECT_TRUE(has_time_note(record, std::string("field ") + name)) << name;
    EXPECT_TRUE(has_time_note(record, "its unit is not known")) << name;
  }
}

TEST(PcdTime, BackwardsIsKeptAndNoted) {
  const ScanRecord record = with_time("time", 'F', 4, {0.0L, 0.5L, 0.25L, 0.75L, 0.5L});
  expect_times(record, {0.0F, 0.5F, 0.25F, 0.75F, 0.5F});
  EXPECT_TRUE(has_time_note(record, "run backwards at 2 points"));
  EXPECT_FALSE(has_time_note(with_time("time", 'F', 4, {0.0L, 0.0L, 0.25L}), "backwards"));
}

TEST(PcdTime, PointsWithoutTimeAreNan) {
  const long double nan = std::numeric_limits<long double>::quiet_NaN();
  const long double inf = std::numeric_limits<long double>::infinity();
  const ScanRecord relative = with_time("time", 'F', 4, {0.0L, nan, inf, 0.5L});
  EXPECT_TRUE(std::isnan(relative.channels.time.at(1)));
  EXPECT_TRUE(std::isnan(relative.channels.time.at(2)));
  EXPECT_FLOAT_EQ(relative.channels.time.at(3), 0.5F);
  EXPECT_TRUE(has_time_note(relative, "2 points carry no usable time"));
  // A beam without a return that was filled with zeros.
  const ScanRecord absolute = with_time("timestamp", 'F', 8, {1.6e9L, 0.0L, nan, 1.6e9L + 0.5L});
  EXPECT_EQ(absolute.start_ns, 1'600'000'000'000'000'000);
  EXPECT_FLOAT_EQ(absolute.channels.time.at(0), 0.0F);
  EXPECT_TRUE(std::isnan(absolute.channels.time.at(1)));
  EXPECT_TRUE(std::isnan(absolute.channels.time.at(2)));
  EXPECT_FLOAT_EQ(absolute.channels.time.at(3), 0.5F);
  // A clock that starts with the sensor: zero is a time like any other.
  const ScanRecord booted = with_time("timestamp", 'U', 8, {0, 500'000'000});
  EXPECT_EQ(booted.start_ns, 0);
  expect_times(booted, {0.0F, 0.5F});
  EXPECT_TRUE(with_time("time", 'F', 4, {nan, nan}).channels.time.empty());
}

}  // namespace
}  // namespace berm
