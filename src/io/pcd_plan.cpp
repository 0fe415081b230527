#include "pcd_plan.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "line_reader.hpp"
#include "lower_case.hpp"

namespace berm {
namespace {

/// The names that drivers use. The first match counts: where a file has several, absolute time says more than
/// relative time.
struct TimeName {
  std::string_view name;
  std::string_view types;  ///< of which a field of this name is understood, each followed by a blank
  PcdTimeUnit unit;
};
constexpr std::array<TimeName, 9> kTimeNames = {{
    {"timestamp", "F8 ", PcdTimeUnit::absolute_s},  // Hesai, RoboSense; Livox driver 2: ns, told by the size
    {"timestamp", "U8 I8 ", PcdTimeUnit::absolute_ns},
    {"timestamp", "F4 ", PcdTimeUnit::relative_s},    // absolute seconds do not fit into 24 bits
    {"time_stamp", "U4 ", PcdTimeUnit::relative_ns},  // Autoware PointXYZIRCAEDT
    {"t", "U4 I4 U8 I8 ", PcdTimeUnit::relative_ns},  // Ouster
    {"t", "F4 F8 ", PcdTimeUnit::relative_s},
    {"offset_time", "U4 I4 U8 I8 ", PcdTimeUnit::relative_ns},  // Livox
    {"time", "F4 F8 ", PcdTimeUnit::relative_s},                // Velodyne, berm
    {"time_offset", "F4 F8 ", PcdTimeUnit::relative_s},
}};

const char* unit_name(PcdTimeUnit unit) {
  switch (unit) {
    case PcdTimeUnit::relative_s:
      return "s since the stamp of the scan";
    case PcdTimeUnit::relative_ns:
      return "ns since the stamp of the scan";
    case PcdTimeUnit::absolute_s:
      return "absolute s";
    case PcdTimeUnit::absolute_ns:
      break;
  }
  return "absolute ns";
}

class Planner {
 public:
  Planner(const PcdHeader& header, const std::string& name) : header_(header), name_(name) {}

  PcdPlan plan() {
    add_coordinates();
    add_first(PcdChannel::intensity, {"reflectivity", "intensity", "i"}, true);
    add_time();
    add_first(PcdChannel::ring, {"ring", "line", "channel"}, true);
    add_first(PcdChannel::label, {"label"}, false);
    return std::move(plan_);
  }

 private:
  std::optional<std::size_t> find(std::string_view wanted) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      if (lower_case(header_.fields[i].name) != wanted) {
        continue;
      }
      if (found) {
        throw FileError(ErrorCode::malformed, name_, std::nullopt,
                        fmt::format("PCD header: two fields are called {}; rename one", wanted));
      }
      found = i;
    }
    return found;
  }

  void add_coordinates() {
    constexpr std::array<PcdChannel, 3> kChannels = {PcdChannel::x, PcdChannel::y, PcdChannel::z};
    constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    bool rounded = false;
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
      const std::optional<std::size_t> field = find(kNames[i]);
      if (!field || header_.fields[*field].count != 1) {
        throw FileError(
            ErrorCode::unsupported, name_, std::nullopt,
            fmt::format("PCD header: no field {} with COUNT 1; a scan needs x, y and z in metres", kNames[i]));
      }
      rounded |= header_.fields[*field].type_name() == "F8";
      plan_.channels.push_back({kChannels[i], *field});
    }
    if (rounded) {
      plan_.notes.emplace_back("coordinates of type F8 were rounded to single precision");
    }
  }

  void add_first(PcdChannel channel, std::initializer_list<std::string_view> names, bool float_allowed) {
    for (const std::string_view wanted : names) {
      const std::optional<std::size_t> index = find(wanted);
      if (!index) {
        continue;
      }
      const PcdField& field = header_.fields[*index];
      if (field.count != 1 || (field.type == 'F' && !float_allowed)) {
        plan_.notes.push_back(fmt::format("field {} ({}, COUNT {}) was left out, expected one whole number per point",
                                          wanted, field.type_name(), field.count));
        continue;
      }
      plan_.channels.push_back({channel, *index});
      if (channel == PcdChannel::intensity) {
        plan_.notes.push_back(fmt::format("intensity comes from the field {}, taken as 0..255", wanted));
      }
      return;
    }
  }

  void add_time() {
    for (const TimeName& time : kTimeNames) {
      const std::optional<std::size_t> index = find(time.name);
      if (!index || header_.fields[*index].count != 1 ||
          time.types.find(header_.fields[*index].type_name() + " ") == std::string_view::npos) {
        continue;
      }
      plan_.channels.push_back({PcdChannel::time, *index});
      plan_.time_unit = time.unit;
      plan_.notes.push_back(fmt::format("time comes from the field {} ({}), taken as {}", time.name,
                                        header_.fields[*index].type_name(), unit_name(time.unit)));
      return;
    }
    for (const TimeName& time : kTimeNames) {
      if (const std::optional<std::size_t> index = find(time.name)) {
        const PcdField& field = header_.fields[*index];
        plan_.notes.push_back(fmt::format("field {} ({}, COUNT {}) was left out: its unit is not known", time.name,
                                          field.type_name(), field.count));
        return;
      }
    }
  }

  const PcdHeader& header_;
  const std::string& name_;
  PcdPlan plan_;
};

}  // namespace

PcdPlan plan_channels(const PcdHeader& header, const std::string& name) {
  return Planner(header, name).plan();
}

}  // namespace berm
