#include "nmea_sentence.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr Stamp kSecond_ns = 1'000'000'000;
constexpr Stamp kDay_ns = 86'400 * kSecond_ns;
/// Two-digit years from here on are of the last century: GPS began in 1980.
constexpr int kFirstYear = 80;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::optional<unsigned> parse_digits(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = !text.empty() && error == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

std::optional<unsigned> parse_hex(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  const bool whole = text.size() == 2 && error == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

std::uint8_t checksum(std::string_view text) {
  std::uint8_t sum = 0;
  for (const char c : text) {
    sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
  }
  return sum;
}

bool begins_sentence(std::string_view text) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  return text.size() >= 3 && std::all_of(text.begin(), text.begin() + 3, is_capital);
}

void split(std::string_view body, NmeaSentence& sentence) {
  sentence = {};
  std::size_t comma = body.find(',');
  sentence.address = body.substr(0, comma);
  while (comma != std::string_view::npos && sentence.count < NmeaSentence::kMaxFields) {
    body.remove_prefix(comma + 1);
    comma = body.find(',');
    sentence.fields[sentence.count++] = body.substr(0, comma);
  }
}

}  // namespace

bool NmeaSentence::is(std::string_view type) const {
  return address.size() == 5 && address.substr(2) == type;
}

NmeaLine find_sentence(std::string_view line, NmeaSentence& sentence) {
  const std::size_t dollar = line.find('$');
  if (dollar == std::string_view::npos) {
    return NmeaLine::none;
  }
  const std::size_t star = line.find('*', dollar);
  // A sentence may have been cut by the next one: the last beginning before the checksum counts.
  const std::string_view body = star == std::string_view::npos
                                    ? line.substr(dollar + 1)
                                    : line.substr(line.rfind('$', star) + 1, star - line.rfind('$', star) - 1);
  if (!begins_sentence(body)) {
    return NmeaLine::none;
  }
  const std::optional<unsigned> said =
      star == std::string_view::npos ? std::nullopt : parse_hex(line.substr(star + 1, 2));
  if (!said || *said != checksum(body)) {
    return NmeaLine::bad;
  }
  split(body, sentence);
  return NmeaLine::good;
}

std::optional<Stamp> parse_time_of_day(std::string_view text) {
  constexpr std::size_t kWholeDigits = 6;
  constexpr unsigned kLeapSecond = 60;
  if (text.size() < kWholeDigits || !std::all_of(text.begin(), text.begin() + kWholeDigits, is_digit) ||
      (text.size() > kWholeDigits && text[kWholeDigits] != '.')) {
    return std::nullopt;
  }
  const unsigned hours = *parse_digits(text.substr(0, 2));
  const unsigned minutes = *parse_digits(text.substr(2, 2));
  const unsigned whole_seconds = *parse_digits(text.substr(4, 2));
  const std::optional<Stamp> seconds_ns = parse_seconds(text.substr(4));
  if (hours > 23 || minutes > 59 || whole_seconds > kLeapSecond || !seconds_ns) {
    return std::nullopt;
  }
  return static_cast<Stamp>(hours * 3600 + minutes * 60) * kSecond_ns + *seconds_ns;
}

std::optional<double> parse_angle(std::string_view text, std::string_view hemisphere, char positive, char negative,
                                  double max_deg) {
  const std::size_t whole_digits = std::min(text.find('.'), text.size());
  if (whole_digits < 3 || hemisphere.size() != 1 || (hemisphere[0] != positive && hemisphere[0] != negative)) {
    return std::nullopt;
  }
  // Degrees and minutes apart: together they would cost a digit.
  const std::optional<unsigned> degrees = parse_digits(text.substr(0, whole_digits - 2));
  const std::optional<double> minutes = parse_number(text.substr(whole_digits - 2));
  if (!degrees || !minutes || !(*minutes >= 0.0 && *minutes < 60.0)) {
    return std::nullopt;
  }
  const double angle_deg = static_cast<double>(*degrees) + *minutes / 60.0;
  if (angle_deg > max_deg) {
    return std::nullopt;
  }
  return hemisphere[0] == positive ? angle_deg : -angle_deg;
}

std::optional<std::chrono::sys_days> parse_date(std::string_view text) {
  if (text.size() != 6) {
    return std::nullopt;
  }
  const std::optional<unsigned> year = parse_digits(text.substr(4, 2));
  if (!year) {
    return std::nullopt;
  }
  const std::string_view century = *year < kFirstYear ? "20" : "19";
  std::array<char, 4> digits = {century[0], century[1], text[4], text[5]};
  return parse_date(text.substr(0, 2), text.substr(2, 2), std::string_view(digits.data(), digits.size()));
}

std::optional<std::chrono::sys_days> parse_date(std::string_view day, std::string_view month, std::string_view year) {
  const std::optional<unsigned> d = parse_digits(day);
  const std::optional<unsigned> m = parse_digits(month);
  const std::optional<unsigned> y = parse_digits(year);
  constexpr unsigned kFirst = 1980;
  constexpr unsigned kLast = 2200;  // within what stamps can say
  if (!d || !m || !y || *y < kFirst || *y > kLast) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*y)), std::chrono::month(*m),
                                         std::chrono::day(*d)};
  return date.ok() ? std::optional(std::chrono::sys_days(date)) : std::nullopt;
}

Stamp NmeaClock::at(Stamp time_of_day_ns) {
  if (last_time_ns_) {
    const Stamp step_ns = time_of_day_ns - *last_time_ns_;
    day_ += step_ns < -kDay_ns / 2 ? 1 : (step_ns > kDay_ns / 2 ? -1 : 0);
  }
  last_time_ns_ = time_of_day_ns;
  return day_ * kDay_ns + time_of_day_ns;
}

void NmeaClock::set_date(std::chrono::sys_days date, Stamp time_of_day_ns) {
  (void)at(time_of_day_ns);
  if (!first_day_) {
    first_day_ = date - std::chrono::days(day_);
  }
  day_ = static_cast<int>((date - *first_day_).count());
}

std::optional<Stamp> NmeaClock::first_midnight_ns() const {
  return first_day_ ? std::optional(first_day_->time_since_epoch().count() * kDay_ns) : std::nullopt;
}

}  // namespace berm
