#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace berm {

/// What one stage cost for one scan: time on the clock, and time that its thread worked.
struct StageTime {
  double wall_ms = 0.0;
  double cpu_ms = 0.0;
};

/// Measures from construction to `stop`, on one thread.
class StageClock {
 public:
  StageClock();
  [[nodiscard]] StageTime stop() const;

 private:
  double wall_start_ms_;
  double cpu_start_ms_;
};

/// What a stage cost over a whole run.
struct StageSummary {
  double cpu_mean_ms = 0.0;
  double mean_ms = 0.0;
  double p50_ms = 0.0;
  double p95_ms = 0.0;
  double p99_ms = 0.0;
  double max_ms = 0.0;
};

/// Gathers the times of one stage in bounded memory. Means and the maximum are exact; percentiles are exact up to
/// `kKept` scans, then taken over every 2nd, 4th, ... scan.
class StageTimes {
 public:
  static constexpr std::size_t kKept = 65536;

  void add(const StageTime& time);
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Zeros if nothing was added. Percentiles by nearest rank.
  [[nodiscard]] StageSummary summarize() const;

 private:
  std::uint64_t count_ = 0;
  std::uint64_t stride_ = 1;
  double cpu_sum_ms_ = 0.0;
  double wall_sum_ms_ = 0.0;
  double max_ms_ = 0.0;
  std::vector<double> kept_ms_;
};

}  // namespace berm
