#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "berm/eval/edge_metrics.hpp"
#include "berm/eval/label_metrics.hpp"
#include "berm/eval/trajectory_metrics.hpp"
#include "berm/io/recording.hpp"

namespace berm {

/// Counts of one scan, or of all scans added up; a question that truth or output does not speak of has none.
struct LabelEvaluation {
  std::optional<BinaryCounts> ground;
  std::optional<BinaryCounts> piste;
  std::optional<BinaryCounts> snow;
};

struct ScanEvaluation {
  std::string name;
  LabelEvaluation labels;
};

struct TrajectoryEvaluation {
  std::size_t poses = 0;    ///< poses of the run for which truth is known
  double path_m = 0.0;      ///< length of truth's path between them
  double ate_rmse_m = 0.0;  ///< see `absolute_error_m`
  std::vector<RelativeError> relative;
};

/// Poses in a saved map against truth in the same world: as they are, nothing is aligned.
struct LocalizationEvaluation {
  std::size_t poses = 0;  ///< located scans for which truth is known
  double rmse_m = 0.0;
  double max_m = 0.0;
  double rmse_deg = 0.0;
  double max_deg = 0.0;
  std::optional<double> ate_rmse_m;  ///< aligned, as for the trajectory: where the map lies elsewhere than truth
};

/// A scan that has truth and output, but could not be judged.
struct FailedScan {
  std::string name;
  std::string reason;
};

struct Evaluation {
  std::size_t scans_judged = 0;
  std::size_t scans_without_truth = 0;   ///< the run has labels, the recording has none
  std::size_t scans_without_output = 0;  ///< the recording has labels, the run has none
  std::vector<FailedScan> failed;
  LabelEvaluation labels;             ///< over all judged scans: counts added up
  std::vector<ScanEvaluation> scans;  ///< in order, if asked for
  std::optional<TrajectoryEvaluation> trajectory;
  std::optional<LocalizationEvaluation> localization;
  std::optional<EdgeScore> edges;
  std::map<std::string, std::string> left_out;  ///< metric and why it is not there
  std::vector<std::string> notes;

  [[nodiscard]] bool is_whole() const { return failed.empty() && notes.empty(); }
};

/// Judges the run in `run_folder` by the truth that `recording` brings; scans are matched by name. Throws FileError if
/// the folder holds no results of a run or a trajectory is broken; a scan whose labels are broken is counted in
/// `failed`.
[[nodiscard]] Evaluation evaluate(const std::filesystem::path& run_folder, const Recording& recording,
                                  bool per_scan = false);

/// One JSON object: what `berm eval` prints.
[[nodiscard]] std::string to_json(const Evaluation& evaluation, const std::filesystem::path& run_folder,
                                  const Recording& recording);

}  // namespace berm
