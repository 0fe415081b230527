#include "berm/pipeline/sensor_sheet.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"

namespace berm {
namespace {

class Adoption {
 public:
  explicit Adoption(const std::set<std::string>& pinned) : pinned_(pinned) {}

  void take(const std::string& key, double& value, const std::optional<double>& from_sheet) {
    if (!from_sheet || *from_sheet == value) {
      return;
    }
    if (pinned_.contains(key)) {
      notes_.push_back(fmt::format("{} = {} as set, although sequence.json says {}", key, value, *from_sheet));
      return;
    }
    notes_.push_back(fmt::format("{} = {} from sequence.json instead of the machine's {}", key, *from_sheet, value));
    value = *from_sheet;
  }

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  const std::set<std::string>& pinned_;
  std::vector<std::string> notes_;
};

/// In degrees, rid of the last digits that the way through radians left.
std::optional<double> to_deg(const std::optional<double>& angle_rad) {
  if (!angle_rad) {
    return std::nullopt;
  }
  return std::round(*angle_rad * kDegPerRad * 1e9) / 1e9;
}

}  // namespace

std::vector<std::string> adopt_sheet(Machine& machine, const SensorSheet& sheet, const std::set<std::string>& pinned) {
  Adoption adoption(pinned);
  adoption.take("mount.height_m", machine.mount.height_m, sheet.height_m);
  adoption.take("mount.pitch_deg", machine.mount.pitch_deg, to_deg(sheet.pitch_rad));
  adoption.take("mount.roll_deg", machine.mount.roll_deg, to_deg(sheet.roll_rad));
  adoption.take("mount.yaw_deg", machine.mount.yaw_deg, to_deg(sheet.yaw_rad));
  adoption.take("sensor.scan_hz", machine.sensor.scan_hz, sheet.scan_hz);
  try {
    machine.check();
  } catch (const ConfigError& error) {
    throw ConfigError("sequence.json of the recording", error.key(), error.problem());
  }
  return adoption.notes();
}

}  // namespace berm
