#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/io/trajectory_file.hpp"
#include "csv_columns.hpp"
#include "line_reader.hpp"
#include "lower_case.hpp"
#include "pose_log_builder.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr double kUnitQuaternion = 1e-2;
/// More would be no table of poses.
constexpr std::size_t kMaxColumns = 256;

/// Times that rise over many rows have several digits, so that hardly a row is shorter.
constexpr std::uintmax_t kMinRowBytes = 16;

/// What a column holds.
enum class PoseField : std::uint8_t {
  t,
  t_ns,
  x,
  y,
  z,
  lat,
  lon,
  h,
  qx,
  qy,
  qz,
  qw,
  roll,
  pitch,
  yaw,
  heading,
  quality,
  other,
};
constexpr std::size_t kPoseFields = static_cast<std::size_t>(PoseField::other);

struct Column {
  std::string_view name;
  PoseField field;
  double scale;  ///< to SI
};

constexpr Column kPoseColumns[] = {
    {"t", PoseField::t, 1.0},
    {"t_ns", PoseField::t_ns, 1.0},
    {"x", PoseField::x, 1.0},
    {"y", PoseField::y, 1.0},
    {"z", PoseField::z, 1.0},
    {"lat_deg", PoseField::lat, 1.0},
    {"lon_deg", PoseField::lon, 1.0},
    {"h_m", PoseField::h, 1.0},
    {"qx", PoseField::qx, 1.0},
    {"qy", PoseField::qy, 1.0},
    {"qz", PoseField::qz, 1.0},
    {"qw", PoseField::qw, 1.0},
    {"roll_deg", PoseField::roll, kRadPerDeg},
    {"roll_rad", PoseField::roll, 1.0},
    {"pitch_deg", PoseField::pitch, kRadPerDeg},
    {"pitch_rad", PoseField::pitch, 1.0},
    {"yaw_deg", PoseField::yaw, kRadPerDeg},
    {"yaw_rad", PoseField::yaw, 1.0},
    {"heading_deg", PoseField::heading, kRadPerDeg},
    {"heading_rad", PoseField::heading, 1.0},
    {"quality", PoseField::quality, 1.0},
};

constexpr Column kOtherColumn = {"", PoseField::other, 1.0};

/// What a receiver without a fix writes in place of a number.
bool is_missing(std::string_view text) {
  const std::string word = lower_case(text.starts_with('-') ? text.substr(1) : text);
  return word.empty() || word == "nan" || word == "inf" || word == "infinity";
}

std::optional<Stamp> parse_nanoseconds(std::string_view text) {
  // Digits alone, then as seconds shifted by nine places: what is checked there need not be checked here.
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
    return std::nullopt;
  }
  return parse_seconds(std::string(text) + "e-9");
}

/// One row, in SI units.
struct Row {
  std::optional<Stamp> stamp;
  std::array<double, kPoseFields> values{};

  [[nodiscard]] double operator[](PoseField field) const { return values[static_cast<std::size_t>(field)]; }
};

class PoseCsvReader {
 public:
  PoseCsvReader(LineReader& lines, PoseLogBuilder& builder) : lines_(lines), builder_(builder) {}

  void read() {
    std::string_view line;
    if (!lines_.next(line)) {
      throw lines_.error("the file is empty, expected a header such as t,x,y,z,yaw_deg");
    }
    take_header(line);
    while (lines_.next(line)) {
      ++builder_.counts().records;
      take_row(line);
    }
  }

 private:
  [[nodiscard]] bool has(PoseField field) const { return has_[static_cast<std::size_t>(field)]; }

  void take_header(std::string_view line) {
    if (line.starts_with("\xEF\xBB\xBF")) {
      line.remove_prefix(3);  // the byte order mark of spreadsheets
    }
    for (bool more = true; more;) {
      more = line.find(',') != std::string_view::npos;
      take_name(take_column(line));
    }
    if (has(PoseField::t) == has(PoseField::t_ns)) {
      throw lines_.error("expected one column of time, t (s) or t_ns");
    }
    local_ = check_group({PoseField::x, PoseField::y, PoseField::z}, "x, y, z");
    if (local_ == check_group({PoseField::lat, PoseField::lon, PoseField::h}, "lat_deg, lon_deg, h_m")) {
      throw lines_.error("expected the position either as x, y, z or as lat_deg, lon_deg, h_m");
    }
    quaternion_ = check_group({PoseField::qx, PoseField::qy, PoseField::qz, PoseField::qw}, "qx, qy, qz, qw");
    const int ways = (quaternion_ ? 1 : 0) + (has(PoseField::yaw) ? 1 : 0) + (has(PoseField::heading) ? 1 : 0);
    if (ways != 1 || (quaternion_ && (has(PoseField::roll) || has(PoseField::pitch)))) {
      throw lines_.error(
          "expected the attitude in one way: yaw_deg or heading_deg, with roll_deg and pitch_deg, or "
          "qx, qy, qz, qw");
    }
    if (!quaternion_ && !(has(PoseField::roll) && has(PoseField::pitch))) {
      builder_.note("the log does not say " +
                    std::string(has(PoseField::roll)    ? "pitch"
                                : has(PoseField::pitch) ? "roll"
                                                        : "roll and pitch") +
                    ": the machine is taken to be level there, which puts edges on slopes too high or too low");
    }
  }

  void take_name(std::string_view name) {
    if (columns_.size() == kMaxColumns) {
      throw lines_.error("more than " + std::to_string(kMaxColumns) + " columns; is this a table of poses?");
    }
    const auto found = std::find_if(std::begin(kPoseColumns), std::end(kPoseColumns),
                                    [name](const Column& column) { return column.name == name; });
    columns_.push_back(found == std::end(kPoseColumns) ? kOtherColumn : *found);
    if (found == std::end(kPoseColumns)) {
      builder_.note("column " + quoted(name) + " means nothing here and is passed over");
      return;
    }
    bool& seen = has_[static_cast<std::size_t>(found->field)];
    if (seen) {
      throw lines_.error("column " + quoted(name) + " is said twice");
    }
    seen = true;
  }

