#include "thinned_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "log_histogram.hpp"

namespace berm {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(ThinnedSeries, KeepsAShortSeriesAsItIs) {
  ThinnedSeries thinned({Thinning::extremes, Thinning::total});
  for (int i = 0; i < 2000; ++i) {
    const double values[] = {i % 3 == 0 ? kNone : std::sin(i), 2.0 * i};
    thinned.add(0.1 * i, values);
  }
  const Series series = thinned.take();
  EXPECT_EQ(series.rows_per_value, 1U);
  ASSERT_EQ(series.x.size(), 2000U);
  EXPECT_TRUE(std::isnan(series.columns[0][3]));
  EXPECT_EQ(series.columns[0][1999], std::sin(1999));
  EXPECT_EQ(series.columns[1][1999], 3998.0);
}

TEST(ThinnedSeries, ASpikeOfOneRowStaysASpike) {
  ThinnedSeries thinned({Thinning::extremes, Thinning::worst});
  for (int i = 0; i < 360'000; ++i) {  // ten hours at 10 Hz
    const double values[] = {i == 123'457 ? 99.0 : 1.0, i == 5 ? 3.0 : 0.0};
    thinned.add(i, values);
  }
  const Series series = thinned.take();
  EXPECT_LE(series.x.size(), ThinnedSeries::kValues);
  EXPECT_GE(series.x.size(), ThinnedSeries::kValues / 2);
  EXPECT_EQ(series.rows, 360'000U);
  const auto spike = std::max_element(series.columns[0].begin(), series.columns[0].end());
  EXPECT_EQ(*spike, 99.0);
  const double at = series.x[static_cast<std::size_t>(spike - series.columns[0].begin())];
  EXPECT_NEAR(at, 123'457.0, static_cast<double>(series.rows_per_value));
  EXPECT_EQ(series.columns[1][0], 3.0);
  EXPECT_EQ(series.columns[1][1], 3.0);
}

TEST(ThinnedSeries, TheOrderOfTheExtremesStays) {
  ThinnedSeries thinned({Thinning::extremes});
  for (int i = 0; i < 4096; ++i) {
    const double values[] = {-1.0 * i};
    thinned.add(i, values);
  }
  const Series series = thinned.take();
  EXPECT_TRUE(std::is_sorted(series.columns[0].rbegin(), series.columns[0].rend())) << "a falling line goes on falling";
  EXPECT_TRUE(std::is_sorted(series.x.begin(), series.x.end()));
}

TEST(ThinnedSeries, NothingIsLostOrInvented) {
  EXPECT_TRUE(rc::check("extremes and totals of all rows are those of the result", [] {
    const auto count = *rc::gen::inRange<std::size_t>(1, 20'000);
    const auto seed = *rc::gen::inRange(1, 1000);
    ThinnedSeries thinned({Thinning::extremes, Thinning::total});
    double low = 1e9;
    double high = -1e9;
    double total = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double value = static_cast<double>((i * 7919U + static_cast<std::size_t>(seed)) % 1000U);
      const double values[] = {value, value};
      thinned.add(static_cast<double>(i), values);
      low = std::min(low, value);
      high = std::max(high, value);
      total += value;
    }
    const Series series = thinned.take();
    RC_ASSERT(series.x.size() <= ThinnedSeries::kValues);
    RC_ASSERT(*std::min_element(series.columns[0].begin(), series.columns[0].end()) == low);
    RC_ASSERT(*std::max_element(series.columns[0].begin(), series.columns[0].end()) == high);
    double sum = 0.0;
    const std::size_t step = series.rows_per_value > 1 ? 2 : 1;
    for (std::size_t i = 0; i < series.x.size(); i += step) {
      sum += series.columns[1][i];
    }
    RC_ASSERT(sum == total);
  }));
}

TEST(ThinnedSeries, UnknownValuesStayUnknown) {
  ThinnedSeries thinned({Thinning::extremes, Thinning::total, Thinning::worst});
  for (int i = 0; i < 5000; ++i) {
    const double values[] = {kNone, kNone, kNone};
    thinned.add(i, values);
  }
  for (const std::vector<double>& column : thinned.take().columns) {
    EXPECT_TRUE(std::all_of(column.begin(), column.end(), [](double value) { return std::isnan(value); }));
  }
  EXPECT_TRUE(ThinnedSeries({Thinning::extremes}).take().x.empty());
}

TEST(LogHistogram, CountsEveryNumberOnce) {
  LogHistogram histogram;
  for (const double value : {0.0, 1e-9, 0.00101, 1.05, 1.2, 1e300, kNone}) {
    histogram.add(value);
  }
  EXPECT_EQ(histogram.count(), 6U);
  EXPECT_EQ(histogram.bins().front(), 3U);
  EXPECT_EQ(histogram.bins()[30], 2U) << "1 .. 1.26";
  EXPECT_EQ(histogram.bins().back(), 1U);
}

}  // namespace
}  // namespace berm
