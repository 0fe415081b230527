#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "berm/io/scan_record.hpp"
#include "pcd_header.hpp"
#include "pcd_plan.hpp"

namespace berm {

/// Where values of one field lie in memory, point after point.
struct PcdColumn {
  const std::byte* first = nullptr;
  std::size_t stride_bytes = 0;
};

/// Turns values in the types of the file into the channels of a record, block by block.
class PcdDecoder {
 public:
  /// Takes the memory for all points of `header`, which must have been checked against the bytes present.
  PcdDecoder(const PcdHeader& header, const PcdPlan& plan, const std::string& name, PointChannels reuse);

  /// Memory that the constructor takes for each point.
  [[nodiscard]] static std::size_t bytes_per_point(const PcdPlan& plan);

  /// Decodes points [begin, begin + count); `columns` has one entry per channel of the plan.
  void decode(std::span<const PcdColumn> columns, std::size_t begin, std::size_t count);

  /// Checks and normalises what needs all points; to be called once, at the end. Throws FileError(unsupported) for
  /// time that spans more than a scan.
  [[nodiscard]] ScanRecord finish();

 private:
  [[nodiscard]] std::vector<float>* float_channel(PcdChannel channel);
  void decode_time(const PcdField& field, const PcdColumn& column, std::size_t begin, std::size_t count);
  void finish_whole_numbers();

  const PcdHeader& header_;
  const PcdPlan& plan_;
  const std::string& name_;
  ScanRecord record_;
  std::vector<std::int64_t> stamps_ns_;  ///< absolute time, until `finish`
  bool seconds_were_ns_ = false;
  std::size_t bad_rings_ = 0;
  std::size_t other_labels_ = 0;
};

}  // namespace berm
