#include "road_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace berm {
namespace {

/// Steps of the path. Half a metre of noise while the machine stands makes no step; the noise of RTK adds 0.04 % to
/// steps of this length.
constexpr double kStep_m = 1.0;
/// What was not driven farther than this in one go is a manoeuvre, or an outlier of the poses.
constexpr double kLeastPiece_m = 2.0;
/// The path's direction is that of a chord this far to both sides: 0.3 degrees with the noise of RTK.
constexpr double kHalfChord_m = 2.5;
/// Coordinates beyond are none.
constexpr double kMaxCoordinate_m = 1e8;
/// Steps between two poses that are trusted, four times 60 s at 40 m/s.
constexpr double kMostParts = 10'000.0;

/// Stamps at both ends of their range are farther apart than a stamp can tell.
double elapsed_ns(Stamp from_ns, Stamp to_ns) {
  return static_cast<double>(static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns));
}

struct PathPoint {
  Eigen::Vector3d position_m;
  Stamp stamp_ns;
  double s_m = 0.0;  ///< from the start of its piece
};

struct Piece {
  std::vector<PathPoint> points;
  Eigen::Vector2d heading;  ///< of the machine at its start

  [[nodiscard]] double length_m() const { return points.back().s_m; }
};

bool is_usable(const Pose& pose) {
  const Eigen::Vector3d& p = pose.translation_m();
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCoordinate_m && pose.rotation().coeffs().allFinite();
}

/// Cuts the poses into pieces of steps.
class PathCutter {
 public:
  PathCutter(const Trajectory& path, const PoseGuardConfig& guard) : trust_(path, guard), guard_(guard) {}

  void add(const StampedPose& pose) {
    if (!is_usable(pose.T_world_base)) {
      return;
    }
    if (trust_.at(pose.stamp_ns) == PoseTrust::jump) {
      was_jump_ = true;
      return;
    }
    const bool is_new = pieces_.empty() || was_jump_ || is_gap(pose);
    was_jump_ = false;
    if (is_new) {
      begin_piece(pose);
    } else {
      drive_to(pose);
    }
    last_ = pose;
  }

  [[nodiscard]] std::vector<Piece> take() {
    end_piece();
    return std::move(pieces_);
  }

 private:
  /// While the machine stands nothing is missed.
  [[nodiscard]] bool is_gap(const StampedPose& pose) const {
    const double elapsed_s = 1e-9 * elapsed_ns(last_.stamp_ns, pose.stamp_ns);
    const double moved_m = (pose.T_world_base.translation_m() - last_.T_world_base.translation_m()).head<2>().norm();
    return elapsed_s > guard_.max_gap_s && moved_m > kStep_m;
  }

  void begin_piece(const StampedPose& pose) {
    end_piece();
    const Eigen::Vector3d ahead = pose.T_world_base.rotation() * Eigen::Vector3d::UnitX();
    const Eigen::Vector2d level = ahead.head<2>();
    pieces_.push_back({{{pose.T_world_base.translation_m(), pose.stamp_ns, 0.0}},
                       level.norm() > 0.0 ? Eigen::Vector2d(level.normalized()) : Eigen::Vector2d::UnitX()});
  }

  /// In steps, on the screw motion between the poses: slow poses do not cut bends.
  void drive_to(const StampedPose& pose) {
    const Pose& from = last_.T_world_base;
    const double length_m = (pose.T_world_base.translation_m() - from.translation_m()).head<2>().norm();
    const int parts = static_cast<int>(std::clamp(std::ceil(length_m / kStep_m), 1.0, kMostParts));
    const double elapsed = elapsed_ns(last_.stamp_ns, pose.stamp_ns);
    for (int i = 1; i < parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      step_to({last_.stamp_ns + static_cast<Stamp>(share * elapsed), interpolate(from, pose.T_world_base, share)});
    }
    step_to(pose);
  }

  void step_to(const StampedPose& pose) {
    Piece& piece = pieces_.back();
    const PathPoint& from = piece.points.back();
    const PathPoint to{pose.T_world_base.translation_m(), pose.stamp_ns, 0.0};
    const Eigen::Vector2d step = (to.position_m - from.position_m).head<2>();
    tail_ = to;
    if (step.norm() < kStep_m) {
      return;
    }
    if (piece.points.size() > 1 && step.dot(last_step()) < 0.0) {
      const StampedPose turned{from.stamp_ns, Pose(pose.T_world_base.rotation(), from.position_m)};
      begin_piece(turned);
    }
    append(to);
  }

