#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "berm/io/recording.hpp"

namespace berm {

/// How the direction of the beam moves from point to point.
enum class FiringOrder : std::uint8_t {
  unknown,        ///< too few points to tell
  column_wise,    ///< spinning, all lasers of one azimuth after the other
  ring_wise,      ///< spinning, all azimuths of one laser after the other
  non_repeating,  ///< prisms or mirrors: rosette, Lissajous figure; neighbours in the list are neighbours in the world
  unordered,      ///< neighbours in the list lie anywhere: sorted, shuffled or thinned afterwards
};
[[nodiscard]] std::string_view to_string(FiringOrder order);

/// Smallest, middle and largest of some values, and their 95th percentile.
struct Spread {
  double min = 0.0;
  double median = 0.0;
  double p95 = 0.0;
  double max = 0.0;
};

/// Where the beams go, seen from the origin of the sensor. Without the outermost 0.1 % on each side.
struct FieldOfView {
  double azimuth_min_rad = 0.0;
  double azimuth_max_rad = 0.0;
  double elevation_min_rad = 0.0;
  double elevation_max_rad = 0.0;
  bool full_turn = false;  ///< beams in all directions; the azimuths above then mean nothing
  bool circular = false;   ///< a cone about the boresight, not a rectangle
};

/// Points with identical coordinates other than (0, 0, 0): a no-return that was moved into another frame.
struct RepeatedPoint {
  std::array<float, 3> position_m{};
  double share = 0.0;  ///< of all points
};

struct RingCount {
  int count = 0;
  bool from_field = false;  ///< otherwise estimated from azimuths or elevations
};

/// What the sensor may be; `name` is "unknown" where nothing fits.
struct SensorGuess {
  std::string name = "unknown";
  std::vector<std::string> reasons;  ///< what speaks for it, a few words each
};

/// Points per class of the truth labels.
struct ClassCount {
  std::uint32_t id = 0;  ///< SemanticKITTI
  std::uint64_t points = 0;
};

/// Poses that a recording brings along.
struct PosesInfo {
  std::string file;
  PoseOf of = PoseOf::base;
  std::size_t count = 0;
  double length_m = 0.0;
};

/// What `berm info` shows. Shares are of all points of the scans that were read.
struct RecordingInfo {
  std::string path;
  RecordingLayout layout = RecordingLayout::single_file;
  std::size_t scans = 0;         ///< in the recording
  std::size_t scans_read = 0;    ///< looked into
  std::size_t scans_failed = 0;  ///< tried and not readable
  std::uint64_t bytes = 0;       ///< of the scan files that were read
  StampSource stamp_source = StampSource::assumed_rate;
  std::optional<double> duration_s;  ///< from the start of the first scan to the start of the last; two scans at least
  std::optional<double> rate_hz;     ///< from the median distance of the stamps
  double longest_step_s = 0.0;       ///< between the stamps of scans that follow each other
  std::uint64_t points = 0;
  Spread points_per_scan;
  std::vector<std::string> fields;    ///< as the first file spells them
  std::vector<std::string> reading;   ///< what was chosen in reading the first file, one sentence each
  std::vector<std::string> channels;  ///< what berm takes from them: "xyz", "intensity", "time", "ring", "label"
  std::optional<Spread> range_m;      ///< of real returns
  std::optional<Spread> intensity;    ///< of real returns
  std::optional<double> time_span_s;  ///< from the first to the last point of a scan, median over the scans
  double no_return_zero_share = 0.0;  ///< (0, 0, 0)
  double no_return_inf_share = 0.0;
  double nan_share = 0.0;
  double duplicate_share = 0.0;  ///< real returns at the very place of another of the same scan
  std::optional<RepeatedPoint> repeated_point;
  FiringOrder order = FiringOrder::unknown;
  int interleaved_lines = 1;    ///< non_repeating: lasers that take turns
  double turns_per_scan = 0.0;  ///< how far the azimuth turns from the first to the last point
  std::optional<RingCount> rings;
  std::optional<FieldOfView> field_of_view;
  SensorGuess sensor;
  SensorSheet sheet;
  std::size_t labelled_scans = 0;
  std::vector<ClassCount> truth_classes;  ///< by id
  std::optional<PosesInfo> given_poses;
  std::optional<PosesInfo> truth_poses;
  std::vector<std::string> odd;  ///< one sentence each
};

/// Which scans to look into, and whom to tell how many of them are done.
struct InspectOptions {
  std::size_t first = 0;
  std::optional<std::size_t> count;                                 ///< all from `first` on
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< may be empty
};

/// Looks into a recording scan by scan; memory does not grow with it. Broken scans, labels and poses are counted and
/// named in `odd`, not thrown. Throws Error(invalid_argument) if `first` lies behind the last scan.
[[nodiscard]] RecordingInfo inspect(const Recording& recording, const InspectOptions& options = {});

}  // namespace berm
