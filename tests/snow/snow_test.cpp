#include <gtest/gtest.h>

#include "berm/snow/box_snow.hpp"

namespace berm {
namespace {

TEST(BoxSnow, NothingComesOfNothing) { EXPECT_EQ(BoxSnow({}).process({}, {}).count, 0U); }

}  // namespace
}  // namespace berm
