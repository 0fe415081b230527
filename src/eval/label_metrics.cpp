#include "berm/eval/label_metrics.hpp"

#include <string>

#include "berm/core/error.hpp"
#include "berm/io/label_file.hpp"

namespace berm {
namespace {

constexpr std::uint32_t kFallingSnowId = 110;
constexpr std::uint32_t kDrivableId = 40;

bool is_ground(std::uint32_t id) {
  switch (id) {
    case 40:   // road
    case 44:   // parking
    case 48:   // sidewalk
    case 49:   // other ground
    case 60:   // lane marking
    case 72:   // terrain
    case 111:  // accumulated snow
      return true;
    default:
      return false;
  }
}

bool says_nothing_of_ground(std::uint32_t id) {
  return id == 0 || id == 1 || id == 70 || id == kFallingSnowId;
}

void check_length(std::size_t output, std::size_t truth) {
  if (output != truth) {
    throw Error(ErrorCode::invalid_argument,
                std::to_string(output) + " labels cannot be judged by " + std::to_string(truth) + " labels of truth");
  }
}

template <typename IsPositive, typename IsLeftOut>
BinaryCounts judge(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth, IsPositive is_positive,
                   IsLeftOut is_left_out) {
  check_length(output.size(), truth.size());
  BinaryCounts counts;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint32_t id = semantic_class(truth[i]);
    if (is_left_out(i, id)) {
      ++counts.left_out;
      continue;
    }
    const bool said = is_positive(semantic_class(output[i]));
    const bool is = is_positive(id);
    ++(is ? (said ? counts.true_positive : counts.false_negative)
          : (said ? counts.false_positive : counts.true_negative));
  }
  return counts;
}

std::optional<double> ratio(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) {
    return std::nullopt;
  }
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

BinaryCounts& BinaryCounts::operator+=(const BinaryCounts& other) {
  true_positive += other.true_positive;
  false_positive += other.false_positive;
  false_negative += other.false_negative;
  true_negative += other.true_negative;
  left_out += other.left_out;
  return *this;
}

BinaryMetrics derive_metrics(const BinaryCounts& counts) {
  const std::uint64_t hit = counts.true_positive;
  const std::uint64_t wrong = counts.false_positive + counts.false_negative;
  return {.precision = ratio(hit, hit + counts.false_positive),
          .recall = ratio(hit, hit + counts.false_negative),
          .f1 = ratio(2 * hit, 2 * hit + wrong),
          .iou = ratio(hit, hit + wrong),
          .accuracy = ratio(hit + counts.true_negative, counts.judged())};
}

BinaryCounts judge_ground(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth) {
  return judge(output, truth, is_ground, [](std::size_t, std::uint32_t id) { return says_nothing_of_ground(id); });
}

BinaryCounts judge_piste(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth) {
  return judge(
      output, truth, [](std::uint32_t id) { return id == kDrivableId; },
      [](std::size_t, std::uint32_t id) { return id == 0 || id == kFallingSnowId; });
}

BinaryCounts judge_snow(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth,
                        std::span<const std::uint8_t> is_return) {
  check_length(is_return.size(), truth.size());
  return judge(
      output, truth, [](std::uint32_t id) { return id == kFallingSnowId; },
      [is_return](std::size_t point, std::uint32_t) { return is_return[point] == 0; });
}

}  // namespace berm
