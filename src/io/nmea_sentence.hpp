#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

#include "berm/core/stamp.hpp"

namespace berm {

/// A sentence whose checksum was right: the address and the fields behind it.
struct NmeaSentence {
  static constexpr std::size_t kMaxFields = 32;

  std::string_view address;  ///< "GPGGA", "PASHR"
  std::array<std::string_view, kMaxFields> fields{};
  std::size_t count = 0;  ///< of fields; those beyond kMaxFields are left out

  /// Field `i`, from 0; empty where there is none.
  [[nodiscard]] std::string_view operator[](std::size_t i) const { return i < count ? fields[i] : std::string_view(); }
  /// Whether it is a sentence of this type, of any talker.
  [[nodiscard]] bool is(std::string_view type) const;
};

enum class NmeaLine { none, bad, good };

/// Looks for a sentence in `line`: none, one whose checksum is missing or wrong, or a good one, which `sentence` then
/// holds as long as `line` lives. What stands before and behind it is passed over.
[[nodiscard]] NmeaLine find_sentence(std::string_view line, NmeaSentence& sentence);

/// hhmmss or hhmmss.sss as nanoseconds since midnight.
[[nodiscard]] std::optional<Stamp> parse_time_of_day(std::string_view text);
/// ddmm.mmmm or dddmm.mmmm with its hemisphere, `positive` or `negative`, in degrees.
[[nodiscard]] std::optional<double> parse_angle(std::string_view text, std::string_view hemisphere, char positive,
                                                char negative, double max_deg);
/// ddmmyy.
[[nodiscard]] std::optional<std::chrono::sys_days> parse_date(std::string_view text);
[[nodiscard]] std::optional<std::chrono::sys_days> parse_date(std::string_view day, std::string_view month,
                                                              std::string_view year);

/// Gives times of day the day that they belong to: midnight is where they fall by more than half a day.
class NmeaClock {
 public:
  /// Nanoseconds since the first midnight, negative before it.
  [[nodiscard]] Stamp at(Stamp time_of_day_ns);
  /// A sentence said that it is `date` at `time_of_day_ns`.
  void set_date(std::chrono::sys_days date, Stamp time_of_day_ns);
  /// The first midnight in nanoseconds since 1970, where a date was said.
  [[nodiscard]] std::optional<Stamp> first_midnight_ns() const;

 private:
  int day_ = 0;
  std::optional<Stamp> last_time_ns_;
  std::optional<std::chrono::sys_days> first_day_;
};

}  // namespace berm
