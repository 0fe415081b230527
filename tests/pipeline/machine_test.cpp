#include "berm/pipeline/machine.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using testing::HasSubstr;

constexpr const char* kSmallest = R"(machine: {name: small}
sensor:
  model: any
mount:
  height_m: 2
)";

/// What the error says that `yaml` leads to.
std::string error_of(const std::string& yaml) {
  try {
    static_cast<void>(parse_machine(yaml, "m.yaml"));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of_setting(const std::string& assignment) {
  Machine machine = parse_machine(kSmallest, "m.yaml");
  try {
    static_cast<void>(set_value(machine, assignment, "--set " + assignment));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Machine, SmallestFileLeavesTheRestAtDefaults) {
  const Machine machine = parse_machine(kSmallest, "m.yaml");
  EXPECT_EQ(machine.machine.name, "small");
  EXPECT_EQ(machine.mount.height_m, 2.0);
  EXPECT_EQ(machine.mount.pitch_deg, MountConfig{}.pitch_deg);
  EXPECT_EQ(machine.methods.snow, "default");
  EXPECT_EQ(machine.methods.ground, "default");
  EXPECT_EQ(machine.methods.piste, "none");
}

TEST(Machine, GivenMachinesAreThoseOfTheDocuments) {
  const std::filesystem::path folder = BERM_MACHINES_FOLDER;
  const Machine car = read_machine(folder / "car.yaml");
  EXPECT_EQ(car.mount.height_m, 1.73);
  const Machine groomer = read_machine(folder / "groomer.yaml");
  EXPECT_EQ(groomer.mount.height_m, 2.3);
  EXPECT_EQ(groomer.mount.pitch_deg, 11.0);
  EXPECT_EQ(groomer.sensor.scan_hz, 10.0);
  EXPECT_EQ(groomer.methods.piste, "default");
  const Machine truck = read_machine(folder / "haul_truck.yaml");
  EXPECT_THAT(truck.machine.description, HasSubstr("assumption"));
}

TEST(Machine, PitchLooksDown) {
  Machine machine = parse_machine(kSmallest, "m.yaml");
  machine.mount.pitch_deg = 90.0;
  const Eigen::Vector3d ahead = machine.mount.T_base_sensor() * Eigen::Vector3d(1.0, 0.0, 0.0);
  EXPECT_NEAR(ahead.z(), 1.0, 1e-12);
  EXPECT_NEAR(ahead.x(), 0.0, 1e-12);
}

struct BrokenFile {
  const char* name;
  std::string yaml;
  std::vector<const char*> says;
};

void PrintTo(const BrokenFile& file, std::ostream* stream) {
  *stream << file.name;
}

class MachineRefuses : public testing::TestWithParam<BrokenFile> {};

TEST_P(MachineRefuses, AndSaysWhereAndWhatIsAllowed) {
  const std::string error = error_of(GetParam().yaml);
  for (const char* part : GetParam().says) {
    EXPECT_THAT(error, HasSubstr(part));
  }
}

const std::string kSmall = kSmallest;

INSTANTIATE_TEST_SUITE_P(
    Files, MachineRefuses,
    testing::Values(
        BrokenFile{"unknown_key",
                   kSmall + "  heigth_m: 2\n",
                   {"m.yaml: line 6", "mount.heigth_m", "unknown key", "did you mean 'height_m'", "pitch_deg"}},
        BrokenFile{"unknown_section",
                   kSmall + "grond:\n  min_range_m: 2\n",
                   {"m.yaml: line 7", "grond", "unknown section", "did you mean 'ground'", "ground_reference"}},
        BrokenFile{"word_for_number",
                   kSmall + "  pitch_deg: steep\n",
                   {"m.yaml: line 6", "mount.pitch_deg", "expected a number", "'steep'"}},
        BrokenFile{"quoted_number", kSmall + "  pitch_deg: \"3\"\n", {"line 6", "expected a number", "in quotes"}},
        BrokenFile{"number_and_unit", kSmall + "  pitch_deg: 3 deg\n", {"line 6", "expected a number", "'3 deg'"}},
        BrokenFile{"number_too_large", kSmall + "  pitch_deg: 1e999\n", {"line 6", "mount.pitch_deg"}},
        BrokenFile{"out_of_range",
                   kSmall + "  pitch_deg: 181\n",
                   {"m.yaml: line 6", "mount.pitch_deg", "181 is not allowed", "-180 to 180"}},
        BrokenFile{"nan", kSmall + "  pitch_deg: nan\n", {"line 6", "mount.pitch_deg"}},
        BrokenFile{"infinite", kSmall + "  pitch_deg: inf\n", {"line 6", "mount.pitch_deg"}},
        BrokenFile{"choice",
                   kSmall + "methods: {ground: best}\n",
                   {"line 6", "methods.ground", "'best' is not allowed", "default or reference"}},
        BrokenFile{"choice_of_three",
                   kSmall + "methods: {piste: best}\n",
                   {"line 6", "methods.piste", "'best' is not allowed", "none, default or reference"}},
        BrokenFile{"no_value", kSmall + "  pitch_deg:\n", {"line 6", "mount.pitch_deg", "has no value"}},
        BrokenFile{"duplicate_key",
                   kSmall + "  height_m: 3\n",
                   {"line 6", "mount.height_m", "is given twice, first in line 5"}},
        BrokenFile{
            "duplicate_section", kSmall + "mount:\n  x_m: 3\n", {"line 6", "mount", "is given twice, first in line 4"}},
        BrokenFile{"missing", "machine:\n  name: x\nmount:\n  height_m: 2\n", {"m.yaml", "sensor.model", "missing"}},
        BrokenFile{"empty", "", {"m.yaml", "machine.name", "missing"}},
        BrokenFile{"comment_alone", "# nothing\n", {"m.yaml", "machine.name", "missing"}},
        BrokenFile{"list_for_value", kSmall + "  x_m: [1, 2]\n", {"line 6", "mount.x_m", "one value", "a list"}},
        BrokenFile{"section_for_value", kSmall + "  x_m: {a: 1}\n", {"line 6", "mount.x_m", "one value", "a section"}},
        BrokenFile{"value_for_section", kSmall + "ground: 3\n", {"line 6", "ground", "expected a section"}},
        BrokenFile{"list_for_section", kSmall + "ground: [3]\n", {"line 6", "ground", "expected a section", "a list"}},
        BrokenFile{"list_at_top", "- a\n- b\n", {"line 1", "expected sections", "a list"}},
        BrokenFile{"text_at_top", "hello\n", {"line 1", "expected sections", "'hello'"}},
        BrokenFile{"alias", "machine: {name: &a x}\nsensor: {model: *a}\n", {"line 1", "anchors"}},
        BrokenFile{"bomb", "a: &a [l,l]\nb: &b [*a,*a]\nc: &c [*b,*b]\n", {"line 1"}},
        BrokenFile{"tag", kSmall + "  x_m: !!int 3\n", {"line 6", "tags"}},
        BrokenFile{"complex_key", "? [a, b]\n: c\n", {"line 1"}},
        BrokenFile{"second_document", kSmall + "---\n" + kSmall, {"second document"}},
        BrokenFile{"tabs", "machine:\n\tname: x\n", {"m.yaml: line 2"}},
        BrokenFile{"open_bracket", kSmall + "ground: {", {"m.yaml: line 6", "no valid YAML"}},
        BrokenFile{"deep", kSmall + "ground: " + std::string(30000, '['), {"m.yaml"}},
        BrokenFile{"deep_sections", std::string(30000, '{'), {"m.yaml"}},
        BrokenFile{"control_character", "machine: {name: \"a\\x07b\"}\n", {"line 1", "machine.name", "control"}},
        BrokenFile{"long_text",
                   "machine:\n  name: " + std::string(101, 'x') + "\n",
                   {"line 2", "machine.name", "at most 100"}}),
    [](const auto& test) { return test.param.name; });

TEST(Machine, SetIsAsStrictAsAFileAndNamesTheArgument) {
  Machine machine = parse_machine(kSmallest, "m.yaml");
  EXPECT_EQ(set_value(machine, "mount.x_m=-1.5", "--set mount.x_m=-1.5"), "mount.x_m");
  EXPECT_EQ(machine.mount.x_m, -1.5);
  EXPECT_EQ(set_value(machine, "machine.name=a=b", "--set"), "machine.name");
  EXPECT_EQ(machine.machine.name, "a=b");

  EXPECT_THAT(error_of_setting("mount.x=1"), HasSubstr("--set mount.x=1: mount.x: unknown key, did you mean 'x_m'?"));
  EXPECT_THAT(error_of_setting("ground.nonsense=1"), HasSubstr("unknown key"));
  EXPECT_THAT(error_of_setting("nonsense.a=1"), HasSubstr("unknown section"));
  EXPECT_THAT(error_of_setting("mount.x_m=51"), HasSubstr("-50 to 50"));
  EXPECT_THAT(error_of_setting("mount.x_m="), HasSubstr("expected a number and found nothing"));
  for (const char* form : {"", "=", "mount", "mount.x_m", "x_m=3", "=mount.x_m", ".=", "a=b.c"}) {
    EXPECT_NE(error_of_setting(form), "no error") << form;
  }
}

TEST(Machine, ARefusedSettingChangesNothing) {
  Machine machine = parse_machine(kSmallest, "m.yaml");
  const std::string before = to_yaml(machine);
  EXPECT_THROW(static_cast<void>(set_value(machine, "mount.x_m=51", "--set")), ConfigError);
  EXPECT_EQ(to_yaml(machine), before);
}

TEST(Machine, WhatIsShownReadsBackTheSame) {
  Machine machine = parse_machine(kSmallest, "m.yaml");
  machine.machine.name = R"(a "quoted" \ name: # with - marks)";
  machine.mount.pitch_deg = 0.1 + 0.2;
  machine.mount.yaw_deg = -1e-7;
  const std::string yaml = to_yaml(machine);
  const Machine again = parse_machine(yaml, "again.yaml");
  EXPECT_EQ(again.machine.name, machine.machine.name);
  EXPECT_EQ(again.mount.pitch_deg, machine.mount.pitch_deg);
  EXPECT_EQ(to_yaml(again), yaml);
}

TEST(Machine, NoTextWhateverCrashes) {
  const std::string letters = "{}[]:,-?&*!|>'\"%@`#\n\t \\\xff\0a1.e~=<";
  EXPECT_TRUE(rc::check([&letters] {
    const auto picks = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 35));
    std::string text;
    for (const std::size_t pick : picks) {
      text += letters[pick % letters.size()];
    }
    for (const std::string& yaml : {text, "machine: " + text, std::string(kSmallest) + text}) {
      static_cast<void>(error_of(yaml));
    }
  }));
}

TEST(Machine, EveryTruncationOfAFileIsReadOrRefused) {
  const std::string whole = test::slurp(std::filesystem::path(BERM_MACHINES_FOLDER) / "groomer.yaml");
  ASSERT_GT(whole.size(), 100U);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    static_cast<void>(error_of(whole.substr(0, length)));
  }
  EXPECT_EQ(error_of(whole), "no error");
}

TEST(Machine, FilesThatAreNoneAreRefused) {
  const test::TempFolder folder;
  EXPECT_THROW(static_cast<void>(read_machine(folder / "missing.yaml")), FileError);
  EXPECT_THROW(static_cast<void>(read_machine(folder.path())), FileError);
  EXPECT_THROW(static_cast<void>(read_machine("/dev/zero")), FileError);
  test::spill(folder / "large.yaml", kSmallest + std::string(64 * 1024, '#'));
  EXPECT_THROW(static_cast<void>(read_machine(folder / "large.yaml")), FileError);
}

}  // namespace
}  // namespace berm
