#include <algorithm>
#include <cmath>
#include <limits>

#include "berm/core/error.hpp"
#include "berm/core/version.hpp"
#include "cloud_files.hpp"
#include "record_bytes.hpp"

namespace berm {
namespace {

// LAS 1.4 R15 (ASPRS), tables 3 (header) and 15, 16 (point formats 6 and 7).
constexpr std::uint16_t kHeaderBytes = 375;
constexpr std::uint8_t kPointFormat = 7;  ///< GPS time and colour
constexpr std::uint16_t kPointBytes = 36;
constexpr double kScale_m = 1e-3;
/// "The coordinate system is WKT": point formats from 6 on know no other, even if none is given.
constexpr std::uint16_t kGlobalEncoding = 1U << 4U;

/// Standard classes where there is one; 64 and above are free for users.
std::uint8_t las_class(Label label) {
  switch (label) {
    case Label::drivable:
      return 11;  // road surface
    case Label::terrain:
      return 2;  // ground
    case Label::obstacle:
      return 64;
    case Label::falling_snow:
      return 18;  // high noise
    case Label::unlabeled:
    case Label::no_return:
      break;
  }
  return 1;  // processed, but unclassified
}

std::string padded(std::string text, std::size_t bytes) {
  text.resize(bytes, '\0');
  return text;
}

class LasWriter final : public RecordCloudWriter {
 public:
  LasWriter(const std::filesystem::path& path, const CloudSummary& summary, const LabelColors& colors)
      : RecordCloudWriter(path, summary),
        colors_(colors),
        offset_m_((0.5 * (summary.min_m + summary.max_m)).array().round()) {
    const double reach_m = (summary.max_m - summary.min_m).maxCoeff();
    if (reach_m > kScale_m * std::numeric_limits<std::int32_t>::max()) {
      throw Error(ErrorCode::invalid_argument,
                  path.string() + ": the points span " + std::to_string(reach_m) + " m; did a pose jump?");
    }
    write(make_header());
  }

 private:
  [[nodiscard]] std::string make_header() const {
    std::string head = "LASF";
    append_number(head, std::uint16_t{0});  // file source
    append_number(head, kGlobalEncoding);
    head += std::string(16, '\0');  // project
    append_number(head, std::uint8_t{1});
    append_number(head, std::uint8_t{4});
    head += padded("berm", 32);
    head += padded("berm " + std::string(version()), 32);
    append_number(head, std::uint16_t{0});  // day and year: the same run gives the same bytes
    append_number(head, std::uint16_t{0});
    append_number(head, kHeaderBytes);
    append_number(head, std::uint32_t{kHeaderBytes});  // where points begin
    append_number(head, std::uint32_t{0});             // variable length records
    append_number(head, kPointFormat);
    append_number(head, kPointBytes);
    head += std::string(24, '\0');  // counts of old formats
    for (int axis = 0; axis < 3; ++axis) {
      append_number(head, kScale_m);
    }
    for (const double value_m : offset_m_) {
      append_number(head, value_m);
    }
    for (int axis = 0; axis < 3; ++axis) {
      append_number(head, rounded_m(summary().max_m[axis], axis));
      append_number(head, rounded_m(summary().min_m[axis], axis));
    }
    head += std::string(20, '\0');  // waveforms, extended records
    append_number(head, summary().points);
    append_number(head, summary().points);  // first returns: all
    head += std::string(112, '\0');         // other returns: none
    return head;
  }

  [[nodiscard]] std::int32_t steps(double value_m, int axis) const {
    return static_cast<std::int32_t>(std::lround((value_m - offset_m_[axis]) / kScale_m));
  }
  [[nodiscard]] double rounded_m(double value_m, int axis) const {
    return offset_m_[axis] + kScale_m * steps(value_m, axis);
  }

  void append(std::string& bytes, const CloudPoint& point) const override {
    for (int axis = 0; axis < 3; ++axis) {
      append_number(bytes, steps(point.position_m[axis], axis));
    }
    // LAS wants the whole range of 16 bits.
    const auto intensity = std::lround(257.0F * std::clamp(point.intensity, 0.0F, 255.0F));
    append_number(bytes, static_cast<std::uint16_t>(intensity));
    append_number(bytes, std::uint8_t{0x11});  // return 1 of 1
    append_number(bytes, std::uint8_t{0});     // flags
    append_number(bytes, las_class(point.label));
    append_number(bytes, static_cast<std::uint8_t>(point.label));  // user data
    append_number(bytes, std::int16_t{0});                         // scan angle
    append_number(bytes, std::uint16_t{0});                        // point source
    append_number(bytes, point.time_s);
    for (const std::uint8_t channel : colors_[static_cast<std::size_t>(point.label)]) {
      append_number(bytes, static_cast<std::uint16_t>(257 * channel));
    }
  }

  LabelColors colors_;
  Eigen::Vector3d offset_m_;
};

}  // namespace

std::unique_ptr<CloudWriter> make_las_writer(const std::filesystem::path& path, const CloudSummary& summary,
                                             const LabelColors& colors) {
  return std::make_unique<LasWriter>(path, summary, colors);
}

}  // namespace berm
