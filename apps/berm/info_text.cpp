#include "info_text.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "class_names.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kRareClass = 0.001;
constexpr std::size_t kTextWidth = 100;
constexpr std::size_t kLabelWidth = 15;

double to_degrees(double angle_rad) {
  return angle_rad * kDegreesPerRadian;
}

/// Lines of "label   value", long values broken at blanks and indented.
class Sheet {
 public:
  void add(std::string_view label, std::string_view value) {
    std::string_view rest = value;
    std::string_view head = label;
    do {
      const std::string_view line = take_line(rest);
      fmt::format_to(std::back_inserter(text_), "{:<{}}{}\n", head, kLabelWidth, line);
      head = "";
    } while (!rest.empty());
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  static std::string_view take_line(std::string_view& rest) {
    std::size_t length = rest.size();
    if (length > kTextWidth - kLabelWidth) {
      const std::size_t blank = rest.rfind(' ', kTextWidth - kLabelWidth);
      length = blank == std::string_view::npos || blank == 0 ? rest.size() : blank;
    }
    const std::string_view line = rest.substr(0, length);
    rest.remove_prefix(length);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    return line;
  }

  std::string text_;
};

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t place = digits.size(); place > 3; place -= 3) {
    digits.insert(place - 3, 1, ',');
  }
  return digits;
}

std::string bytes(std::uint64_t count) {
  constexpr double kMebi = 1024.0 * 1024.0;
  return fmt::format("{:.1f} MiB", static_cast<double>(count) / kMebi);
}

std::string percent(double share) {
  return fmt::format("{:.1f} %", 100.0 * share);
}

std::string scans_text(const RecordingInfo& info) {
  std::string text = grouped(info.scans);
  if (info.scans_read + info.scans_failed < info.scans) {
    text += fmt::format(", {} looked into", grouped(info.scans_read + info.scans_failed));
  }
  if (info.scans_failed > 0) {
    text += fmt::format(", {} not readable", grouped(info.scans_failed));
  }
  return text + ", " + bytes(info.bytes);
}

std::string time_text(const RecordingInfo& info) {
  if (!info.duration_s) {
    return "a single scan";
  }
  std::string text = fmt::format("{:.2f} s", *info.duration_s);
  if (info.rate_hz) {
    text += fmt::format(" at {:.4g} Hz", *info.rate_hz);
  }
  return text + fmt::format(" (stamps: {})", to_string(info.stamp_source));
}

std::string points_text(const RecordingInfo& info) {
  const Spread& n = info.points_per_scan;
  const auto whole = [](double value) { return grouped(static_cast<std::uint64_t>(value)); };
  return n.min == n.max ? whole(n.min) + " in every scan"
                        : whole(n.min) + " to " + whole(n.max) + " per scan, median " + whole(n.median);
}

std::string losses_text(const RecordingInfo& info) {
  std::vector<std::string> parts;
  const auto add = [&](double share, std::string_view what) {
    if (share > 0.0) {
      parts.push_back(percent(share) + " " + std::string(what));
    }
  };
  add(info.no_return_zero_share, "(0, 0, 0)");
  add(info.no_return_inf_share, "infinite");
  add(info.repeated_point ? info.repeated_point->share : 0.0, "moved along with the cloud");
  return parts.empty() ? "none in the list" : join(parts, ", ");
}

std::string view_text(const FieldOfView& view) {
  const std::string elevation = fmt::format("elevation {:.1f} to {:.1f} deg", to_degrees(view.elevation_min_rad),
                                            to_degrees(view.elevation_max_rad));
  if (view.full_turn) {
    return "360 deg, " + elevation;
  }
  return fmt::format("azimuth {:.1f} to {:.1f} deg, {}{}", to_degrees(view.azimuth_min_rad),
                     to_degrees(view.azimuth_max_rad), elevation, view.circular ? ", circular" : "");
}

