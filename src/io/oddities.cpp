#include "oddities.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace berm {
namespace {

constexpr double kMinDuplicateShare = 0.01;
constexpr double kMinTimeBackShare = 0.001;
constexpr double kLongStep = 1.5;
constexpr double kFewPoints = 0.5;
constexpr double kOverlap_turns = 0.05;
constexpr double kMaxIntensity = 255.0;
/// Most sensors see the ground or the machine that they stand on nearer than this.
constexpr double kFarthestNearPoint_m = 10.0;

class OddityFinder {
 public:
  OddityFinder(const OddCounts& counts, RecordingInfo& info) : counts_(counts), info_(info) {}

  void look_at_files() {
    if (info_.scans_failed > 0) {
      odd(fmt::format("{} of {} scans cannot be read", info_.scans_failed, info_.scans_failed + info_.scans_read));
    }
    if (counts_.failed_labels > 0) {
      odd(fmt::format("truth labels of {} scans cannot be used", counts_.failed_labels));
    }
    if (counts_.empty_scans > 0) {
      odd(fmt::format("{} scans hold no points", counts_.empty_scans));
    }
    if (info_.points_per_scan.min < kFewPoints * info_.points_per_scan.median) {
      odd(fmt::format("the smallest scan has {:.0f} points, the middle one {:.0f}", info_.points_per_scan.min,
                      info_.points_per_scan.median));
    }
  }

  void look_at_points() {
    if (const auto& repeated = info_.repeated_point) {
      const auto& [x, y, z] = repeated->position_m;
      odd(fmt::format(
          "{:.1f} % of the points lie exactly at ({:.6g}, {:.6g}, {:.6g}): no-returns that were moved along "
          "with the cloud. So this is not the frame of the sensor; angles and ranges here are seen from "
          "that place",
          100.0 * repeated->share, x, y, z));
    }
    if (info_.nan_share > 0.0) {
      odd(fmt::format("{:.3g} % of the points are NaN", 100.0 * info_.nan_share));
    }
    if (info_.duplicate_share >= kMinDuplicateShare) {
      odd(fmt::format(
          "{:.1f} % of the points lie at the very place of another: two returns per beam, or doubled on export",
          100.0 * info_.duplicate_share));
    }
    if (info_.range_m && info_.range_m->min > kFarthestNearPoint_m) {
      odd(fmt::format("no point is nearer than {:.1f} m: cropped, or not in the frame of the sensor",
                      info_.range_m->min));
    }
    if (info_.order == FiringOrder::unordered) {
      odd("neighbours in the list are no neighbours in the world: methods that follow the firing order cannot work "
          "here");
    }
    if (info_.order == FiringOrder::column_wise && std::abs(info_.turns_per_scan - 1.0) > kOverlap_turns) {
      odd(fmt::format("a scan turns by {:.0f} deg instead of 360", 360.0 * info_.turns_per_scan));
    }
  }

  void look_at_intensity() {
    if (!info_.intensity) {
      return;
    }
    if (info_.intensity->max == info_.intensity->min) {
      odd(fmt::format("all intensities are {:g}", info_.intensity->max));
    } else if (info_.intensity->max <= 1.0) {
      odd("intensities stay within 0..1, expected 0..255");
    } else if (info_.intensity->max > kMaxIntensity) {
      odd(fmt::format("intensities reach {:g}, expected 0..255", info_.intensity->max));
    }
  }

  void look_at_time() {
    const double step_s = info_.rate_hz ? 1.0 / *info_.rate_hz : 0.0;
    if (info_.rate_hz && info_.longest_step_s > kLongStep * step_s) {
      odd(fmt::format("the longest step from scan to scan is {:.3g} s, the middle one {:.3g} s", info_.longest_step_s,
                      step_s));
    }
    if (info_.time_span_s && info_.rate_hz && *info_.time_span_s > kLongStep * step_s) {
      odd(fmt::format("a scan lasts {:.3g} s, but scans follow each other by {:.3g} s", *info_.time_span_s, step_s));
    }
    const auto steps = static_cast<double>(counts_.time_steps);
    const auto back = static_cast<double>(counts_.time_steps_back);
    if (steps > 0.0 && back / steps > kMinTimeBackShare) {
      odd(fmt::format("times of points run backwards in {:.2g} % of the steps: the points are not in firing order",
                      100.0 * back / steps));
    }
  }

 private:
  void odd(std::string sentence) { info_.odd.push_back(std::move(sentence)); }

  const OddCounts& counts_;
  RecordingInfo& info_;
};

}  // namespace

void find_oddities(const OddCounts& counts, RecordingInfo& info) {
  OddityFinder finder(counts, info);
  finder.look_at_files();
  finder.look_at_points();
  finder.look_at_intensity();
  finder.look_at_time();
}

}  // namespace berm
