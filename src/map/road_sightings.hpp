#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/core/edge.hpp"
#include "berm/map/road_survey.hpp"
#include "road_path.hpp"

namespace berm {

/// Scans see a place from this far away along the path, at most. Beyond, a tenth of a degree of attitude is 7 cm.
constexpr double kView_m = 40.0;
/// What was seen from within one stretch of this length is one look: the same face, seen at the same angle with the
/// same error of the pose.
constexpr double kLook_m = 5.0;
constexpr std::size_t kLooks = 16;  // 2 kView_m / kLook_m
/// Heaps make a crest that goes up and down within a metre, so its height is taken in parts of a place, in looks that
/// are four times as wide.
constexpr std::size_t kParts = 4;
constexpr std::size_t kWideLooks = 4;

/// An edge point, seen from a place of the path.
struct EdgeSighting {
  float left_m = 0.0F;  ///< of the path
  float height_m = 0.0F;
  float width_m = 0.0F;
  std::uint8_t look = 0;
  EdgeKind kind = EdgeKind::rise;
};

/// Edge points on one side of a place: all of them up to a fixed number, then every second, every fourth and so on, so
/// that hours at one place take no more memory than a minute.
class EdgeSightings {
 public:
  static constexpr std::size_t kMost = 64;

  void add(const EdgeSighting& sighting);
  [[nodiscard]] std::span<const EdgeSighting> all() const { return {kept_.data(), count_}; }

 private:
  std::array<EdgeSighting, kMost> kept_;
  std::uint32_t count_ = 0;
  std::uint32_t offered_ = 0;
  std::uint32_t stride_ = 1;
};

/// Points of ground in one strip along a place, relative to the place.
struct GroundStrip {
  double sum_z_m = 0.0;
  double sum_along_m = 0.0;
  double sum_left_m = 0.0;
  std::uint32_t count = 0;

  [[nodiscard]] double z_m() const { return sum_z_m / count; }
  [[nodiscard]] double along_m() const { return sum_along_m / count; }
  [[nodiscard]] double left_m() const { return sum_left_m / count; }
};

/// What all scans saw at the places of a path.
class RoadSightings {
 public:
  /// Across the path.
  static constexpr double kStrip_m = 1.0;
  static constexpr double kTopStrip_m = 0.5;
  /// Of a strip where nothing raised was seen.
  static constexpr float kNoTop_m = -1e9F;

  RoadSightings(std::vector<RoadPlace> places, double spacing_m, double reach_m);

  void add_scan(Stamp stamp_ns, std::span<const SurveyedEdge> edges, std::span<const Eigen::Vector3d> ground_m,
                std::span<const Eigen::Vector3d> raised_m);

  [[nodiscard]] const std::vector<RoadPlace>& places() const { return places_; }
  [[nodiscard]] const EdgeSightings& edges(std::size_t place, EdgeSide side) const {
    return edges_[2 * place + (side == EdgeSide::left ? 0 : 1)];
  }
  /// From right to left, each `kStrip_m` wide.
  [[nodiscard]] std::span<const GroundStrip> ground(std::size_t place) const {
    return {ground_.data() + place * strips_, strips_};
  }
  /// Ground near the path, one for every look.
  [[nodiscard]] std::span<const GroundStrip> looks(std::size_t place) const {
    return {looks_.data() + place * kLooks, kLooks};
  }
  /// The strip, `kTopStrip_m` wide, that lies `left_m` of the path; none beyond the reach.
  [[nodiscard]] std::optional<std::size_t> top_strip(double left_m) const;
  /// The highest raised point of such a strip in one of the parts of the place along the path, above the place, in
  /// every wide look.
  [[nodiscard]] std::span<const float> tops_m(std::size_t place, std::size_t strip, std::size_t part) const {
    return {tops_m_.data() + ((place * top_strips_ + strip) * kParts + part) * kWideLooks, kWideLooks};
  }
  /// The middle of a part along the path.
  [[nodiscard]] double part_along_m(std::size_t part) const {
    return (static_cast<double>(part) + 0.5 - 0.5 * kParts) * part_m_;
  }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// Where a point lies on the path.
  struct Spot {
    std::size_t place = 0;
    float along_m = 0.0F;
    float left_m = 0.0F;
  };

  void open_window(Stamp stamp_ns);
  [[nodiscard]] bool find_spot(const Eigen::Vector3d& point_m, Spot& spot);
  [[nodiscard]] int nearest_in_cell(int column, int row);
  [[nodiscard]] std::size_t look_of(std::size_t place) const;
  void add_ground(const Eigen::Vector3d& point_m);
  void add_raised(const Eigen::Vector3d& point_m);

  /// A place of the window, relative to the machine.
  struct WindowPlace {
    float x_m = 0.0F;
    float y_m = 0.0F;
    float ahead_x = 1.0F;
    float ahead_y = 0.0F;
  };

  std::vector<RoadPlace> places_;
  double half_slice_m_;
  double part_m_;  ///< along the path
  double half_width_m_;
  std::size_t strips_;
  std::vector<EdgeSightings> edges_;  // left and right of each place
  std::vector<GroundStrip> ground_;
  std::vector<GroundStrip> looks_;
  std::size_t top_strips_;
  std::vector<float> tops_m_;
  // Of the scan that is being added.
  Eigen::Vector3d machine_m_ = Eigen::Vector3d::Zero();
  std::size_t machine_ = 0;
  std::size_t first_ = 0;
  std::vector<WindowPlace> window_;
  std::vector<std::int32_t> nearest_;
};

}  // namespace berm
