#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beams.hpp"
#include "berm/io/recording_info.hpp"
#include "firing_order.hpp"
#include "histogram.hpp"
#include "oddities.hpp"

namespace berm {

/// Gathers what the scans of a recording show, one scan after the other.
class Inspector {
 public:
  explicit Inspector(const Recording& recording);

  /// Reads scan `index`; a broken one is counted.
  void add(std::size_t index);
  [[nodiscard]] RecordingInfo finish();

 private:
  /// What the first of some alike scans shows of its sensor.
  struct SensorVote {
    std::string first_scan;
    std::size_t scans = 0;
    FiringOrder order = FiringOrder::unknown;
    int lines = 1;
    double turns = 0.0;
    std::optional<RingCount> rings;
    FieldOfView view;
    SensorGuess guess;
  };

  void add_record(std::size_t index);
  [[nodiscard]] PointsView view() const;
  void add_counts(const PointCounts& counts);
  void add_values(const std::vector<Beam>& beams);
  void add_time();
  void add_sensor(const std::string& scan, const std::vector<Beam>& beams);
  void add_labels(const ScanEntry& entry);
  void finish_stamps();
  void finish_shares();
  void finish_sensor();
  void finish_poses();
  void odd(std::string sentence);

  const Recording& recording_;
  RecordingInfo info_;
  ScanRecord record_;
  std::vector<double> points_per_scan_;
  std::vector<Stamp> stamps_ns_;
  std::vector<double> time_spans_s_;
  std::map<std::string, SensorVote> votes_;  ///< by the name of the guess: a handful, however many scans
  std::map<std::uint32_t, std::uint64_t> classes_;
  PointCounts counts_;
  double repeated_points_ = 0.0;
  OddCounts odd_counts_;
  std::size_t stamps_back_ = 0;
  Histogram range_m_{0.01, 1000.0};
  Histogram intensity_{1.0, 65536.0};
};

}  // namespace berm
