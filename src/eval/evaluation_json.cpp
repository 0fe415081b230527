#include <nlohmann/json.hpp>

#include "berm/eval/evaluate.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kEvalSchemaVersion = 1;

void put(Json& json, const char* key, const std::optional<double>& value) {
  json[key] = value ? Json(*value) : Json(nullptr);
}

Json describe(const BinaryCounts& counts, bool with_accuracy) {
  const BinaryMetrics metrics = derive_metrics(counts);
  Json json = Json::object();
  if (with_accuracy) {
    put(json, "accuracy", metrics.accuracy);
  }
  put(json, "precision", metrics.precision);
  put(json, "recall", metrics.recall);
  put(json, "f1", metrics.f1);
  put(json, "iou", metrics.iou);
  json["points"] = {{"true_positive", counts.true_positive},
                    {"false_positive", counts.false_positive},
                    {"false_negative", counts.false_negative},
                    {"true_negative", counts.true_negative},
                    {"left_out", counts.left_out}};
  return json;
}

void put(Json& json, const LabelEvaluation& labels) {
  if (labels.ground) {
    json["ground"] = describe(*labels.ground, false);
  }
  if (labels.piste) {
    json["piste"] = describe(*labels.piste, true);
  }
  if (labels.snow) {
    json["snow"] = describe(*labels.snow, false);
  }
}

Json describe(const RelativeError& error) {
  Json json = Json::object();
  if (error.length_m > 0.0) {
    json["length_m"] = error.length_m;
  }
  json["translation_percent"] = error.translation_percent;
  json["rotation_deg_per_m"] = error.rotation_deg_per_m;
  json["stretches"] = error.stretches;
  return json;
}

Json describe(const TrajectoryEvaluation& trajectory) {
  Json json = {{"poses", trajectory.poses}, {"path_m", trajectory.path_m}, {"ate_rmse_m", trajectory.ate_rmse_m}};
  const auto mean = mean_error(trajectory.relative);
  json["relative"] = mean ? describe(*mean) : Json(nullptr);
  Json lengths = Json::array();
  for (const RelativeError& error : trajectory.relative) {
    lengths.push_back(describe(error));
  }
  json["relative_by_length"] = lengths;
  return json;
}

Json describe(const LocalizationEvaluation& poses) {
  return {{"poses", poses.poses},     {"rmse_m", poses.rmse_m},
          {"max_m", poses.max_m},     {"rmse_deg", poses.rmse_deg},
          {"max_deg", poses.max_deg}, {"ate_rmse_m", poses.ate_rmse_m ? Json(*poses.ate_rmse_m) : Json(nullptr)}};
}

Json describe(const EdgeScore& edges) {
  Json json = Json::object();
  put(json, "precision", edges.precision);
  put(json, "recall", edges.recall);
  put(json, "f1", edges.f1);
  put(json, "lateral_median_m", edges.lateral_median_m);
  put(json, "lateral_p95_m", edges.lateral_p95_m);
  put(json, "wrong_side_share", edges.wrong_side_share);
  json["places"] = {{"found", edges.found},
                    {"found_right", edges.found_right},
                    {"truth", edges.truth},
                    {"truth_found", edges.truth_found},
                    {"wrong_side", edges.wrong_side}};
  return json;
}

Json describe(const std::vector<FailedScan>& failed) {
  Json list = Json::array();
  for (const FailedScan& scan : failed) {
    list.push_back({{"scan", scan.name}, {"reason", scan.reason}});
  }
  return list;
}

}  // namespace

std::string to_json(const Evaluation& evaluation, const std::filesystem::path& run_folder, const Recording& recording) {
  Json json = {{"schema", "berm.eval/" + std::to_string(kEvalSchemaVersion)},
               {"schema_version", kEvalSchemaVersion},
               {"run", run_folder.string()},
               {"recording", recording.path().string()},
               {"scans",
                {{"judged", evaluation.scans_judged},
                 {"without_truth", evaluation.scans_without_truth},
                 {"without_output", evaluation.scans_without_output},
                 {"failed", evaluation.failed.size()}}}};
  put(json, evaluation.labels);
  if (evaluation.trajectory) {
    json["trajectory"] = describe(*evaluation.trajectory);
  }
  if (evaluation.localization) {
    json["localization"] = describe(*evaluation.localization);
  }
  if (evaluation.edges) {
    json["edges"] = describe(*evaluation.edges);
  }
  json["left_out"] = evaluation.left_out;
  json["failed"] = describe(evaluation.failed);
  json["notes"] = evaluation.notes;
  if (!evaluation.scans.empty()) {
    Json scans = Json::array();
    for (const ScanEvaluation& scan : evaluation.scans) {
      Json entry = {{"scan", scan.name}};
      put(entry, scan.labels);
      scans.push_back(entry);
    }
    json["per_scan"] = scans;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace berm
