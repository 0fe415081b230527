#include "road_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace berm {
namespace {

constexpr double kCell_m = 4.0;
/// Who goes across the path looks around every so often; segments are found this far from where they are.
constexpr double kLookEvery_m = 2.0;
/// No edge has longer segments.
constexpr double kMostSegment_m = 1000.0;
/// What lies nearer to the path was driven over.
constexpr double kLeast_m = 0.5;
/// Edges far above or below are those of another road: of the next bench, on a ramp that turns back.
constexpr double kCrossingClimb_m = 4.0;

void keep_nearer(std::optional<double>& nearest, double distance_m) {
  if (!nearest || distance_m < *nearest) {
    nearest = distance_m;
  }
}

}  // namespace

RoadEdgeIndex::RoadEdgeIndex(std::span<const EdgeLine> lines) : cells_(kCell_m) {
  for (const EdgeLine& line : lines) {
    for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i) {
      const EdgeLine::Vertex& a = line.vertices[i];
      const EdgeLine::Vertex& b = line.vertices[i + 1];
      if (a.position_m.allFinite() && b.position_m.allFinite() && a.confidence >= kLeastConfidence &&
          b.confidence >= kLeastConfidence && (b.position_m - a.position_m).norm() <= kMostSegment_m) {
        add({a.position_m, b.position_m});
      }
    }
  }
}

void RoadEdgeIndex::add(const Segment& segment) {
  const auto number = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back(segment);
  const Eigen::Vector3d along_m = segment.to_m - segment.from_m;
  const int parts = static_cast<int>(along_m.norm() / kCell_m) + 1;
  for (int i = 0; i < parts; ++i) {
    Eigen::Vector3d a_m = segment.from_m + (1.0 * i / parts) * along_m;
    Eigen::Vector3d b_m = segment.from_m + (1.0 * (i + 1) / parts) * along_m;
    const Eigen::Vector3d margin_m(kLookEvery_m, kLookEvery_m, 0.0);
    const Eigen::Vector3d low_m = a_m.cwiseMin(b_m) - margin_m;
    const Eigen::Vector3d high_m = a_m.cwiseMax(b_m) + margin_m;
    const auto low = cells_.key_of({low_m.x(), low_m.y(), 0.0});
    const auto high = cells_.key_of({high_m.x(), high_m.y(), 0.0});
    if (!low || !high) {
      continue;
    }
    for (std::int32_t x = low->x; x <= high->x; ++x) {
      for (std::int32_t y = low->y; y <= high->y; ++y) {
        std::vector<std::uint32_t>& cell = cells_.at_or_new({x, y, 0});
        if (cell.empty() || cell.back() != number) {
          cell.push_back(number);
        }
      }
    }
  }
}

RoadCrossings RoadEdgeIndex::find(const RoadPlace& place, double reach_m) const {
  RoadCrossings crossings;
  const Eigen::Vector3d left(-place.ahead.y(), place.ahead.x(), 0.0);
  const int looks = static_cast<int>(std::ceil(reach_m / kLookEvery_m));
  for (int i = -looks; i <= looks; ++i) {
    const Eigen::Vector3d here_m = place.position_m + i * kLookEvery_m * left;
    const auto key = cells_.key_of({here_m.x(), here_m.y(), 0.0});
    const auto* cell = key ? cells_.find(*key) : nullptr;
    if (cell == nullptr) {
      continue;
    }
    for (const std::uint32_t number : *cell) {
      const Eigen::Vector2d a = place.in_path(segments_[number].from_m);
      const Eigen::Vector2d b = place.in_path(segments_[number].to_m);
      if ((a.x() < 0.0) == (b.x() < 0.0)) {
        continue;
      }
      const double share = a.x() / (a.x() - b.x());
      const double left_m = a.y() + share * (b.y() - a.y());
      const double z_m = segments_[number].from_m.z() +
                         share * (segments_[number].to_m.z() - segments_[number].from_m.z()) - place.position_m.z();
      if (std::abs(left_m) >= kLeast_m && std::abs(left_m) <= reach_m && std::abs(z_m) <= kCrossingClimb_m) {
        keep_nearer(left_m > 0.0 ? crossings.left_m : crossings.right_m, std::abs(left_m));
      }
    }
  }
  return crossings;
}

}  // namespace berm
