#include "berm/core/label.hpp"

#include <gtest/gtest.h>

namespace berm {
namespace {

TEST(Label, HasTheIdsOfTheFilesOfARun) {
  EXPECT_EQ(semantic_kitti_id(Label::unlabeled), 0U);
  EXPECT_EQ(semantic_kitti_id(Label::no_return), 0U);
  EXPECT_EQ(semantic_kitti_id(Label::falling_snow), 110U);
  EXPECT_EQ(semantic_kitti_id(Label::drivable), 40U);
  EXPECT_EQ(semantic_kitti_id(Label::terrain), 72U);
  EXPECT_EQ(semantic_kitti_id(Label::obstacle), 99U);
}

TEST(Label, IsOneByteAndUnlabeledByDefault) {
  static_assert(sizeof(Label) == 1);
  EXPECT_EQ(Label{}, Label::unlabeled);
}

TEST(Label, GivesNoIdToWhatIsNoLabel) {
  EXPECT_EQ(semantic_kitti_id(static_cast<Label>(200)), 0U);
}

}  // namespace
}  // namespace berm
