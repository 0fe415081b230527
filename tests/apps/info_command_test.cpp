#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::run_berm;

TEST(InfoCommand, SaysWhatIsThere) {
  const test::TempFolder folder;
  test::make_recording(folder.path(), 3);
  const auto text = run_berm({"info", folder.path().string()});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_GT(text.out.size(), 100U);
  const auto json = run_berm({"info", folder.path().string(), "--json"});
  EXPECT_EQ(json.exit_code, 0);
  EXPECT_TRUE(nlohmann::json::parse(json.out).is_object());
}

TEST(InfoCommand, LooksIntoAsManyScansAsItIsTold) {
  const test::TempFolder folder;
  test::make_recording(folder.path(), 4);
  test::spill(folder.path() / "scans/000003.pcd", "broken");
  EXPECT_EQ(run_berm({"info", folder.path().string(), "--count", "2"}).exit_code, 0);
  EXPECT_EQ(run_berm({"info", folder.path().string()}).exit_code, 3);
  EXPECT_EQ(run_berm({"info", folder.path().string(), "--first", "9"}).exit_code, 2);
  EXPECT_EQ(run_berm({"info", (folder / "nowhere").string()}).exit_code, 1);
}

}  // namespace
}  // namespace berm
