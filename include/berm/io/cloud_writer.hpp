#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "berm/core/label.hpp"

namespace berm {

/// A point as other programs take it.
struct CloudPoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  float intensity = 0.0F;  ///< 0..255
  Label label = Label::unlabeled;
  double time_s = 0.0;  ///< of the recording's clock; 0 where it means nothing
};

/// What a file says of its points before the first of them.
struct CloudSummary {
  std::uint64_t points = 0;
  Eigen::Vector3d min_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d max_m = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& position_m);
};

/// A file of points that appears whole or not at all. Same points, same bytes.
class CloudWriter {
 public:
  CloudWriter() = default;
  CloudWriter(const CloudWriter&) = delete;
  CloudWriter& operator=(const CloudWriter&) = delete;
  virtual ~CloudWriter() = default;

  /// Positions must be finite and within the summary. Throws FileError(write_failed) as AtomicFile.
  virtual void add(std::span<const CloudPoint> points) = 0;
  /// Publishes the file. Throws Error(invalid_argument) unless as many points came as the summary says.
  virtual void commit() = 0;
};

enum class CloudFormat : std::uint8_t {
  ply,  ///< binary; float, or double where floats are too coarse; colour, intensity, label
  las,  ///< LAS 1.4, point format 7, millimetres
  csv,  ///< x,y,z,intensity,label,time
};

using LabelColors = std::array<std::array<std::uint8_t, 3>, 6>;  ///< by Label

/// Begins a file. `colors` are those of PLY and LAS. Throws FileError(write_failed) as AtomicFile,
/// Error(invalid_argument) for a LAS file that spans more than 2,000 km.
[[nodiscard]] std::unique_ptr<CloudWriter> make_cloud_writer(CloudFormat format, const std::filesystem::path& path,
                                                             const CloudSummary& summary, const LabelColors& colors);

}  // namespace berm
