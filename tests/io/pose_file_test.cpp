#include "berm/io/pose_file.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

constexpr const char* kTum = "0 1 2 3 0 0 0 1\n";
constexpr const char* kKitti = "1 0 0 0 0 1 0 0 0 0 1 0\n";
constexpr const char* kNmea = "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n";

class PoseFileTest : public testing::Test {
 protected:
  [[nodiscard]] PoseFileKind kind_of(const std::string& name, const std::string& content) const {
    test::spill(folder_ / name, content);
    return recognise_pose_file(folder_ / name);
  }

  test::TempFolder folder_;
};

TEST_F(PoseFileTest, TheEndingDecidesFirst) {
  EXPECT_EQ(kind_of("a.tum", kKitti), PoseFileKind::tum);
  EXPECT_EQ(kind_of("a.csv", kTum), PoseFileKind::log);
  EXPECT_EQ(kind_of("a.nmea", kTum), PoseFileKind::log);
}

TEST_F(PoseFileTest, ThenTheFirstLineThatSaysSomething) {
  const std::string head = "\n# t x y z\r\n   \n";
  EXPECT_EQ(kind_of("a.txt", head + kTum), PoseFileKind::tum);
  EXPECT_EQ(kind_of("poses.txt", head + kKitti + kTum), PoseFileKind::kitti);
  EXPECT_EQ(kind_of("a.log", head + kNmea), PoseFileKind::log);
  EXPECT_EQ(kind_of("a.txt", ""), PoseFileKind::log);
  EXPECT_EQ(kind_of("a.txt", "1 2 3\n"), PoseFileKind::log);
  EXPECT_EQ(kind_of("a.txt", std::string(100'000, '\n') + kTum), PoseFileKind::log) << "too far into the file";
}

TEST_F(PoseFileTest, WhatIsNoFileIsRefused) {
  test::expect_file_error(ErrorCode::not_found, "there is no such file of poses",
                          [&] { static_cast<void>(recognise_pose_file(folder_ / "none.tum")); });
  test::expect_file_error(ErrorCode::unreadable, "expected a file of poses",
                          [&] { static_cast<void>(recognise_pose_file(folder_.path())); });
}

}  // namespace
}  // namespace berm
