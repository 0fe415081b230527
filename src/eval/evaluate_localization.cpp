#include "evaluate_localization.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "berm/eval/trajectory_metrics.hpp"
#include "berm/io/trajectory_file.hpp"
#include "is_there.hpp"

namespace berm {

std::optional<LocalizationEvaluation> evaluate_localization(const std::filesystem::path& run_folder,
                                                            const Recording& recording) {
  const std::filesystem::path file = run_folder / "trajectory_map.tum";
  const auto truth = recording.read_truth_poses();
  if (!is_there(file) || !truth) {
    return std::nullopt;
  }
  const std::vector<PosePair> pairs = pair_poses(read_tum(file), *truth);
  if (pairs.empty()) {
    return std::nullopt;
  }
  LocalizationEvaluation result{.poses = pairs.size(), .ate_rmse_m = absolute_error_m(pairs)};
  double squares_m2 = 0.0;
  double squares_rad2 = 0.0;
  for (const PosePair& pair : pairs) {
    const double error_m = (pair.estimate.translation_m() - pair.truth.translation_m()).norm();
    const double error_rad = pair.estimate.rotation().angularDistance(pair.truth.rotation());
    squares_m2 += error_m * error_m;
    squares_rad2 += error_rad * error_rad;
    result.max_m = std::max(result.max_m, error_m);
    result.max_deg = std::max(result.max_deg, error_rad * 180.0 / std::numbers::pi);
  }
  const auto count = static_cast<double>(pairs.size());
  result.rmse_m = std::sqrt(squares_m2 / count);
  result.rmse_deg = std::sqrt(squares_rad2 / count) * 180.0 / std::numbers::pi;
  return result;
}

}  // namespace berm
