#include "machine_option.hpp"

#include "berm/core/error.hpp"
#include "exit_code.hpp"

namespace berm::app {

void MachineOption::add_options(CLI::App& command, bool required) {
  command.add_option("-m,--machine", name_, "A machine by name (berm machine list) or a YAML file")
      ->required(required)
      ->type_name("NAME|FILE");
  add_changes(command);
}

void MachineOption::add_positional(CLI::App& command) {
  command.add_option("MACHINE", name_, "A machine by name (berm machine list) or a YAML file")
      ->required()
      ->type_name("NAME|FILE");
  add_changes(command);
}

void MachineOption::add_changes(CLI::App& command) {
  command
      .add_option("--method", methods_,
                  "Method of a stage (snow, ground, piste, edge): default or reference; none leaves any but ground out")
      ->type_name("STAGE=NAME")
      ->allow_extra_args(false);
  command.add_option("--set", values_, "Another value for a key of the machine, as often as needed")
      ->type_name("SECTION.KEY=VALUE")
      ->allow_extra_args(false);
}

ChosenMachine MachineOption::choose() const {
  ChosenMachine chosen;
  try {
    chosen.file = find_machine(name_, machine_folders());
  } catch (const ConfigError& error) {
    throw UsageError(error.what());
  }
  chosen.machine = read_machine(chosen.file);
  try {
    for (const std::string& method : methods_) {
      chosen.pinned.insert(set_value(chosen.machine, "methods." + method, "--method " + method));
    }
    for (const std::string& value : values_) {
      chosen.pinned.insert(set_value(chosen.machine, value, "--set " + value));
    }
    chosen.machine.check();
  } catch (const ConfigError& error) {
    throw UsageError(error.what());
  }
  return chosen;
}

}  // namespace berm::app
