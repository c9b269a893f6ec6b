#include "base/step_limit.hpp"

#include <gtest/gtest.h>

namespace quadline {
namespace {

TEST(StepLimit, ThrowsAfterTheLastStep) {
  StepLimit limit("a loop", 3);
  for (int i = 0; i < 3; ++i) limit.step();
  EXPECT_EQ(limit.steps(), 3u);
  try {
    limit.step();
    FAIL() << "the fourth step passed";
  } catch (const InternalError& error) {
    EXPECT_STREQ(error.what(), "a loop does not end within 3 steps");
  }
}

}  // namespace
}  // namespace quadline
