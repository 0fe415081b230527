#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/view/export_run.hpp"
#include "berm/view/points_payload.hpp"
#include "label_colors.hpp"

namespace berm {
namespace {

/// Where the points of a run come from, piece by piece, always in the same order.
class CloudSource {
 public:
  CloudSource(const ShownRun& run, const ExportOptions& options) : run_(run), options_(options) {}

  /// Calls `take` with the points of each piece. Twice the same run gives twice the same.
  template <typename Take>
  ExportSummary read(std::size_t done, Take&& take) {
    ExportSummary summary;
    std::exception_ptr first_error;
    for (std::size_t i = 0; i < run_.size() && !summary.interrupted; i += options_.every) {
      try {
        if (read_scan(i)) {
          take(points_);
          ++summary.scans;
          summary.points += points_.size();
        } else {
          ++summary.skipped;
        }
      } catch (const FileError& error) {
        if (error.code() == ErrorCode::write_failed) {
          throw;
        }
        first_error = first_error ? first_error : std::current_exception();
        ++summary.skipped;
      }
      summary.interrupted = options_.should_stop && options_.should_stop();
      if (options_.on_progress) {
        options_.on_progress(done + i + 1, 2 * run_.size());
      }
    }
    if (summary.scans == 0 && first_error && !summary.interrupted) {
      std::rethrow_exception(first_error);
    }
    return summary;
  }

 private:
  /// False without a pose.
  bool read_scan(std::size_t index) {
    run_.read(index, scan_);
    const std::optional<Pose> T_world_base = run_.trajectory().at(scan_.stamp_ns);
    if (!T_world_base) {
      return false;
    }
    const Eigen::Isometry3d T_world_sensor((*T_world_base * scan_.T_base_sensor).matrix());
    const PointsView view = scan_.cloud.view();
    points_.clear();
    for (std::size_t i = 0; i < view.size(); ++i) {
      if (!is_in_payload(view.x[i], view.y[i], view.z[i])) {
        continue;
      }
      CloudPoint point;
      point.position_m = T_world_sensor * Eigen::Vector3d(view.x[i], view.y[i], view.z[i]);
      point.intensity = view.intensity.empty() ? 0.0F : view.intensity[i];
      point.label = view.label.empty() ? Label::unlabeled : view.label[i];
      point.time_s = to_seconds(scan_.stamp_ns) + (view.time.empty() ? 0.0 : double{view.time[i]});
      points_.push_back(point);
    }
    return true;
  }

  const ShownRun& run_;
  const ExportOptions& options_;
  Scan scan_;
  std::vector<CloudPoint> points_;
};

}  // namespace

ExportSummary export_cloud(const ShownRun& run, CloudFormat format, const std::filesystem::path& file,
                           const ExportOptions& options) {
  CloudSource source(run, options);
  CloudSummary head;
  // The head of a file says how many points follow, and where: they are read twice rather than kept.
  ExportSummary summary = source.read(0, [&head](const std::vector<CloudPoint>& points) {
    for (const CloudPoint& point : points) {
      head.add(point.position_m);
    }
  });
  if (summary.interrupted) {
    return summary;
  }
  if (summary.scans == 0) {
    throw Error(ErrorCode::invalid_argument,
                run.name() +
                    ": no scan has a pose, so that nobody can say where its points lie in the world; berm view "
                    "shows such scans one by one, and --to foxglove takes them as they are");
  }
  const auto writer = make_cloud_writer(format, file, head, dark_label_colors());
  summary = source.read(run.size(), [&writer](const std::vector<CloudPoint>& points) { writer->add(points); });
  if (!summary.interrupted) {
    writer->commit();
  }
  return summary;
}

}  // namespace berm
