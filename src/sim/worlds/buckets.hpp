#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "berm/geometry/grid2d.hpp"

namespace berm::sim {

/// Round things in the plane (`x_m`, `y_m`, `reach_m`), found by place.
template <typename Item>
class Buckets {
 public:
  Buckets() = default;
  explicit Buckets(std::vector<Item> items, double cell_m = 4.0) : items_(std::move(items)) {
    if (items_.empty()) {
      return;
    }
    std::array<double, 4> box{items_[0].x_m, items_[0].y_m, items_[0].x_m, items_[0].y_m};
    for (const Item& item : items_) {
      box = {std::min(box[0], item.x_m - item.reach_m), std::min(box[1], item.y_m - item.reach_m),
             std::max(box[2], item.x_m + item.reach_m), std::max(box[3], item.y_m + item.reach_m)};
    }
    cells_ = Grid2D<std::array<std::uint32_t, 2>>({.origin_x_m = box[0],
                                                   .origin_y_m = box[1],
                                                   .cell_m = cell_m,
                                                   .columns = static_cast<int>((box[2] - box[0]) / cell_m) + 1,
                                                   .rows = static_cast<int>((box[3] - box[1]) / cell_m) + 1});
    fill();
  }

  [[nodiscard]] const std::vector<Item>& items() const { return items_; }

  /// Calls `visit` for all items that can reach a place, in their order.
  template <typename Visit>
  void visit_at(double x_m, double y_m, Visit&& visit) const {
    if (const auto* range = cells_.find_at(x_m, y_m)) {
      for (std::uint32_t k = (*range)[0]; k < (*range)[1]; ++k) {
        visit(items_[indices_[k]]);
      }
    }
  }

 private:
  template <typename Visit>
  void visit_cells(const Item& item, Visit&& visit) {
    const GridShape& shape = cells_.shape();
    const auto column = [&](double x) { return static_cast<int>((x - shape.origin_x_m) / shape.cell_m); };
    const auto row = [&](double y) { return static_cast<int>((y - shape.origin_y_m) / shape.cell_m); };
    for (int r = row(item.y_m - item.reach_m); r <= row(item.y_m + item.reach_m); ++r) {
      for (int c = column(item.x_m - item.reach_m); c <= column(item.x_m + item.reach_m); ++c) {
        visit(*cells_.find(GridIndex{c, r}));
      }
    }
  }

  void fill() {
    for (const Item& item : items_) {
      visit_cells(item, [](auto& cell) { ++cell[1]; });
    }
    std::uint32_t sum = 0;
    for (auto& cell : cells_.cells()) {
      const std::uint32_t count = cell[1];
      cell = {sum, sum};
      sum += count;
    }
    indices_.resize(sum);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      visit_cells(items_[i], [&](auto& cell) { indices_[cell[1]++] = static_cast<std::uint32_t>(i); });
    }
  }

  std::vector<Item> items_;
  Grid2D<std::array<std::uint32_t, 2>> cells_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace berm::sim
