#include "edge_kerbs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace berm::bench {
namespace {

constexpr int kCells = 160;  // of 0.25 m, 20 m to every side
constexpr float kCell_m = 0.25F;
constexpr float kNear_m = 0.5F;
constexpr float kReach_m = 20.0F;
constexpr std::uint32_t kRoad = 40;
constexpr std::uint32_t kSidewalk = 48;

/// Middles between cells of sidewalk and cells of road beside them.
std::vector<Eigen::Vector2f> find_border(const PointsView& points, std::span<const std::uint32_t> truth) {
  std::vector<std::uint8_t> what(static_cast<std::size_t>(kCells) * kCells, 0);
  const auto cell = [](float v) { return static_cast<int>(std::floor(v / kCell_m)) + kCells / 2; };
  const auto at = [](int i, int k) { return static_cast<std::size_t>(i) * kCells + static_cast<std::size_t>(k); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t label = truth[i] & 0xFFFFU;
    if (std::hypot(points.x[i], points.y[i]) < kReach_m - 1.0F && (label == kRoad || label == kSidewalk)) {
      what[at(cell(points.x[i]), cell(points.y[i]))] |= label == kRoad ? 1U : 2U;
    }
  }
  std::vector<Eigen::Vector2f> border;
  for (int i = 1; i + 1 < kCells; ++i) {
    for (int k = 1; k + 1 < kCells; ++k) {
      Eigen::Vector2f road = Eigen::Vector2f::Zero();
      int roads = 0;
      for (int d = 0; d < 9; ++d) {
        const int u = i + d / 3 - 1;
        const int v = k + d % 3 - 1;
        if ((what[at(u, v)] & 1U) != 0) {
          road += Eigen::Vector2f(static_cast<float>(u), static_cast<float>(v));
          ++roads;
        }
      }
      if ((what[at(i, k)] & 2U) != 0 && roads > 0) {
        const Eigen::Vector2f middle =
            0.5F * (road / static_cast<float>(roads) + Eigen::Vector2f(static_cast<float>(i), static_cast<float>(k)));
        border.emplace_back((middle.array() + 0.5F - 0.5F * static_cast<float>(kCells)) * kCell_m);
      }
    }
  }
  return border;
}

}  // namespace

void count_kerbs(const PointsView& points, std::span<const std::uint32_t> truth, std::span<const EdgePoint> edges,
                 KerbCounts& counts) {
  const std::vector<Eigen::Vector2f> border = find_border(points, truth);
  const auto is_near = [](const Eigen::Vector2f& a, const EdgePoint& b) {
    return std::hypot(a.x() - b.x_m, a.y() - b.y_m) < kNear_m;
  };
  for (const EdgePoint& edge : edges) {
    if (std::hypot(edge.x_m, edge.y_m) < kReach_m) {
      ++counts.found;
      counts.found_true +=
          std::any_of(border.begin(), border.end(), [&](const auto& place) { return is_near(place, edge); }) ? 1U : 0U;
    }
  }
  for (const Eigen::Vector2f& place : border) {
    ++counts.kerbs;
    counts.kerbs_seen +=
        std::any_of(edges.begin(), edges.end(), [&](const EdgePoint& edge) { return is_near(place, edge); }) ? 1U : 0U;
  }
}

}  // namespace berm::bench
