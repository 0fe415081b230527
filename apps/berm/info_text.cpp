#include "info_text.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "class_names.hpp"

namespace berm {
namespace {

constexpr double kRareClass = 0.001;
constexpr std::size_t kTextWidth = 100;
constexpr std::size_t kLabelWidth = 15;

double shown_degrees(double angle_rad) {
  return angle_rad * kDegPerRad;
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

std::string share_text(double share) {
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
      parts.push_back(share_text(share) + " " + std::string(what));
    }
  };
  add(info.no_return_zero_share, "(0, 0, 0)");
  add(info.no_return_inf_share, "infinite");
  add(info.repeated_point ? info.repeated_point->share : 0.0, "moved along with the cloud");
  return parts.empty() ? "none in the list" : join(parts, ", ");
}

std::string view_text(const FieldOfView& view) {
  const std::string elevation = fmt::format("elevation {:.1f} to {:.1f} deg", shown_degrees(view.elevation_min_rad),
                                            shown_degrees(view.elevation_max_rad));
  if (view.full_turn) {
    return "360 deg, " + elevation;
  }
  return fmt::format("azimuth {:.1f} to {:.1f} deg, {}{}", shown_degrees(view.azimuth_min_rad),
                     shown_degrees(view.azimuth_max_rad), elevation, view.circular ? ", circular" : "");
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
      parts.push_back(name + " " + share_text(share));
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
    parts.push_back(fmt::format("pitched by {:.4g} deg", shown_degrees(*sheet.pitch_rad)));
  }
  if (sheet.scan_hz) {
    parts.push_back(fmt::format("{:g} Hz", *sheet.scan_hz));
  }
  return join(parts, ", ");
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

}  // namespace berm
