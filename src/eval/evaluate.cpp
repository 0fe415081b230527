#include "berm/eval/evaluate.hpp"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "evaluate_edges.hpp"
#include "evaluate_localization.hpp"
#include "is_there.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using Labels = std::vector<std::uint32_t>;

constexpr std::uint32_t kFallingSnow = 110;
constexpr std::uint32_t kDrivable = 40;
constexpr std::uint32_t kTerrain = 72;
constexpr std::uint64_t kMaxRunFileBytes = std::uint64_t{256} << 20U;

bool holds(const Labels& labels, std::uint32_t id) {
  return std::any_of(labels.begin(), labels.end(), [id](std::uint32_t raw) { return semantic_class(raw) == id; });
}

/// Names of the stages of the run; none if run.json is missing.
std::optional<std::set<std::string>> read_stages(const fs::path& run_file) {
  if (!is_there(run_file)) {
    return std::nullopt;
  }
  FileBuffer buffer;
  read_file(run_file, buffer, kMaxRunFileBytes);
  const auto report = nlohmann::json::parse(buffer.text(), nullptr, false);
  if (!report.is_object() || !report.contains("stages") || !report["stages"].is_object()) {
    throw FileError(ErrorCode::malformed, run_file.string(), std::nullopt,
                    "expected a JSON object with 'stages', as berm run writes it; run again with --force");
  }
  std::set<std::string> names;
  for (const auto& stage : report["stages"].items()) {
    names.insert(stage.key());
  }
  return names;
}

void add(std::optional<BinaryCounts>& sum, const BinaryCounts& counts) {
  sum = sum.value_or(BinaryCounts{}) += counts;
}

class Evaluator {
 public:
  Evaluator(const fs::path& run_folder, const Recording& recording, bool per_scan)
      : run_folder_(run_folder), recording_(recording), per_scan_(per_scan) {
    if (!is_there(run_folder / "labels") && !is_there(run_folder / "trajectory.tum")) {
      throw FileError(ErrorCode::not_found, run_folder.string(), std::nullopt,
                      "holds neither labels/ nor trajectory.tum, expected the output folder of berm run");
    }
    const auto stages = read_stages(run_folder / "run.json");
    if (!stages) {
      evaluation_.notes.emplace_back("the run has no run.json: it did not finish");
    }
    // A run without these stages may have been labelled by other means, so its labels speak as well.
    output_has_snow_ = stages && stages->contains("snow");
    output_has_piste_ = stages && stages->contains("piste");
  }

  Evaluation finish() {
    for (std::size_t i = 0; i < recording_.size(); ++i) {
      judge_scan(i);
    }
    give_reasons();
    judge_trajectory();
    evaluation_.localization = evaluate_localization(run_folder_, recording_);
    EdgeEvaluation edges = evaluate_edges(run_folder_, recording_);
    evaluation_.edges = edges.score;
    if (!edges.score) {
      evaluation_.left_out.emplace("edges", edges.reason);
    }
    return std::move(evaluation_);
  }

 private:
  void judge_scan(std::size_t index) {
    const ScanEntry entry = recording_.scan(index);
    const fs::path output_file = run_folder_ / "labels" / (entry.name + ".label");
    const bool has_output = is_there(output_file);
    if (!entry.truth_labels || !has_output) {
      evaluation_.scans_without_truth += has_output ? 1U : 0U;
      evaluation_.scans_without_output += entry.truth_labels ? 1U : 0U;
      return;
    }
    try {
      const Labels output = read_labels(output_file, std::nullopt);
      const Labels truth = read_labels(*entry.truth_labels, output.size());
      keep(entry.name, judge_labels(index, output, truth));
    } catch (const Error& error) {
      evaluation_.failed.push_back({entry.name, error.what()});
    }
  }

  LabelEvaluation judge_labels(std::size_t index, const Labels& output, const Labels& truth) {
    truth_has_piste_ |= holds(truth, kDrivable);
    truth_has_snow_ |= holds(truth, kFallingSnow);
    output_has_snow_ |= holds(output, kFallingSnow);
    output_has_piste_ |= holds(output, kTerrain);
    LabelEvaluation labels;
    labels.ground = judge_ground(output, truth);
    labels.piste = judge_piste(output, truth);
    labels.snow = judge_snow(output, truth, find_returns(index, truth.size()));
    return labels;
  }

