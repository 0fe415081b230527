#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::run_berm;
using testing::HasSubstr;

TEST(MachineCommand, ListsTheGivenMachines) {
  const auto result = run_berm({"machine", "list"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* name : {"car\t", "groomer\t", "haul_truck\t"}) {
    EXPECT_THAT(result.out, HasSubstr(name));
  }
}

TEST(MachineCommand, WhatItShowsIsAMachineFile) {
  const auto shown = run_berm({"machine", "show", "groomer", "--set", "mount.height_m=2.5"});
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_THAT(shown.out, HasSubstr("height_m: 2.5"));
  EXPECT_THAT(shown.out, HasSubstr("pitch_deg: 11"));
  const test::TempFolder folder;
  test::spill(folder / "mine.yaml", shown.out);
  EXPECT_EQ(run_berm({"machine", "show", (folder / "mine.yaml").string()}).out, shown.out);
}

TEST(MachineCommand, CheckNamesEveryBrokenFile) {
  const test::TempFolder folder;
  test::spill(folder / "a.yaml", "mount:\n  hight_m: 2\n");
  test::spill(folder / "b.yaml", "mount:\n  height_m: low\n");
  const auto result = run_berm({"machine", "check", (folder / "a.yaml").string(), "car", (folder / "b.yaml").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("a.yaml: line 2: mount.hight_m"));
  EXPECT_THAT(result.err, HasSubstr("b.yaml: line 2: mount.height_m"));
  EXPECT_THAT(result.out, HasSubstr("car.yaml: ok"));
  EXPECT_EQ(run_berm({"machine", "check", "car", "groomer", "haul_truck"}).exit_code, 0);
}

}  // namespace
}  // namespace berm
