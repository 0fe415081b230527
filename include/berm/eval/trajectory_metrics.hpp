#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// The same moment in an estimate and in truth; the world frames may differ.
struct PosePair {
  Pose estimate;
  Pose truth;
};

/// The poses of `estimate` with truth interpolated at their stamps; those outside the time of truth are left out.
[[nodiscard]] std::vector<PosePair> pair_poses(const Trajectory& estimate, const Trajectory& truth);

/// Absolute trajectory error: root mean square of the distances that remain when the rigid motion (no scale) is
/// taken away that fits the estimate best to truth (Umeyama 1991). None for fewer than 3 pairs. m.
[[nodiscard]] std::optional<double> absolute_error_m(std::span<const PosePair> pairs);

/// Length of truth's path through the pairs. m.
[[nodiscard]] double path_length_m(std::span<const PosePair> pairs);

/// Mean drift over all stretches of one length.
struct RelativeError {
  double length_m = 0.0;
  double translation_percent = 0.0;  ///< of the length
  double rotation_deg_per_m = 0.0;
  std::size_t stretches = 0;
};

/// Lengths of the stretches over which drift is reported.
inline constexpr double kStretches_m[] = {10.0, 25.0, 50.0, 100.0};

/// For each of `lengths_m`: every stretch from a pose to the first one that truth's path reaches at least that length
/// later; the errors are divided by the length of truth's path in the stretch. Lengths that no stretch reaches are
/// left out.
[[nodiscard]] std::vector<RelativeError> relative_errors(std::span<const PosePair> pairs,
                                                         std::span<const double> lengths_m = kStretches_m);

/// Mean over all stretches of all lengths; none without any. Its `length_m` is 0.
[[nodiscard]] std::optional<RelativeError> mean_error(std::span<const RelativeError> errors);

}  // namespace berm