  std::vector<std::uint8_t> find_returns(std::size_t index, std::size_t points) {
    recording_.read(index, scan_);
    const PointsView view = scan_.cloud.view();
    if (view.size() != points) {
      throw Error(ErrorCode::malformed,
                  "the scan has " + std::to_string(view.size()) + " points, its labels are " + std::to_string(points));
    }
    std::vector<std::uint8_t> is_return(points);
    for (std::size_t i = 0; i < points; ++i) {
      is_return[i] = is_no_return(view.x[i], view.y[i], view.z[i]) ? 0 : 1;
    }
    return is_return;
  }

  void keep(const std::string& name, const LabelEvaluation& labels) {
    ++evaluation_.scans_judged;
    add(evaluation_.labels.ground, *labels.ground);
    add(evaluation_.labels.piste, *labels.piste);
    add(evaluation_.labels.snow, *labels.snow);
    if (per_scan_) {
      evaluation_.scans.push_back({name, labels});
    }
  }

  /// Only now it is known what truth and output speak of.
  void give_reasons() {
    if (evaluation_.scans_judged == 0) {
      const bool no_truth = evaluation_.scans_without_output == 0 && evaluation_.failed.empty();
      const std::string reason = no_truth ? "the recording has no labels/" : "no scan with truth has labels in the run";
      for (const char* metric : {"ground", "piste", "snow"}) {
        evaluation_.left_out.emplace(metric, reason);
      }
      return;
    }
    if (!truth_has_piste_) {
      drop("piste", &LabelEvaluation::piste, "truth has no drivable surface (40)");
    } else if (!output_has_piste_) {
      drop("piste", &LabelEvaluation::piste, "the run does not tell drivable ground (40) from other terrain (72)");
    }
    if (!truth_has_snow_) {
      drop("snow", &LabelEvaluation::snow, "truth has no falling snow (110)");
    } else if (!output_has_snow_) {
      drop("snow", &LabelEvaluation::snow, "the run has no labels of falling snow (110)");
    }
  }

  void drop(const char* metric, std::optional<BinaryCounts> LabelEvaluation::*member, const char* reason) {
    evaluation_.left_out.emplace(metric, reason);
    (evaluation_.labels.*member).reset();
    for (ScanEvaluation& scan : evaluation_.scans) {
      (scan.labels.*member).reset();
    }
  }

  void judge_trajectory() {
    const auto leave_out = [this](const char* reason) { evaluation_.left_out.emplace("trajectory", reason); };
    if (!is_there(run_folder_ / "trajectory.tum")) {
      return leave_out("the run has no trajectory.tum");
    }
    const auto truth = recording_.read_truth_poses();
    if (!truth) {
      return leave_out("the recording has no truth.tum");
    }
    const auto pairs = pair_poses(read_tum(run_folder_ / "trajectory.tum"), *truth);
    const auto ate_rmse_m = absolute_error_m(pairs);
    if (!ate_rmse_m) {
      return leave_out("fewer than 3 poses of the run lie within the time of truth.tum");
    }
    evaluation_.trajectory = TrajectoryEvaluation{.poses = pairs.size(),
                                                  .path_m = path_length_m(pairs),
                                                  .ate_rmse_m = *ate_rmse_m,
                                                  .relative = relative_errors(pairs)};
  }

  const fs::path& run_folder_;
  const Recording& recording_;
  bool per_scan_;
  bool truth_has_piste_ = false;
  bool truth_has_snow_ = false;
  bool output_has_piste_ = false;
  bool output_has_snow_ = false;
  Scan scan_;
  Evaluation evaluation_;
};

}  // namespace

Evaluation evaluate(const fs::path& run_folder, const Recording& recording, bool per_scan) {
  return Evaluator(run_folder, recording, per_scan).finish();
}

}  // namespace berm
