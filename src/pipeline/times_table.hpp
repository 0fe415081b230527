#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "berm/core/stamp.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "stage_times.hpp"

namespace berm {

/// What one scan cost, part by part; nothing for what was not done.
struct ScanTimes {
  StageTime read;
  std::array<std::optional<StageTime>, kStages> stages;
  std::optional<StageTime> odometry;
  std::optional<StageTime> map;
  StageTime write;
};

/// times.csv: one line per labelled scan, milliseconds by the clock. The one table that differs from run to run.
class TimesTable {
 public:
  explicit TimesTable(const std::filesystem::path& path);
  void add(const std::string& name, Stamp stamp_ns, const ScanTimes& times);
  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
};

}  // namespace berm
