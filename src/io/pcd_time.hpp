#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "berm/io/scan_record.hpp"

namespace berm {

/// Stands for a stamp that is not known.
constexpr std::int64_t kNoStamp = INT64_MIN;

/// Absolute seconds as the nearest nanosecond; kNoStamp for what is no number. Values that cannot be seconds (beyond
/// 292 years) but can be nanoseconds (after 1973) are those, as the Livox driver writes them, and set `were_ns`.
[[nodiscard]] std::int64_t stamp_from_seconds(double seconds, bool& were_ns);

/// Makes `record.channels.time` and `record.start_ns` of absolute stamps. Zeros among stamps of today are points that
/// carry none. Throws FileError(unsupported) if the stamps span more than 1 s.
void set_absolute_time(ScanRecord& record, std::span<const std::int64_t> stamps_ns, const std::string& name);

/// Checks seconds relative to the stamp of the scan, in place; Inf becomes NaN (not known). Throws
/// FileError(unsupported) if they leave +-1 s or span more than 1 s.
void check_relative_time(ScanRecord& record, const std::string& name);

}  // namespace berm