std::string order_text(const RecordingInfo& info) {
  std::string text(to_string(info.order));
  if (info.rings) {
    text += fmt::format(", {}{} rings", info.rings->from_field ? "" : "about ", info.rings->count);
  }
  if (info.interleaved_lines > 1) {
    text += fmt::format(", {} lines take turns", info.interleaved_lines);
  }
  return text;
}

std::string labels_text(const RecordingInfo& info) {
  std::uint64_t all = 0;
  for (const ClassCount& count : info.truth_classes) {
    all += count.points;
  }
  std::vector<ClassCount> classes = info.truth_classes;
  std::stable_sort(classes.begin(), classes.end(),
                   [](const ClassCount& a, const ClassCount& b) { return a.points > b.points; });
  std::vector<std::string> parts;
  std::vector<std::string> rare;
  for (const ClassCount& count : classes) {
    const std::string name = fmt::format("{} {}", count.id, class_name(count.id));
    const double share = static_cast<double>(count.points) / static_cast<double>(all);
    if (share < kRareClass) {
      rare.push_back(name);
    } else {
      parts.push_back(name + " " + percent(share));
    }
  }
  return fmt::format("{} of {} scans: {}{}{}", info.labelled_scans, info.scans_read, join(parts, ", "),
                     rare.empty() ? "" : "; below 0.1 %: ", join(rare, ", "));
}

std::string poses_text(const PosesInfo& poses) {
  return fmt::format("{}: {} poses of the {}, {:.1f} m", poses.file, grouped(poses.count),
                     poses.of == PoseOf::base ? "machine" : "sensor", poses.length_m);
}

std::string sheet_text(const SensorSheet& sheet) {
  std::vector<std::string> parts;
  if (sheet.sensor) {
    parts.push_back(*sheet.sensor);
  }
  if (sheet.height_m) {
    parts.push_back(fmt::format("{:g} m high", *sheet.height_m));
  }
  if (sheet.pitch_rad) {
    parts.push_back(fmt::format("pitched by {:.4g} deg", to_degrees(*sheet.pitch_rad)));
  }
  if (sheet.scan_hz) {
    parts.push_back(fmt::format("{:g} Hz", *sheet.scan_hz));
  }
  return join(parts, ", ");
}

Json json_of(const std::optional<Spread>& spread) {
  if (!spread) {
    return nullptr;
  }
  return {{"min", spread->min}, {"median", spread->median}, {"p95", spread->p95}, {"max", spread->max}};
}

template <typename Value>
Json json_of_optional(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const std::optional<PosesInfo>& poses) {
  if (!poses) {
    return nullptr;
  }
  return {{"file", poses->file},
          {"of", poses->of == PoseOf::base ? "base" : "sensor"},
          {"count", poses->count},
          {"length_m", poses->length_m}};
}

Json json_of(const std::optional<FieldOfView>& view) {
  if (!view) {
    return nullptr;
  }
  return {{"azimuth_min_deg", to_degrees(view->azimuth_min_rad)},
          {"azimuth_max_deg", to_degrees(view->azimuth_max_rad)},
          {"elevation_min_deg", to_degrees(view->elevation_min_rad)},
          {"elevation_max_deg", to_degrees(view->elevation_max_rad)},
          {"full_turn", view->full_turn},
          {"circular", view->circular}};
}

Json json_of(const SensorSheet& sheet) {
  return {{"sensor", json_of_optional(sheet.sensor)},
          {"sensor_height_m", json_of_optional(sheet.height_m)},
          {"sensor_pitch_deg", sheet.pitch_rad ? Json(to_degrees(*sheet.pitch_rad)) : Json(nullptr)},
          {"scan_hz", json_of_optional(sheet.scan_hz)}};
}

}  // namespace

