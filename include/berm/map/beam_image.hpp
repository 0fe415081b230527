#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace berm {

/// Beams that left one place, by their direction: tells which places were looked through. Keeps its memory.
class BeamImage {
 public:
  /// More beams are thinned evenly.
  static constexpr std::size_t kMostBeams = 20'000;

  /// `ends_m`: what the beams met. Ends that are not finite, and beams within 30 deg of the vertical, tell nothing.
  void set(const Eigen::Vector3d& origin_m, std::span<const Eigen::Vector3d> ends_m);

  [[nodiscard]] const Eigen::Vector3d& origin_m() const { return origin_m_; }
  [[nodiscard]] bool empty() const { return beams_.empty(); }

  /// Whether a beam passed `place_m` by less than `tolerance_m` and went on for `beyond_m` at least. Beams that pass at
  /// more than about 1 deg are not looked at.
  [[nodiscard]] bool sees_through(const Eigen::Vector3d& place_m, double tolerance_m, double beyond_m) const;

 private:
  struct Beam {
    Eigen::Vector3f direction;  ///< length 1
    float range_m = 0.0F;
  };

  [[nodiscard]] bool passes(std::size_t row, std::size_t column, const Eigen::Vector3f& to_place_m, float tolerance_m,
                            float least_range_m) const;

  Eigen::Vector3d origin_m_ = Eigen::Vector3d::Zero();
  std::vector<Beam> beams_;            ///< by bin
  std::vector<std::uint32_t> begins_;  ///< of each bin in `beams_`, and the end of the last
  // Scratch of set.
  std::vector<Beam> unsorted_;
  std::vector<std::uint32_t> bins_;
};

}  // namespace berm
