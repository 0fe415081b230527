#include <memory>

#include <CLI/CLI.hpp>

#include "berm/core/error.hpp"
#include "berm/pipeline/machine.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_code.hpp"
#include "machine_option.hpp"

namespace berm::app {
namespace {

constexpr const char* kMachineExamples = R"(Examples:
  berm machine list
  berm machine show groomer
  berm machine show car --set mount.height_m=1.9 > my_car.yaml
  berm machine check my_car.yaml)";

int list() {
  std::string text;
  for (const std::string& name : list_machines(machine_folders())) {
    const auto file = find_machine(name, machine_folders());
    text += name + "\t" + file.string() + "\n";
  }
  write_result("-", text);
  return kWhole;
}

int check(const std::vector<std::string>& names) {
  int exit_code = kWhole;
  for (const std::string& name : names) {
    try {
      const auto file = find_machine(name, machine_folders());
      static_cast<void>(read_machine(file));
      write_result("-", file.string() + ": ok\n");
    } catch (const Error& error) {
      if (error.code() == ErrorCode::write_failed) {
        throw;
      }
      print_error(error.what());
      exit_code = kFailed;
    }
  }
  return exit_code;
}

void add_show(CLI::App& app, int& exit_code) {
  auto machine = std::make_shared<MachineOption>();
  CLI::App* sub = app.add_subcommand("show", "Print a machine as YAML with every key and what it may be");
  machine->add_positional(*sub);
  sub->callback([machine, &exit_code] {
    write_result("-", to_yaml(machine->choose().machine));
    exit_code = kWhole;
  });
}

}  // namespace

void add_machine(CLI::App& app, int& exit_code) {
  CLI::App* sub = app.add_subcommand("machine", "Show and check machine files");
  sub->footer(kMachineExamples);
  sub->require_subcommand(1);
  sub->add_subcommand("list", "Print the machines that are known by name")->callback([&exit_code] {
    exit_code = list();
  });
  add_show(*sub, exit_code);
  auto names = std::make_shared<std::vector<std::string>>();
  CLI::App* check_command = sub->add_subcommand("check", "Check machine files");
  check_command->add_option("MACHINE", *names, "Names or files")->required()->type_name("NAME|FILE");
  check_command->callback([names, &exit_code] { exit_code = check(*names); });
}

}  // namespace berm::app