std::string to_text(const RecordingInfo& info) {
  Sheet sheet;
  sheet.add("recording", fmt::format("{} ({})", info.path, to_string(info.layout)));
  sheet.add("scans", scans_text(info));
  sheet.add("time", time_text(info));
  if (info.scans_read > 0) {
    sheet.add("points", points_text(info));
    sheet.add("fields", join(info.fields, " ") + " -> " + join(info.channels, " "));
    sheet.add("no-returns", losses_text(info));
  }
  if (info.range_m) {
    sheet.add("range", fmt::format("{:.1f} to {:.1f} m, median {:.1f}, 95 % below {:.1f}", info.range_m->min,
                                   info.range_m->max, info.range_m->median, info.range_m->p95));
  }
  if (info.intensity) {
    sheet.add("intensity", fmt::format("{:.4g} to {:.4g}, median {:.4g}", info.intensity->min, info.intensity->max,
                                       info.intensity->median));
  }
  if (info.time_span_s) {
    sheet.add("point times", fmt::format("a scan spans {:.4f} s", *info.time_span_s));
  }
  if (info.field_of_view) {
    sheet.add("firing order", order_text(info));
    sheet.add("field of view", view_text(*info.field_of_view));
    sheet.add("sensor", fmt::format("{} ({})", info.sensor.name, join(info.sensor.reasons, "; ")));
  }
  if (const std::string given = sheet_text(info.sheet); !given.empty()) {
    sheet.add("sequence.json", given);
  }
  if (!info.truth_classes.empty()) {
    sheet.add("truth labels", labels_text(info));
  }
  if (info.given_poses) {
    sheet.add("given poses", poses_text(*info.given_poses));
  }
  if (info.truth_poses) {
    sheet.add("truth poses", poses_text(*info.truth_poses));
  }
  for (const std::string& sentence : info.reading) {
    sheet.add(&sentence == &info.reading.front() ? "read as" : "", sentence);
  }
  for (const std::string& sentence : info.odd) {
    sheet.add(&sentence == &info.odd.front() ? "note" : "", sentence);
  }
  return sheet.take();
}

nlohmann::ordered_json to_json(const RecordingInfo& info) {
  Json json = {{"schema", kSchema},
               {"recording", info.path},
               {"layout", to_string(info.layout)},
               {"scans", info.scans},
               {"scans_read", info.scans_read},
               {"scans_failed", info.scans_failed},
               {"bytes", info.bytes},
               {"stamps", to_string(info.stamp_source)},
               {"duration_s", json_of_optional(info.duration_s)},
               {"rate_hz", json_of_optional(info.rate_hz)},
               {"longest_step_s", info.longest_step_s},
               {"points", info.points},
               {"points_per_scan", json_of(info.points_per_scan)},
               {"fields", info.fields},
               {"channels", info.channels},
               {"range_m", json_of(info.range_m)},
               {"intensity", json_of(info.intensity)},
               {"time_span_s", json_of_optional(info.time_span_s)},
               {"no_return_zero_share", info.no_return_zero_share},
               {"no_return_inf_share", info.no_return_inf_share},
               {"nan_share", info.nan_share},
               {"duplicate_share", info.duplicate_share}};
  json["repeated_point"] = nullptr;
  if (info.repeated_point) {
    json["repeated_point"] = {{"position_m", info.repeated_point->position_m}, {"share", info.repeated_point->share}};
  }
  json["firing_order"] = to_string(info.order);
  json["interleaved_lines"] = info.interleaved_lines;
  json["turns_per_scan"] = info.turns_per_scan;
  json["rings"] = nullptr;
  if (info.rings) {
    json["rings"] = {{"count", info.rings->count}, {"from_field", info.rings->from_field}};
  }
  json["field_of_view"] = json_of(info.field_of_view);
  json["sensor"] = {{"name", info.sensor.name}, {"reasons", info.sensor.reasons}};
  json["sheet"] = json_of(info.sheet);
  json["labelled_scans"] = info.labelled_scans;
  json["truth_classes"] = Json::array();
  for (const ClassCount& count : info.truth_classes) {
    json["truth_classes"].push_back({{"id", count.id}, {"name", class_name(count.id)}, {"points", count.points}});
  }
  json["given_poses"] = json_of(info.given_poses);
  json["truth_poses"] = json_of(info.truth_poses);
  json["read_as"] = info.reading;
  json["notes"] = info.odd;
  return json;
}

}  // namespace berm
