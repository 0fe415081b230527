#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/pipeline/machine.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MachineFolders, TheFirstFolderThatHasTheNameWins) {
  const test::TempFolder near;
  const test::TempFolder far;
  test::spill(far / "car.yaml", "");
  test::spill(far / "truck.yaml", "");
  test::spill(near / "car.yaml", "");
  test::spill(near / "notes.txt", "");
  const std::vector<std::filesystem::path> folders = {near.path(), "/nowhere/at/all", far.path()};
  EXPECT_EQ(find_machine("car", folders), near / "car.yaml");
  EXPECT_EQ(find_machine("truck", folders), far / "truck.yaml");
  EXPECT_THAT(list_machines(folders), ElementsAre("car", "truck"));
}

TEST(MachineFolders, FilesAreTakenAsTheyAre) {
  EXPECT_EQ(find_machine("some/where", {}), "some/where");
  EXPECT_EQ(find_machine("mine.yaml", {}), "mine.yaml");
  EXPECT_EQ(find_machine("mine.yml", {}), "mine.yml");
}

TEST(MachineFolders, AnUnknownNameListsTheKnownOnes) {
  try {
    static_cast<void>(find_machine("grommer", {BERM_MACHINES_FOLDER}));
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'groomer'"));
    EXPECT_THAT(error.what(), HasSubstr("car, groomer or haul_truck"));
  }
  try {
    static_cast<void>(find_machine("car", {"/nowhere/at/all"}));
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/at/all"));
  }
}

}  // namespace
}  // namespace berm
