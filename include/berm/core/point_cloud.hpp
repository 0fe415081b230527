#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/label.hpp"

namespace berm {

/// A cloud as read-only spans, one per channel: what algorithms take. An absent channel is empty, never zeros;
/// every other has length `size()`. Valid as long as the owner of the memory.
struct PointsView {
  std::span<const float> x;             ///< m
  std::span<const float> y;             ///< m
  std::span<const float> z;             ///< m
  std::span<const float> intensity;     ///< 0..255, calibrated reflectivity where the sensor gives it
  std::span<const float> time;          ///< s since the stamp of the scan
  std::span<const std::uint16_t> ring;  ///< index of the laser, from the lowest
  std::span<const Label> label;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
};

/// The channels of a cloud that is being built.
struct PointChannels {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> intensity;
  std::vector<float> time;
  std::vector<std::uint16_t> ring;
  std::vector<Label> label;

  /// Empties every channel and keeps the memory.
  void clear();
};

/// Points in firing order as a structure of arrays, in the frame of the sensor. Beams without a return stay in.
class PointCloud {
 public:
  PointCloud() = default;

  /// Takes the channels over. Throws Error(invalid_argument) unless x, y and z have one length N and every other
  /// channel has length N or 0.
  explicit PointCloud(PointChannels channels);

  [[nodiscard]] std::size_t size() const { return channels_.x.size(); }
  [[nodiscard]] bool empty() const { return channels_.x.empty(); }
  [[nodiscard]] PointsView view() const;

  /// Gives the channels back, so that a reader can fill the same memory with the next scan.
  [[nodiscard]] PointChannels release() &&;

 private:
  PointChannels channels_;
};

/// Whether a beam met nothing: drivers send (0, 0, 0) (Livox) or +-Inf (REP-117).
[[nodiscard]] bool is_no_return(float x, float y, float z);

}  // namespace berm
