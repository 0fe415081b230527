#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace berm {

/// Finds the line nearest to a place, within a radius, horizontally.
class LineIndex {
 public:
  explicit LineIndex(double radius_m) : radius_m_(radius_m) {}

  /// Adds the stretch between two places of line `line`. After the last one, `finish`.
  void add(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, std::uint32_t line);
  void finish();

  struct Nearest {
    double distance_m = 0.0;
    std::uint32_t line = 0;
  };
  /// None farther than the radius; of lines equally near the first.
  [[nodiscard]] std::optional<Nearest> nearest(const Eigen::Vector2d& place_m) const;

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend auto operator<=>(const Cell&, const Cell&) = default;
  };
  struct Piece {
    Cell cell;
    std::uint32_t line = 0;
    Eigen::Vector2d from_m;
    Eigen::Vector2d to_m;
  };

  [[nodiscard]] Cell cell_of(const Eigen::Vector2d& place_m) const;

  double radius_m_;
  std::vector<Piece> pieces_;  // by cell, each in the cell of its middle
};

}  // namespace berm
