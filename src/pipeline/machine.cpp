#include "berm/pipeline/machine.hpp"

#include "berm/io/settings_folders.hpp"

namespace berm {
namespace {

/// Keys without a default that could be right.
std::vector<std::string> required_keys() {
  return {"machine.name", "sensor.model", "mount.height_m"};
}

SettingsKind machine_kind() {
  return {"machine", "machines", "--machine"};
}

}  // namespace

void Machine::check() const {
  sections([this](std::string_view, auto member) { (this->*member).check(); });
}

Machine parse_machine(std::string_view yaml, const std::string& file) {
  return parse_yaml<Machine>(yaml, file, required_keys());
}

Machine read_machine(const std::filesystem::path& file) {
  return read_yaml<Machine>(file, required_keys());
}

std::vector<std::filesystem::path> machine_folders() {
  return settings_folders(machine_kind());
}

std::vector<std::string> list_machines(const std::vector<std::filesystem::path>& folders) {
  return list_settings(folders);
}

std::filesystem::path find_machine(const std::string& name_or_file, const std::vector<std::filesystem::path>& folders) {
  return find_settings(machine_kind(), name_or_file, folders);
}

}  // namespace berm
