#include "rows_behind.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"

namespace berm {
namespace {

/// So far towards the road: across the widest berm and a strip behind it.
constexpr double kLook_m = 15.0;
constexpr double kRowCell_m = 1.0;
constexpr double kRowStep_m = 0.5;
/// From the place itself, whose own line is no row before it.
constexpr double kFrom_m = 1.5;
constexpr double kSameFloor_m = 3.0;
constexpr double kSameWay = 0.7;  // cosine between the directions to the road
/// Share of a line that lies behind another.
constexpr double kMost = 0.5;

/// A vertex by its line, and where the road lies from there.
struct Facing {
  std::size_t line = 0;
  double z_m = 0.0;
  Eigen::Vector2d to_road;
};

Eigen::Vector2d to_road(const EdgeLine& line, std::size_t i) {
  const std::size_t before = i == 0 ? 0 : i - 1;
  const std::size_t after = std::min(i + 1, line.vertices.size() - 1);
  const Eigen::Vector2d along =
      (line.vertices[after].position_m - line.vertices[before].position_m).head<2>().normalized();
  const double right = line.side == EdgeSide::left ? 1.0 : -1.0;
  return {right * along.y(), -right * along.x()};
}

double length_m(const EdgeLine& line) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < line.vertices.size(); ++i) {
    sum_m += (line.vertices[i].position_m - line.vertices[i - 1].position_m).head<2>().norm();
  }
  return sum_m;
}

class Rows {
 public:
  explicit Rows(const std::vector<EdgeLine>& lines) : lines_(lines), cells_(kRowCell_m) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lengths_m_.push_back(length_m(lines[i]));
      add(i);
    }
  }

  [[nodiscard]] bool is_behind(std::size_t line) const {
    std::size_t behind = 0;
    for (std::size_t i = 0; i < lines_[line].vertices.size(); ++i) {
      behind += is_behind(line, i) ? 1U : 0U;
    }
    return static_cast<double>(behind) > kMost * static_cast<double>(lines_[line].vertices.size());
  }

 private:
  void add(std::size_t line) {
    const std::vector<EdgeLine::Vertex>& vertices = lines_[line].vertices;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const Eigen::Vector3d along_m = vertices[i + 1].position_m - vertices[i].position_m;
      const auto steps = static_cast<std::size_t>(std::ceil(along_m.head<2>().norm() / kRowStep_m));
      for (std::size_t k = 0; k < steps; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(steps);
        const Eigen::Vector3d place_m = vertices[i].position_m + share * along_m;
        if (const auto key = cell(place_m.head<2>())) {
          cells_.at_or_new(*key).push_back({line, place_m.z(), to_road(lines_[line], i)});
        }
      }
    }
  }

  [[nodiscard]] std::optional<VoxelKey> cell(const Eigen::Vector2d& place_m) const {
    return cells_.key_of({place_m.x(), place_m.y(), 0.5 * kRowCell_m});
  }

  /// The first other line on the way to the road decides.
  [[nodiscard]] bool is_behind(std::size_t line, std::size_t vertex) const {
    const Eigen::Vector3d& from_m = lines_[line].vertices[vertex].position_m;
    const Eigen::Vector2d way = to_road(lines_[line], vertex);
    for (double ahead_m = kFrom_m; ahead_m < kLook_m; ahead_m += kRowStep_m) {
      const auto key = cell(from_m.head<2>() + ahead_m * way);
      const auto* facings = key ? cells_.find(*key) : nullptr;
      if (facings == nullptr) {
        continue;
      }
      for (const Facing& facing : *facings) {
        if (facing.line != line && std::abs(facing.z_m - from_m.z()) < kSameFloor_m) {
          return facing.to_road.dot(way) > kSameWay && lengths_m_[facing.line] > lengths_m_[line];
        }
      }
    }
    return false;
  }

  const std::vector<EdgeLine>& lines_;
  std::vector<double> lengths_m_;
  VoxelHash<std::vector<Facing>> cells_;
};

}  // namespace

void drop_rows_behind(std::vector<EdgeLine>& lines) {
  const Rows rows(lines);
  std::vector<bool> is_behind;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    is_behind.push_back(rows.is_behind(i));
  }
  std::vector<EdgeLine> kept;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_behind[i]) {
      kept.push_back(std::move(lines[i]));
    }
  }
  lines = std::move(kept);
}

}  // namespace berm
