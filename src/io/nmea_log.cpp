#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "nmea_sentence.hpp"
#include "pose_log_builder.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

/// Positions of fewer decimals of a minute move in steps of more than 0.02 m.
constexpr std::size_t kFineDecimals = 5;

struct Fix {
  Stamp stamp_ns = 0;
  Geodetic place;
  std::int32_t quality = 0;
};

struct Attitude {
  Stamp stamp_ns = 0;
  Eigen::Quaterniond rotation;  ///< against east, north, up
};

/// Collects what the sentences of a log say.
class NmeaCollector {
 public:
  NmeaCollector(PoseLogCounts& counts, double geoid_separation_m)
      : counts_(counts), geoid_separation_m_(geoid_separation_m) {}

  void take_line(std::string_view line) {
    NmeaSentence sentence;
    switch (find_sentence(line, sentence)) {
      case NmeaLine::none:
        return;
      case NmeaLine::bad:
        ++counts_.records;
        ++counts_.bad_checksum;
        return;
      case NmeaLine::good:
        ++counts_.records;
        counts_.malformed += take(sentence) ? 0U : 1U;
    }
  }

  [[nodiscard]] const std::vector<Fix>& fixes() const { return fixes_; }
  [[nodiscard]] const NmeaClock& clock() const { return clock_; }
  [[nodiscard]] bool is_coarse() const { return !fixes_.empty() && decimals_ < kFineDecimals; }
  [[nodiscard]] bool lacks_separation() const { return lacks_separation_; }
  [[nodiscard]] bool is_level() const { return full_.empty() && !headings_.empty(); }

  /// The attitudes of the best kind that the log has, by time.
  [[nodiscard]] const std::vector<Attitude>& attitudes() {
    std::vector<Attitude>& best = !full_.empty() ? full_ : headings_;
    std::stable_sort(best.begin(), best.end(),
                     [](const Attitude& a, const Attitude& b) { return a.stamp_ns < b.stamp_ns; });
    return best;
  }

 private:
  /// False if the sentence holds what no such sentence holds.
  bool take(const NmeaSentence& s) {
    if (s.is("GGA")) {
      return take_gga(s);
    }
    if (s.address == "PASHR") {
      return take_pashr(s);
    }
    if (s.is("HDT") || s.is("THS")) {
      return take_heading(s);
    }
    if (s.is("RMC")) {
      return take_date(s[0], s[1] == "A" ? parse_date(s[8]) : std::nullopt);
    }
    if (s.is("ZDA")) {
      return take_date(s[0], fixes_.empty() ? std::nullopt : parse_date(s[1], s[2], s[3]));
    }
    return true;
  }

