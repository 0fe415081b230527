#include "pcd_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/core/stamp.hpp"

namespace berm {
namespace {

constexpr double kMaxSpan_s = 1.0;
constexpr std::int64_t kMaxSpan_ns = 1'000'000'000;
constexpr double kMaxSeconds = 9.2e9;          ///< what `from_seconds` takes
constexpr double kMinTodayNanoseconds = 1e17;  ///< 1973
constexpr double kMaxNanoseconds = 9.2e18;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw FileError(ErrorCode::unsupported, name, std::nullopt,
                  what +
                      ", expected at most 1 s for a scan; correct its unit, or rename the field so that it is left "
                      "out (docs/formats.md lists names and units)");
}

void note_times(ScanRecord& record) {
  std::vector<float>& time = record.channels.time;
  std::size_t known = 0;
  std::size_t backwards = 0;
  float first = std::numeric_limits<float>::infinity();
  float last = -first;
  float previous = last;
  for (const float value : time) {
    if (std::isnan(value)) {
      continue;
    }
    ++known;
    backwards += value < previous ? 1U : 0U;
    previous = value;
    first = std::min(first, value);
    last = std::max(last, value);
  }
  if (known == 0) {
    if (!time.empty()) {
      record.notes.emplace_back("no point carries a usable time, the field was left out");
    }
    time.clear();
    return;
  }
  record.notes.push_back(fmt::format("times of points reach from {:.6f} to {:.6f} s", first, last));
  if (known < time.size()) {
    record.notes.push_back(fmt::format("{} points carry no usable time", time.size() - known));
  }
  if (backwards > 0) {
    record.notes.push_back(fmt::format("times run backwards at {} points, order and times were kept", backwards));
  }
}

}  // namespace

std::int64_t stamp_from_seconds(double seconds, bool& were_ns) {
  if (std::abs(seconds) <= kMaxSeconds) {
    return from_seconds(seconds);
  }
  if (seconds >= kMinTodayNanoseconds && seconds <= kMaxNanoseconds) {
    were_ns = true;
    return static_cast<std::int64_t>(seconds);
  }
  return kNoStamp;
}

void set_absolute_time(ScanRecord& record, std::span<const std::int64_t> stamps_ns, const std::string& name) {
  std::optional<std::int64_t> first;
  std::optional<std::int64_t> last;
  bool zeros = false;
  for (const std::int64_t stamp : stamps_ns) {
    zeros |= stamp == 0;
    if (stamp != kNoStamp && stamp != 0) {
      first = std::min(first.value_or(stamp), stamp);
      last = std::max(last.value_or(stamp), stamp);
    }
  }
  const bool zero_is_unset = first && *first > kMaxSpan_ns;
  if (zeros && !zero_is_unset) {
    first = std::min<std::int64_t>(first.value_or(0), 0);
    last = std::max<std::int64_t>(last.value_or(0), 0);
  }
  if (first) {
    // The difference of any two stamps fits into 64 bits without a sign.
    const std::uint64_t span_ns = static_cast<std::uint64_t>(*last) - static_cast<std::uint64_t>(*first);
    if (span_ns > static_cast<std::uint64_t>(kMaxSpan_ns)) {
      refuse(name,
             fmt::format("the times of points span {:.6g} s", static_cast<double>(span_ns) / kNanosecondsPerSecond));
    }
    record.start_ns = *first;
  }
  std::vector<float>& time = record.channels.time;
  time.resize(stamps_ns.size());
  std::transform(stamps_ns.begin(), stamps_ns.end(), time.begin(), [&](std::int64_t stamp) {
    const bool unset = stamp == kNoStamp || (stamp == 0 && zero_is_unset);
    return unset ? std::numeric_limits<float>::quiet_NaN()
                 : static_cast<float>(static_cast<double>(stamp - *first) / kNanosecondsPerSecond);
  });
  note_times(record);
}

void check_relative_time(ScanRecord& record, const std::string& name) {
  float first = std::numeric_limits<float>::infinity();
  float last = -first;
  for (float& value : record.channels.time) {
    if (!std::isfinite(value)) {
      value = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    first = std::min(first, value);
    last = std::max(last, value);
  }
  if (static_cast<double>(last) - static_cast<double>(first) > kMaxSpan_s || first < -kMaxSpan_s || last > kMaxSpan_s) {
    refuse(name, fmt::format("the times of points, relative to the scan, reach from {:.6g} to {:.6g} s", first, last));
  }
  note_times(record);
}

}  // namespace berm
