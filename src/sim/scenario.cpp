#include "berm/sim/scenario.hpp"

#include "berm/io/settings.hpp"
#include "berm/io/settings_folders.hpp"

namespace berm::sim {
namespace {

SettingsKind scenario_kind() {
  return {"scenario", "scenarios", "SCENARIO"};
}

/// Keys without a default that could be right.
std::vector<std::string> required_keys() {
  return {"scenario.name", "mount.height_m"};
}

void resolve(std::string& file, const std::filesystem::path& folder) {
  if (!file.empty() && std::filesystem::path(file).is_relative()) {
    file = (folder / file).lexically_normal().string();
  }
}

}  // namespace

void Scenario::check() const {
  sections([this](std::string_view, auto member) { (this->*member).check(); });
  WorldPlan::check();
}

Scenario parse_scenario(std::string_view yaml, const std::string& file) {
  return parse_yaml<Scenario>(yaml, file, required_keys());
}

Scenario read_scenario(const std::filesystem::path& file) {
  auto scenario = read_yaml<Scenario>(file, required_keys());
  const std::filesystem::path folder = file.parent_path();
  resolve(scenario.world.elevation, folder);
  if (is_settings_file(scenario.scenario.sensor)) {
    resolve(scenario.scenario.sensor, folder);
  }
  return scenario;
}

std::vector<std::filesystem::path> scenario_folders() {
  return settings_folders(scenario_kind());
}

std::vector<std::string> list_scenarios(const std::vector<std::filesystem::path>& folders) {
  return list_settings(folders);
}

std::filesystem::path find_scenario(const std::string& name_or_file,
                                    const std::vector<std::filesystem::path>& folders) {
  return find_settings(scenario_kind(), name_or_file, folders);
}

}  // namespace berm::sim
