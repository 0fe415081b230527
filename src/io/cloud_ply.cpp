#include <cmath>

#include "cloud_files.hpp"
#include "record_bytes.hpp"

namespace berm {
namespace {

/// Floats have steps of at most half a millimetre up to here.
constexpr double kFloatReach_m = 8192.0;

class PlyWriter final : public RecordCloudWriter {
 public:
  PlyWriter(const std::filesystem::path& path, const CloudSummary& summary, const LabelColors& colors)
      : RecordCloudWriter(path, summary),
        colors_(colors),
        doubles_(std::max(summary.min_m.cwiseAbs().maxCoeff(), summary.max_m.cwiseAbs().maxCoeff()) > kFloatReach_m) {
    const std::string type = doubles_ ? "double" : "float";
    std::string head =
        "ply\nformat binary_little_endian 1.0\ncomment berm: label 0 unlabeled, 2 falling snow, 3 drivable, 4 terrain, "
        "5 "
        "obstacle\nelement vertex " +
        std::to_string(summary.points) + "\n";
    for (const char* axis : {"x", "y", "z"}) {
      head += "property " + type + " " + axis + "\n";
    }
    head += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    head += "property float intensity\nproperty uchar label\nend_header\n";
    write(head);
  }

 private:
  void append(std::string& bytes, const CloudPoint& point) const override {
    for (const double coordinate_m : point.position_m) {
      if (doubles_) {
        append_number(bytes, coordinate_m);
      } else {
        append_number(bytes, static_cast<float>(coordinate_m));
      }
    }
    for (const std::uint8_t channel : colors_[static_cast<std::size_t>(point.label)]) {
      append_number(bytes, channel);
    }
    append_number(bytes, point.intensity);
    append_number(bytes, static_cast<std::uint8_t>(point.label));
  }

  LabelColors colors_;
  bool doubles_;
};

}  // namespace

std::unique_ptr<CloudWriter> make_ply_writer(const std::filesystem::path& path, const CloudSummary& summary,
                                             const LabelColors& colors) {
  return std::make_unique<PlyWriter>(path, summary, colors);
}

}  // namespace berm
