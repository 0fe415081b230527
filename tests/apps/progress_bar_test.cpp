#include "progress_bar.hpp"

#include <gtest/gtest.h>

namespace berm::app {
namespace {

TEST(ProgressText, SaysShareRateAndTimeLeft) {
  EXPECT_EQ(progress_text(6, 15, 0.5, 100),
            "[############..................]  40 %  6/15 scans  12.0 scans/s  1 s left");
  EXPECT_EQ(progress_text(1, 1001, 1.0, 60), "[.......]   0 %  1/1001 scans  1.0 scans/s  16 min 40 s left");
  EXPECT_EQ(progress_text(1, 10001, 1.0, 40), "  0 %  1/10001 scans  1.0 scans/s  2 h 4");
}

TEST(ProgressText, HoldsAtTheEnds) {
  EXPECT_EQ(progress_text(0, 10, 0.0, 40), "[....................]   0 %  0/10 scans");
  EXPECT_EQ(progress_text(10, 10, 5.0, 60), "[################] 100 %  10/10 scans  2.0 scans/s  0 s left");
  EXPECT_EQ(progress_text(0, 0, 0.0, 10), "100 %  0/0");
  EXPECT_EQ(progress_text(999, 1000, 1.0, 5), " 99 %");
  EXPECT_EQ(progress_text(1, 2, 1.0, 0), "");
}

}  // namespace
}  // namespace berm::app
