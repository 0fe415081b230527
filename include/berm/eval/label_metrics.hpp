#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace berm {

/// How often a yes-or-no answer agreed with the truth. Counts of scans add up to those of a recording.
struct BinaryCounts {
  std::uint64_t true_positive = 0;
  std::uint64_t false_positive = 0;
  std::uint64_t false_negative = 0;
  std::uint64_t true_negative = 0;
  std::uint64_t left_out = 0;  ///< points whose truth says nothing about the question

  [[nodiscard]] std::uint64_t judged() const { return true_positive + false_positive + false_negative + true_negative; }
  BinaryCounts& operator+=(const BinaryCounts& other);
  friend bool operator==(const BinaryCounts&, const BinaryCounts&) = default;
};

/// Shares of 0..1; none where the divisor is 0.
struct BinaryMetrics {
  std::optional<double> precision;
  std::optional<double> recall;
  std::optional<double> f1;
  std::optional<double> iou;
  std::optional<double> accuracy;  ///< P eq. 13
};
[[nodiscard]] BinaryMetrics derive_metrics(const BinaryCounts& counts);

/// The questions below judge one point after the other by its SemanticKITTI class; instances (upper 16 bits) do not
/// matter. Both spans are raw labels as on disk. Throw Error(invalid_argument) if the spans differ in length.

/// Ground: 40, 44, 48, 49, 60, 72, 111. Left out where truth is 0, 1, 70 or 110.
[[nodiscard]] BinaryCounts judge_ground(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth);

/// Piste: 40. Left out where truth is 0 or 110.
[[nodiscard]] BinaryCounts judge_piste(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth);

/// Falling snow: 110. Left out where the beam did not return: `is_return` has one entry per point, 0 for none.
[[nodiscard]] BinaryCounts judge_snow(std::span<const std::uint32_t> output, std::span<const std::uint32_t> truth,
                                      std::span<const std::uint8_t> is_return);

}  // namespace berm
