#include "edge_score.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <fmt/format.h>

#include "berm_height.hpp"

namespace berm::bench {
namespace {

constexpr double kNear_m = 0.5;
constexpr double kBeside_m = 25.0;

struct Nearest {
  double distance_m = std::numeric_limits<double>::max();
  bool left = true;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
};

Nearest nearest_edge(const Eigen::Vector3d& p, const std::vector<Edge>& edges) {
  Nearest best;
  for (const Edge& edge : edges) {
    for (std::size_t i = 0; i + 1 < edge.vertices_m.size(); ++i) {
      const Eigen::Vector2d a = edge.vertices_m[i].head<2>();
      const Eigen::Vector2d d = edge.vertices_m[i + 1].head<2>() - a;
      const double t = std::clamp((p.head<2>() - a).dot(d) / std::max(d.squaredNorm(), 1e-12), 0.0, 1.0);
      const Eigen::Vector2d on = a + t * d;
      const double distance = (p.head<2>() - on).norm();
      if (distance < best.distance_m) {
        best = {distance, edge.left, on, d.normalized()};
      }
    }
  }
  return best;
}

bool is_beside(const Eigen::Vector3d& p, const std::vector<Eigen::Vector3d>& path_m) {
  return std::any_of(path_m.begin(), path_m.end(), [&](const Eigen::Vector3d& q) {
    return (p.head<2>() - q.head<2>()).squaredNorm() < kBeside_m * kBeside_m;
  });
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) {
    return 0.0;
  }
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double share_seen(const std::vector<WorldEdge>& found, const RoadTruth& truth) {
  std::size_t seen = 0;
  std::size_t all = 0;
  for (const Edge& edge : truth.edges) {
    for (const Eigen::Vector3d& vertex : edge.vertices_m) {
      if (!is_beside(vertex, truth.path_m)) {
        continue;
      }
      ++all;
      seen += std::any_of(found.begin(), found.end(), [&](const WorldEdge& f) {
        return (f.place_m.head<2>() - vertex.head<2>()).squaredNorm() < kNear_m * kNear_m;
      });
    }
  }
  return all > 0 ? static_cast<double>(seen) / static_cast<double>(all) : 0.0;
}

}  // namespace

EdgeScore score(const std::vector<WorldEdge>& found, const RoadTruth& truth, std::size_t scans) {
  std::vector<double> all;
  std::vector<double> near;
  std::vector<double> heights;
  std::size_t wrong = 0;
  for (const WorldEdge& edge : found) {
    if (!is_beside(edge.place_m, truth.path_m)) {
      continue;
    }
    const Nearest nearest = nearest_edge(edge.place_m, truth.edges);
    all.push_back(nearest.distance_m);
    if (nearest.distance_m >= kNear_m) {
      continue;
    }
    near.push_back(nearest.distance_m);
    wrong += nearest.left != (edge.point.side == EdgeSide::left) ? 1U : 0U;
    if (truth.terrain && edge.point.height_m > 0.0F) {
      if (const std::optional<double> height =
              true_berm_height_beside_m(*truth.terrain, nearest.place, nearest.along)) {
        heights.push_back(std::abs(double{edge.point.height_m} - *height));
      }
    }
  }
  const auto share = [](std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  EdgeScore result;
  result.scans = scans;
  result.points_a_scan = static_cast<double>(all.size()) / static_cast<double>(std::max<std::size_t>(scans, 1));
  result.within = share(near.size(), all.size());
  result.wrong_side = share(wrong, near.size());
  result.median_m = quantile(near, 0.5);
  result.p95_m = quantile(all, 0.95);
  result.seen = share_seen(found, truth);
  result.height_median_m = quantile(heights, 0.5);
  return result;
}

void dump(const std::filesystem::path& file, const std::vector<WorldEdge>& found, const RoadTruth& truth) {
  std::ofstream out(file);
  out << "x,y,z,distance,height,width,confidence,left,drop,true_left,true_height,sx,sy,t\n";
  for (const WorldEdge& edge : found) {
    const Nearest nearest = nearest_edge(edge.place_m, truth.edges);
    const std::optional<double> height =
        truth.terrain ? true_berm_height_beside_m(*truth.terrain, nearest.place, nearest.along) : std::nullopt;
    out << fmt::format("{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f}\n",
                       edge.place_m.x(), edge.place_m.y(), edge.place_m.z(), nearest.distance_m, edge.point.height_m,
                       edge.point.width_m, edge.point.confidence, edge.point.side == EdgeSide::left ? 1 : 0,
                       edge.point.kind == EdgeKind::drop ? 1 : 0, nearest.left ? 1 : 0, height.value_or(0.0),
                       edge.point.x_m, edge.point.y_m, edge.point.time_s);
  }
}

}  // namespace berm::bench
