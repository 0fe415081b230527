#include "berm/pipeline/machine.hpp"

#include <array>
#include <cstdint>
#include <numbers>
#include <set>
#include <type_traits>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "closest_name.hpp"
#include "field_access.hpp"
#include "setting.hpp"

namespace berm {
namespace {

/// Ten times the largest sensible machine file.
constexpr std::uint64_t kMaxMachineBytes = 65'536;

/// Keys without a default that could be right.
constexpr std::array<std::string_view, 3> kRequired = {"machine.name", "sensor.model", "mount.height_m"};

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  Machine::sections([&names](std::string_view name, auto) { names.emplace_back(name); });
  return names;
}

[[noreturn]] void refuse_unknown(const std::string& where, const std::string& key, const std::string& kind,
                                 const std::string& written, const std::vector<std::string>& names) {
  throw ConfigError(where, key, "unknown " + kind + did_you_mean(written, names) + " Allowed: " + enumerate(names));
}

void assign_setting(Machine& machine, const Setting& setting) {
  bool section_found = false;
  Machine::sections([&](std::string_view name, auto member) {
    if (name != setting.section) {
      return;
    }
    section_found = true;
    auto& config = machine.*member;
    if (!assign(config, setting)) {
      refuse_unknown(setting.where, setting.full_key(), "key", setting.key,
                     field_names<std::remove_reference_t<decltype(config)>>());
    }
  });
  if (!section_found) {
    refuse_unknown(setting.where, setting.section, "section", setting.section, section_names());
  }
}

void check_machine(const Machine& machine, const std::string& where) {
  try {
    machine.check();
  } catch (const ConfigError& error) {
    throw ConfigError(where, error.key(), error.problem());
  }
}

}  // namespace

Pose MountConfig::T_base_sensor() const {
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  return Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg,
                                   {x_m, y_m, height_m});
}

void Machine::check() const {
  sections([this](std::string_view, auto member) { (this->*member).check(); });
}

Machine parse_machine(std::string_view yaml, const std::string& file) {
  Machine machine;
  std::set<std::string> given;
  for (const Setting& setting : parse_settings(yaml, file)) {
    assign_setting(machine, setting);
    given.insert(setting.full_key());
  }
  for (const std::string_view key : kRequired) {
    if (!given.contains(std::string(key))) {
      throw ConfigError(file, std::string(key), "is missing, add it: it has no default");
    }
  }
  check_machine(machine, file);
  return machine;
}

Machine read_machine(const std::filesystem::path& file) {
  FileBuffer buffer;
  read_file(file, buffer, kMaxMachineBytes);
  return parse_machine(buffer.text(), file.string());
}

std::string set_value(Machine& machine, std::string_view assignment, const std::string& where) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.find('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos || dot > equals) {
    throw ConfigError(where, std::string(assignment.substr(0, equals)),
                      "expected SECTION.KEY=VALUE, such as mount.height_m=2.3");
  }
  const Setting setting{where, std::string(assignment.substr(0, dot)),
                        std::string(assignment.substr(dot + 1, equals - dot - 1)),
                        std::string(assignment.substr(equals + 1)), false};
  assign_setting(machine, setting);
  return setting.full_key();
}

std::string to_yaml(const Machine& machine) {
  std::string yaml;
  Machine::sections([&](std::string_view name, auto member) {
    const auto& config = machine.*member;
    using Config = std::remove_cvref_t<decltype(config)>;
    yaml += (yaml.empty() ? "" : "\n") + std::string(name) + ":\n";
    Config::fields(EachField{[&](std::string_view key, auto field, const std::string& allowed, const auto& /*find*/,
                                 std::string_view text) {
      yaml +=
          "  " + std::string(key) + ": " + to_text(config.*field) + "  # " + std::string(text) + " (" + allowed + ")\n";
    }});
  });
  return yaml;
}

}  // namespace berm