  bool take_gga(const NmeaSentence& s) {
    const std::optional<double> quality = parse_number(s[5]);
    if (s[5].empty() || s[5] == "0" || s[1].empty()) {
      ++counts_.no_fix;
      return true;
    }
    const std::optional<Stamp> time = parse_time_of_day(s[0]);
    const std::optional<double> lat_deg = parse_angle(s[1], s[2], 'N', 'S', 90.0);
    const std::optional<double> lon_deg = parse_angle(s[3], s[4], 'E', 'W', 180.0);
    const std::optional<double> altitude_m = parse_number(s[8]);
    if (!time || !lat_deg || !lon_deg || !altitude_m || !quality || !(*quality >= 1.0 && *quality <= 9.0)) {
      return false;
    }
    const double height_m = *altitude_m + separation_m(s[10]);
    if (!(std::abs(height_m) <= 100'000.0)) {
      return false;
    }
    if (const std::size_t point = s[1].find('.'); point != std::string_view::npos) {
      decimals_ = std::max(decimals_, s[1].size() - point - 1);
    }
    said_ns_ = clock_.at(*time);
    fixes_.push_back({*said_ns_, {*lat_deg, *lon_deg, height_m}, static_cast<std::int32_t>(*quality)});
    return true;
  }

  /// Where a sentence lacks it, the last that was said: it changes by centimetres over kilometres.
  double separation_m(std::string_view text) {
    if (const std::optional<double> said = parse_number(text)) {
      geoid_separation_m_ = *said;
      separation_said_ = true;
    } else {
      lacks_separation_ = lacks_separation_ || !separation_said_;
    }
    return geoid_separation_m_;
  }

  bool take_pashr(const NmeaSentence& s) {
    const std::optional<Stamp> time = parse_time_of_day(s[0]);
    if (!time) {
      return true;  // one of the other sentences of this name: PASHR,POS and the like
    }
    said_ns_ = clock_.at(*time);
    if (s[1].empty() || s[3].empty() || s[4].empty()) {
      return true;
    }
    const std::optional<double> heading_deg = parse_number(s[1]);
    const std::optional<double> roll_deg = parse_signed(s[3]);
    const std::optional<double> pitch_up_deg = parse_signed(s[4]);
    if (!heading_deg || !roll_deg || !pitch_up_deg || !is_heading(*heading_deg) || !(std::abs(*roll_deg) <= 180.0) ||
        !(std::abs(*pitch_up_deg) <= 90.0)) {
      return false;
    }
    keep(full_, attitude_of(yaw_rad(*heading_deg), -*pitch_up_deg * kRadPerDeg, *roll_deg * kRadPerDeg));
    return true;
  }

  bool take_heading(const NmeaSentence& s) {
    const bool invalid = s.is("THS") && s[1] != "A";
    if (s[0].empty() || invalid || !said_ns_) {
      return true;
    }
    const std::optional<double> heading_deg = parse_number(s[0]);
    if (!heading_deg || !is_heading(*heading_deg)) {
      return false;
    }
    keep(headings_, attitude_of(yaw_rad(*heading_deg), 0.0, 0.0));
    return true;
  }

  bool take_date(std::string_view time_text, const std::optional<std::chrono::sys_days>& date) {
    const std::optional<Stamp> time = parse_time_of_day(time_text);
    if (!time) {
      return time_text.empty();
    }
    if (date) {
      clock_.set_date(*date, *time);
    }
    said_ns_ = clock_.at(*time);
    return true;
  }

  void keep(std::vector<Attitude>& list, const Eigen::Quaterniond& rotation) const {
    if (!list.empty() && list.back().stamp_ns == *said_ns_) {
      list.back().rotation = rotation;
    } else {
      list.push_back({*said_ns_, rotation});
    }
  }

  /// "+1.25" as well as "1.25".
  static std::optional<double> parse_signed(std::string_view text) {
    return parse_number(text.starts_with('+') ? text.substr(1) : text);
  }
  static bool is_heading(double heading_deg) { return heading_deg >= 0.0 && heading_deg <= 360.0; }
  static double yaw_rad(double heading_deg) { return (90.0 - heading_deg) * kRadPerDeg; }

  PoseLogCounts& counts_;
  NmeaClock clock_;
  std::vector<Fix> fixes_;
  std::vector<Attitude> full_;      ///< heading, roll, pitch
  std::vector<Attitude> headings_;  ///< heading alone
  std::optional<Stamp> said_ns_;
  double geoid_separation_m_;
  std::size_t decimals_ = 0;
  bool separation_said_ = false;
  bool lacks_separation_ = false;
};

/// The attitude at `stamp_ns`, where those around it are no farther apart than `max_gap_ns`.
std::optional<Eigen::Quaterniond> attitude_at(const std::vector<Attitude>& attitudes, Stamp stamp_ns,
                                              Stamp max_gap_ns) {
  const auto after = std::lower_bound(attitudes.begin(), attitudes.end(), stamp_ns,
                                      [](const Attitude& a, Stamp stamp) { return a.stamp_ns < stamp; });
  if (after != attitudes.end() && after->stamp_ns == stamp_ns) {
    return after->rotation;
  }
  if (after == attitudes.end() || after == attitudes.begin()) {
    return std::nullopt;
  }
  const Attitude& before = *(after - 1);
  if (after->stamp_ns - before.stamp_ns > max_gap_ns) {
    return std::nullopt;
  }
  const double share =
      static_cast<double>(stamp_ns - before.stamp_ns) / static_cast<double>(after->stamp_ns - before.stamp_ns);
  return before.rotation.slerp(share, after->rotation);
}

void add_notes(PoseLogBuilder& builder, const NmeaCollector& log) {
  if (!log.clock().first_midnight_ns()) {
    builder.note("no sentence says the date (RMC, ZDA): times are since midnight");
  }
  if (log.lacks_separation()) {
    builder.note(
        fmt::format("some positions do not say how high the geoid lies: {} m is taken, see "
                    "poses.geoid_separation_m",
                    builder.config().geoid_separation_m));
  }
  if (log.is_coarse()) {
    builder.note("positions have fewer than 5 decimals of a minute: they move in steps of 0.2 m or more");
  }
  if (log.is_level()) {
    builder.note(
        "the log says neither roll nor pitch: the machine is taken to be level, which puts edges on slopes too "
        "high or too low");
  }
}

void add_poses(PoseLogBuilder& builder, const NmeaCollector& log, const std::vector<Attitude>& attitudes) {
  const Stamp midnight_ns = log.clock().first_midnight_ns().value_or(0);
  const Stamp max_gap_ns = from_seconds(builder.config().max_attitude_gap_s);
  builder.reserve(log.fixes().size());
  for (const Fix& fix : log.fixes()) {
    LoggedPose pose;
    pose.stamp_ns = fix.stamp_ns + midnight_ns;
    pose.place = fix.place;
    if (!is_good_fix(fix.quality, builder.config())) {
      builder.add_poor_fix(pose.stamp_ns);
      continue;
    }
    const std::optional<Eigen::Quaterniond> attitude = attitude_at(attitudes, fix.stamp_ns, max_gap_ns);
    if (!attitude) {
      ++builder.counts().no_attitude;
      continue;
    }
    pose.attitude = *attitude;
    builder.add_geodetic(pose);
  }
}

}  // namespace

PoseLog parse_nmea(std::string_view text, const std::string& name, const PoseLogConfig& config,
                   const GnssMountConfig& mount, const DatumConfig& datum) {
  PoseLogBuilder builder(name, config, mount, datum);
  NmeaCollector log(builder.counts(), config.geoid_separation_m);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    log.take_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  const std::vector<Attitude>& attitudes = log.attitudes();
  add_notes(builder, log);
  add_poses(builder, log, attitudes);
  return builder.finish();
}

Pose GnssMountConfig::T_base_gnss() const {
  return Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg,
                                   {x_m, y_m, z_m});
}

PoseLog read_pose_log(const std::filesystem::path& path, const PoseLogConfig& config, const GnssMountConfig& mount,
                      const DatumConfig& datum) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".csv") {
    return read_pose_csv(path, config, mount, datum);
  }
  FileBuffer buffer;
  (void)read_file(path, buffer);
  return parse_nmea(buffer.text(), path.string(), config, mount, datum);
}

}  // namespace berm
