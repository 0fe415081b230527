#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "berm/core/angle.hpp"
#include "class_names.hpp"
#include "info_text.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

double to_degrees(double angle_rad) {
  return angle_rad * kDegPerRad;
}

/// Names for programs: they stay when the wording for people changes.
std::string_view token(FiringOrder order) {
  switch (order) {
    case FiringOrder::column_wise:
      return "column_wise";
    case FiringOrder::ring_wise:
      return "ring_wise";
    case FiringOrder::non_repeating:
      return "non_repeating";
    case FiringOrder::unordered:
      return "unordered";
    case FiringOrder::unknown:
      break;
  }
  return "unknown";
}

std::string_view token(RecordingLayout layout) {
  switch (layout) {
    case RecordingLayout::sequence:
      return "sequence";
    case RecordingLayout::kitti:
      return "kitti";
    case RecordingLayout::pcd_folder:
      return "pcd_folder";
    case RecordingLayout::bin_folder:
      return "bin_folder";
    case RecordingLayout::single_file:
      break;
  }
  return "single_file";
}

std::string_view token(StampSource source) {
  switch (source) {
    case StampSource::times_file:
      return "times_file";
    case StampSource::scan_files:
      return "scan_files";
    case StampSource::assumed_rate:
      break;
  }
  return "assumed_rate";
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

nlohmann::ordered_json to_json(const RecordingInfo& info) {
  Json json = {{"schema", kSchema},
               {"recording", info.path},
               {"layout", token(info.layout)},
               {"scans", info.scans},
               {"scans_read", info.scans_read},
               {"scans_failed", info.scans_failed},
               {"bytes", info.bytes},
               {"stamps", token(info.stamp_source)},
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
  json["firing_order"] = token(info.order);
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
