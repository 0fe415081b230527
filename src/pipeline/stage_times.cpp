#include "stage_times.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace berm {
namespace {

double now_ms(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double percentile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace

StageClock::StageClock() : wall_start_ms_(now_ms(CLOCK_MONOTONIC)), cpu_start_ms_(now_ms(CLOCK_THREAD_CPUTIME_ID)) {}

StageTime StageClock::stop() const {
  return {now_ms(CLOCK_MONOTONIC) - wall_start_ms_, now_ms(CLOCK_THREAD_CPUTIME_ID) - cpu_start_ms_};
}

void StageTimes::add(const StageTime& time) {
  cpu_sum_ms_ += time.cpu_ms;
  wall_sum_ms_ += time.wall_ms;
  max_ms_ = std::max(max_ms_, time.wall_ms);
  if (count_++ % stride_ != 0) {
    return;
  }
  if (kept_ms_.size() == kKept) {
    for (std::size_t i = 0; i < kKept / 2; ++i) {
      kept_ms_[i] = kept_ms_[2 * i];
    }
    kept_ms_.resize(kKept / 2);
    stride_ *= 2;
  }
  kept_ms_.push_back(time.wall_ms);
}

StageSummary StageTimes::summarize() const {
  if (count_ == 0) {
    return {};
  }
  std::vector<double> sorted = kept_ms_;
  std::sort(sorted.begin(), sorted.end());
  return {.cpu_mean_ms = cpu_sum_ms_ / static_cast<double>(count_),
          .mean_ms = wall_sum_ms_ / static_cast<double>(count_),
          .p50_ms = percentile(sorted, 0.50),
          .p95_ms = percentile(sorted, 0.95),
          .p99_ms = percentile(sorted, 0.99),
          .max_ms = max_ms_};
}

}  // namespace berm
