#include "berm/map/beam_image.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace berm {
namespace {

/// Bins of 1 deg: azimuth all around, elevation from -60 to 60 deg, where bins are still about as wide as high.
constexpr std::size_t kColumns = 360;
constexpr std::size_t kRows = 120;
constexpr double kMiddleRow = 60.0;
constexpr double kBinsPerRad = 180.0 / std::numbers::pi;

struct Bin {
  std::size_t row = 0;
  std::size_t column = 0;
};

std::optional<Bin> bin_of(const Eigen::Vector3f& to_m) {
  const double level_m = std::hypot(double{to_m.x()}, double{to_m.y()});
  const double row = std::floor(std::atan2(double{to_m.z()}, level_m) * kBinsPerRad) + kMiddleRow;
  if (!(row >= 0.0 && row < static_cast<double>(kRows))) {
    return std::nullopt;
  }
  const double column = std::floor((std::atan2(double{to_m.y()}, double{to_m.x()}) + std::numbers::pi) * kBinsPerRad);
  return Bin{static_cast<std::size_t>(row), static_cast<std::size_t>(std::max(column, 0.0)) % kColumns};
}

}  // namespace

void BeamImage::set(const Eigen::Vector3d& origin_m, std::span<const Eigen::Vector3d> ends_m) {
  origin_m_ = origin_m;
  unsorted_.clear();
  bins_.clear();
  begins_.assign(kRows * kColumns + 1, 0);
  const std::size_t step = std::max<std::size_t>(1, (ends_m.size() + kMostBeams - 1) / kMostBeams);
  for (std::size_t i = 0; i < ends_m.size(); i += step) {
    const Eigen::Vector3f to_m = (ends_m[i] - origin_m).cast<float>();
    const float range_m = to_m.norm();
    if (!std::isfinite(range_m) || range_m <= 0.0F) {
      continue;
    }
    if (const auto bin = bin_of(to_m)) {
      unsorted_.push_back({to_m / range_m, range_m});
      bins_.push_back(static_cast<std::uint32_t>(bin->row * kColumns + bin->column));
      ++begins_[bins_.back() + 1];
    }
  }
  for (std::size_t bin = 1; bin < begins_.size(); ++bin) {
    begins_[bin] += begins_[bin - 1];
  }
  beams_.resize(unsorted_.size());
  // Filled from the end of each bin, which leaves `begins_` one bin late; put right below.
  for (std::size_t i = 0; i < unsorted_.size(); ++i) {
    beams_[begins_[bins_[i]]++] = unsorted_[i];
  }
  std::copy_backward(begins_.begin(), begins_.end() - 1, begins_.end());
  begins_.front() = 0;
}

bool BeamImage::sees_through(const Eigen::Vector3d& place_m, double tolerance_m, double beyond_m) const {
  const Eigen::Vector3f to_m = (place_m - origin_m_).cast<float>();
  const auto bin = beams_.empty() ? std::nullopt : bin_of(to_m);
  if (!bin) {
    return false;
  }
  const auto tolerance = static_cast<float>(tolerance_m);
  const float least_range_m = to_m.norm() + static_cast<float>(beyond_m);
  const std::size_t last_row = std::min(bin->row + 1, kRows - 1);
  for (std::size_t row = bin->row == 0 ? 0 : bin->row - 1; row <= last_row; ++row) {
    for (const std::size_t column : {bin->column + kColumns - 1, bin->column, bin->column + 1}) {
      if (passes(row, column % kColumns, to_m, tolerance, least_range_m)) {
        return true;
      }
    }
  }
  return false;
}

bool BeamImage::passes(std::size_t row, std::size_t column, const Eigen::Vector3f& to_place_m, float tolerance_m,
                       float least_range_m) const {
  const std::size_t bin = row * kColumns + column;
  for (std::uint32_t i = begins_[bin]; i < begins_[bin + 1]; ++i) {
    const Beam& beam = beams_[i];
    if (beam.range_m >= least_range_m &&
        (to_place_m - to_place_m.dot(beam.direction) * beam.direction).squaredNorm() < tolerance_m * tolerance_m) {
      return true;
    }
  }
  return false;
}

}  // namespace berm
