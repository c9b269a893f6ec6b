#include "domain/arrange/unique_names.hpp"

#include <gtest/gtest.h>

namespace quadline::arrangement {
namespace {

TEST(UniqueNames, CountOnFromTheNameAsGiven) {
  UniqueNames names;
  EXPECT_EQ(names.take("rib"), "rib");
  EXPECT_EQ(names.take("rib"), "rib-2");
  EXPECT_EQ(names.take("rib"), "rib-3");
}

TEST(UniqueNames, StepOverNamesThatAreGiven) {
  UniqueNames names;
  EXPECT_EQ(names.take("rib-2"), "rib-2");
  EXPECT_EQ(names.take("rib"), "rib");
  EXPECT_EQ(names.take("rib"), "rib-3");
  EXPECT_EQ(names.take("rib-2"), "rib-2-2");
}

}  // namespace
}  // namespace quadline::arrangement
