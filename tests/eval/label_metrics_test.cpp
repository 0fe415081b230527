#include "berm/eval/label_metrics.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

using Labels = std::vector<std::uint32_t>;

TEST(LabelMetrics, GroundByHand) {
  //                    road  parking sidewalk other lane terrain snow  building
  const Labels truth = {40, 44, 48, 49, 60, 72, 111, 50, 10, 99, 0, 1, 70, 110};
  const Labels output = {40, 40, 72, 99, 0, 40, 40, 40, 99, 0, 40, 99, 40, 99};
  const BinaryCounts counts = judge_ground(output, truth);
  EXPECT_EQ(counts, (BinaryCounts{5, 1, 2, 2, 4}));
  const BinaryMetrics metrics = derive_metrics(counts);
  EXPECT_DOUBLE_EQ(*metrics.precision, 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(*metrics.recall, 5.0 / 7.0);
  EXPECT_DOUBLE_EQ(*metrics.f1, 10.0 / 13.0);
  EXPECT_DOUBLE_EQ(*metrics.iou, 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(*metrics.accuracy, 7.0 / 10.0);
}

TEST(LabelMetrics, InstancesDoNotMatter) {
  const Labels truth = {40U | (7U << 16U), 10U | (65535U << 16U), 0U | (3U << 16U)};
  const Labels output = {72U | (1U << 16U), 99U, 40U};
  EXPECT_EQ(judge_ground(output, truth), (BinaryCounts{1, 0, 0, 1, 1}));
}

TEST(LabelMetrics, PisteByHand) {
  const Labels truth = {40, 40, 72, 70, 50, 0, 110, 40};
  const Labels output = {40, 72, 40, 99, 99, 40, 40, 0};
  const BinaryCounts counts = judge_piste(output, truth);
  EXPECT_EQ(counts, (BinaryCounts{1, 1, 2, 2, 2}));
  EXPECT_DOUBLE_EQ(*derive_metrics(counts).accuracy, 0.5);
}

TEST(LabelMetrics, SnowIsJudgedOverReturnsAlone) {
  const Labels truth = {110, 110, 40, 0, 0, 110};
  const Labels output = {110, 40, 110, 0, 110, 110};
  const std::array<std::uint8_t, 6> is_return = {1, 1, 1, 1, 1, 0};
  EXPECT_EQ(judge_snow(output, truth, is_return), (BinaryCounts{1, 2, 1, 1, 1}));
}

TEST(LabelMetrics, NothingToDivideByGivesNoFigure) {
  const BinaryMetrics none = derive_metrics({});
  EXPECT_FALSE(none.precision || none.recall || none.f1 || none.iou || none.accuracy);
  const BinaryMetrics silent = derive_metrics({.false_negative = 3});
  EXPECT_FALSE(silent.precision.has_value());
  EXPECT_EQ(silent.recall, 0.0);
  EXPECT_EQ(silent.f1, 0.0);
}

TEST(LabelMetrics, LengthsMustAgree) {
  const Labels two = {40, 40};
  const Labels three = {40, 40, 40};
  const std::array<std::uint8_t, 2> is_return = {1, 1};
  EXPECT_THROW(static_cast<void>(judge_ground(two, three)), Error);
  EXPECT_THROW(static_cast<void>(judge_piste(three, two)), Error);
  EXPECT_THROW(static_cast<void>(judge_snow(three, three, is_return)), Error);
}

rc::Gen<std::vector<std::pair<std::uint32_t, std::uint32_t>>> any_points() {
  const auto id = rc::gen::element<std::uint32_t>(0, 1, 10, 40, 44, 48, 49, 50, 60, 70, 72, 99, 110, 111);
  return rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint32_t>>>(rc::gen::pair(id, id));
}

std::pair<Labels, Labels> split(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& points) {
  std::pair<Labels, Labels> labels;
  for (const auto& [output, truth] : points) {
    labels.first.push_back(output);
    labels.second.push_back(truth);
  }
  return labels;
}

TEST(LabelMetricsLaws, OrderOfPointsDoesNotMatter) {
  EXPECT_TRUE(rc::check([] {
    auto points = *any_points();
    const auto [output, truth] = split(points);
    const auto rotation = *rc::gen::inRange<std::size_t>(0, points.size() + 1);
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(rotation), points.end());
    std::reverse(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2));
    const auto [other_output, other_truth] = split(points);
    RC_ASSERT(judge_ground(output, truth) == judge_ground(other_output, other_truth));
    RC_ASSERT(judge_piste(output, truth) == judge_piste(other_output, other_truth));
  }));
}

TEST(LabelMetricsLaws, CountsOfPartsAddUpToTheWhole) {
  EXPECT_TRUE(rc::check([] {
    const auto points = *any_points();
    const auto [output, truth] = split(points);
    const auto cut = *rc::gen::inRange<std::size_t>(0, points.size() + 1);
    const std::span<const std::uint32_t> all_output(output);
    const std::span<const std::uint32_t> all_truth(truth);
    BinaryCounts sum = judge_ground(all_output.first(cut), all_truth.first(cut));
    sum += judge_ground(all_output.subspan(cut), all_truth.subspan(cut));
    RC_ASSERT(sum == judge_ground(output, truth));
    RC_ASSERT(sum.judged() + sum.left_out == points.size());
  }));
}

TEST(LabelMetricsLaws, F1LiesBetweenIouAndOneAndBetweenPrecisionAndRecall) {
  EXPECT_TRUE(rc::check([] {
    const auto count = rc::gen::inRange<std::uint64_t>(0, 1000);
    const BinaryCounts counts{1 + *count, *count, *count, *count, *count};
    const BinaryMetrics metrics = derive_metrics(counts);
    const auto [low, high] = std::minmax(*metrics.precision, *metrics.recall);
    constexpr double kRounding = 1e-12;
    RC_ASSERT(*metrics.f1 >= low - kRounding && *metrics.f1 <= high + kRounding);
    RC_ASSERT(*metrics.iou <= *metrics.f1 && *metrics.f1 <= 1.0);
    RC_ASSERT(*metrics.accuracy >= 0.0 && *metrics.accuracy <= 1.0);
  }));
}

TEST(LabelMetricsLaws, TruthJudgedByItselfIsPerfect) {
  EXPECT_TRUE(rc::check([] {
    const auto [unused, truth] = split(*any_points());
    const BinaryCounts counts = judge_ground(truth, truth);
    RC_ASSERT(counts.false_positive == 0U && counts.false_negative == 0U);
  }));
}

}  // namespace
}  // namespace berm
