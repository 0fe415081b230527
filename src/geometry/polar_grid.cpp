#include "berm/geometry/polar_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr double kPi = 3.14159265358979323846;

[[noreturn]] void refuse(const std::string& problem) {
  throw Error(ErrorCode::invalid_argument, "polar grid: " + problem);
}

void check_count(const char* what, std::size_t count) {
  if (count < 1 || count > PolarGrid::kMaxCount) {
    refuse(std::to_string(count) + " " + what + ", expected 1 to " + std::to_string(PolarGrid::kMaxCount));
  }
}

std::vector<double> uniform_edges(int bins, double min_range_m, double max_range_m) {
  check_count("bins", static_cast<std::size_t>(std::max(bins, 0)));
  std::vector<double> edges_m;
  edges_m.reserve(static_cast<std::size_t>(bins) + 1);
  const double width_m = (max_range_m - min_range_m) / bins;
  for (int bin = 0; bin < bins; ++bin) {
    edges_m.push_back(min_range_m + bin * width_m);
  }
  edges_m.push_back(max_range_m);
  return edges_m;
}

}  // namespace

PolarGrid::PolarGrid(int sectors, int bins, double min_range_m, double max_range_m)
    : PolarGrid(sectors, uniform_edges(bins, min_range_m, max_range_m)) {
  uniform_width_m_ = (max_range_m - min_range_m) / bins;
}

PolarGrid::PolarGrid(int sectors, std::vector<double> edges_m) : sectors_(sectors), edges_m_(std::move(edges_m)) {
  check_count("sectors", static_cast<std::size_t>(std::max(sectors, 0)));
  check_count("bins", std::max<std::size_t>(edges_m_.size(), 1) - 1);
  double last_m = -1.0;
  for (const double edge_m : edges_m_) {
    // Negated, so that NaN is refused as well.
    if (!(std::isfinite(edge_m) && edge_m >= 0.0 && edge_m > last_m)) {
      refuse("edge " + std::to_string(edge_m) + " m, expected finite, not negative and strictly increasing ones");
    }
    last_m = edge_m;
  }
}

std::optional<int> PolarGrid::sector_of(double azimuth_rad) const {
  // pi as a float is larger than pi as a double.
  const double turn = (azimuth_rad + kPi) / (2.0 * kPi);
  constexpr double kSlack = 1e-7;
  if (!(turn >= -kSlack && turn <= 1.0 + kSlack)) {
    return std::nullopt;
  }
  const int sector = static_cast<int>(std::floor(std::max(turn, 0.0) * sectors_));
  return sector % sectors_;
}

std::optional<int> PolarGrid::bin_of(double range_m) const {
  if (!(range_m >= edges_m_.front() && range_m < edges_m_.back())) {
    return std::nullopt;
  }
  if (uniform_width_m_ > 0.0) {
    // By the formula of G; the division may round up to the end.
    return std::min(static_cast<int>((range_m - edges_m_.front()) / uniform_width_m_), bins() - 1);
  }
  const auto above = std::upper_bound(edges_m_.begin(), edges_m_.end(), range_m);
  return static_cast<int>(above - edges_m_.begin()) - 1;
}

std::optional<PolarCell> PolarGrid::cell_of(double x_m, double y_m) const {
  const std::optional<int> bin = bin_of(std::hypot(x_m, y_m));
  if (!bin) {
    return std::nullopt;
  }
  const std::optional<int> sector = sector_of(std::atan2(y_m, x_m));
  if (!sector) {
    return std::nullopt;
  }
  return PolarCell{*sector, *bin};
}

double PolarGrid::center_azimuth_rad(int sector) const {
  return (sector + 0.5) * (2.0 * kPi / sectors_) - kPi;
}

double PolarGrid::center_range_m(int bin) const {
  const auto i = static_cast<std::size_t>(bin);
  return 0.5 * (edges_m_[i] + edges_m_[i + 1]);
}

}  // namespace berm