  /// Whether all of `fields` are there; an error if only some are.
  [[nodiscard]] bool check_group(std::initializer_list<PoseField> fields, const std::string& names) const {
    const auto count = std::count_if(fields.begin(), fields.end(), [this](PoseField field) { return has(field); });
    if (count != 0 && count != static_cast<std::ptrdiff_t>(fields.size())) {
      throw lines_.error("expected all of " + names + " or none of them");
    }
    return count != 0;
  }

  void take_row(std::string_view line) {
    Row row;
    if (!parse_row(line, row)) {
      ++builder_.counts().no_fix;
      return;
    }
    if (last_ && *row.stamp <= *last_) {
      throw lines_.error("the time is not later than the one before; sort the rows by time and drop repeated ones");
    }
    last_ = row.stamp;
    const auto quality = has(PoseField::quality) ? static_cast<int>(row[PoseField::quality]) : 1;
    if (quality <= 0) {
      ++builder_.counts().no_fix;
    } else if (has(PoseField::quality) && !is_good_fix(quality, builder_.config())) {
      builder_.add_poor_fix(*row.stamp);
    } else {
      add_pose(row);
    }
  }

  /// False if a value is missing.
  [[nodiscard]] bool parse_row(std::string_view line, Row& row) const {
    bool whole = true;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const bool last = line.find(',') == std::string_view::npos;
      const std::string_view text = take_column(line);
      if (last != (i + 1 == columns_.size())) {
        throw lines_.error("expected " + std::to_string(columns_.size()) + " columns, as in the header");
      }
      if (columns_[i].field == PoseField::other) {
        continue;
      }
      if (is_missing(text)) {
        whole = false;
      } else {
        parse_value(columns_[i], text, row);
      }
    }
    return whole;
  }

  void parse_value(const Column& column, std::string_view text, Row& row) const {
    const bool is_time = column.field == PoseField::t || column.field == PoseField::t_ns;
    const std::optional<double> value = is_time ? std::optional(0.0) : parse_number(text);
    if (is_time) {
      row.stamp = column.field == PoseField::t ? parse_seconds(text) : parse_nanoseconds(text);
    }
    if (!value || (is_time && !row.stamp)) {
      throw lines_.error(quoted(text) + " is no number for column " + std::string(column.name));
    }
    const double scaled = *value * column.scale;
    check_value(column, scaled);
    row.values[static_cast<std::size_t>(column.field)] = scaled;
  }

  void check_value(const Column& column, double value) const {
    const double limit = [&] {
      switch (column.field) {
        case PoseField::lat:
          return 90.0;
        case PoseField::lon:
          return 360.0;
        case PoseField::h:
          return 100'000.0;
        case PoseField::quality:
          return 100.0;
        default:
          return kMaxCoordinate_m;
      }
    }();
    if (!(std::abs(value) <= limit)) {
      throw lines_.error("the value of column " + std::string(column.name) + " is beyond what it can be");
    }
  }

  void add_pose(const Row& row) {
    LoggedPose pose;
    pose.stamp_ns = *row.stamp;
    pose.attitude = attitude(row);
    bool added = false;
    if (local_) {
      pose.position_m = {row[PoseField::x], row[PoseField::y], row[PoseField::z]};
      added = builder_.add_local(pose);
    } else {
      pose.place = {row[PoseField::lat], row[PoseField::lon], row[PoseField::h]};
      added = builder_.add_geodetic(pose);
    }
    if (!added) {
      throw lines_.error("the time with poses.time_offset_s is beyond +-292 years");
    }
  }

  [[nodiscard]] Eigen::Quaterniond attitude(const Row& row) const {
    if (!quaternion_) {
      const double yaw_rad =
          has(PoseField::yaw) ? row[PoseField::yaw] : 0.5 * std::numbers::pi - row[PoseField::heading];
      return attitude_of(yaw_rad, row[PoseField::pitch], row[PoseField::roll]);
    }
    const Eigen::Quaterniond q(row[PoseField::qw], row[PoseField::qx], row[PoseField::qy], row[PoseField::qz]);
    if (!(std::abs(q.norm() - 1.0) <= kUnitQuaternion)) {
      throw lines_.error("the quaternion has norm " + std::to_string(q.norm()) + ", expected 1");
    }
    return q.normalized();
  }

  LineReader& lines_;
  PoseLogBuilder& builder_;
  std::vector<Column> columns_;
  std::array<bool, kPoseFields> has_{};
  bool local_ = false;
  bool quaternion_ = false;
  std::optional<Stamp> last_;
};

PoseLog read_pose_csv(LineReader& lines, PoseLogBuilder& builder) {
  builder.reserve(lines.bytes() / kMinRowBytes);
  PoseCsvReader(lines, builder).read();
  return builder.finish();
}

}  // namespace

PoseLog read_pose_csv(const std::filesystem::path& path, const PoseLogConfig& config, const GnssMountConfig& mount,
                      const DatumConfig& datum) {
  LineReader lines(path);
  PoseLogBuilder builder(path.string(), config, mount, datum);
  return read_pose_csv(lines, builder);
}

PoseLog read_pose_csv(std::istream& input, const std::string& name, const PoseLogConfig& config,
                      const GnssMountConfig& mount, const DatumConfig& datum) {
  LineReader lines(input, name);
  PoseLogBuilder builder(name, config, mount, datum);
  return read_pose_csv(lines, builder);
}

}  // namespace berm