  [[nodiscard]] Eigen::Vector2d last_step() const {
    const std::vector<PathPoint>& points = pieces_.back().points;
    return (points.back().position_m - points[points.size() - 2].position_m).head<2>();
  }

  void append(PathPoint point) {
    std::vector<PathPoint>& points = pieces_.back().points;
    point.s_m = points.back().s_m + (point.position_m - points.back().position_m).head<2>().norm();
    points.push_back(point);
  }

  /// The rest that is shorter than a step belongs to the piece, if it goes on ahead.
  void end_piece() {
    if (pieces_.empty() || pieces_.back().points.size() < 2) {
      return;
    }
    const PathPoint& from = pieces_.back().points.back();
    const Eigen::Vector2d rest = (tail_.position_m - from.position_m).head<2>();
    if (tail_.stamp_ns > from.stamp_ns && rest.norm() < kStep_m && rest.dot(last_step()) > 0.0) {
      append(tail_);
    }
  }

  PoseGuard trust_;
  PoseGuardConfig guard_;
  std::vector<Piece> pieces_;
  StampedPose last_;
  PathPoint tail_{Eigen::Vector3d::Zero(), 0, 0.0};
  bool was_jump_ = false;
};

/// The point at `s_m` from the start.
PathPoint point_at(const Piece& piece, double s_m) {
  const auto after = std::lower_bound(piece.points.begin() + 1, piece.points.end() - 1, s_m,
                                      [](const PathPoint& point, double s) { return point.s_m < s; });
  const PathPoint& a = *(after - 1);
  const PathPoint& b = *after;
  const double share = std::clamp((s_m - a.s_m) / (b.s_m - a.s_m), 0.0, 1.0);
  return {a.position_m + share * (b.position_m - a.position_m),
          a.stamp_ns + static_cast<Stamp>(share * elapsed_ns(a.stamp_ns, b.stamp_ns)), s_m};
}

void lay_on(const Piece& piece, std::uint32_t number, double spacing_m, double chainage_m,
            std::vector<RoadPlace>& places) {
  if (piece.points.size() < 2) {
    places.push_back({piece.points[0].position_m, piece.heading, chainage_m, number, piece.points[0].stamp_ns});
    return;
  }
  // Rounding must not cost the last one.
  const auto count = static_cast<std::size_t>(piece.length_m() / spacing_m + 1e-6) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double s_m = std::min(static_cast<double>(i) * spacing_m, piece.length_m());
    const PathPoint here = point_at(piece, s_m);
    const PathPoint behind = point_at(piece, std::max(s_m - kHalfChord_m, 0.0));
    const PathPoint before = point_at(piece, std::min(s_m + kHalfChord_m, piece.length_m()));
    const Eigen::Vector2d chord = (before.position_m - behind.position_m).head<2>();
    const Eigen::Vector2d ahead = chord.norm() > 0.0 ? Eigen::Vector2d(chord.normalized()) : piece.heading;
    places.push_back({here.position_m, ahead, chainage_m + s_m, number, here.stamp_ns});
  }
}

}  // namespace

std::vector<RoadPlace> lay_places(const Trajectory& path, const PoseGuardConfig& guard, double spacing_m) {
  PathCutter cutter(path, guard);
  for (const StampedPose& pose : path.poses()) {
    cutter.add(pose);
  }
  std::vector<Piece> pieces = cutter.take();
  const auto is_short = [](const Piece& piece) { return piece.length_m() < kLeastPiece_m; };
  if (!std::all_of(pieces.begin(), pieces.end(), is_short)) {
    std::erase_if(pieces, is_short);
  } else if (!pieces.empty()) {
    pieces.erase(pieces.begin() + 1, pieces.end());
  }
  std::vector<RoadPlace> places;
  double chainage_m = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    lay_on(pieces[i], static_cast<std::uint32_t>(i), spacing_m, chainage_m, places);
    chainage_m += pieces[i].length_m();
  }
  return places;
}

}  // namespace berm
