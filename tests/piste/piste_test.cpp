#include <gtest/gtest.h>

#include "berm/piste/envelope_piste.hpp"

namespace berm {
namespace {

TEST(EnvelopePiste, NothingComesOfNothing) {
  EXPECT_TRUE(EnvelopePiste({}).process({}).labels.empty());
}

}  // namespace
}  // namespace berm
