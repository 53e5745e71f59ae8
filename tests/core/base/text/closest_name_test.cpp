#include "core/base/text/closest_name.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::base {
namespace {

const std::vector<std::string> k_names{"mouthSmile_L", "mouthSmile_R", "jawOpen", "browDown_L"};

TEST(ClosestName, SuggestsWhatWasMeant) {
  EXPECT_EQ(closest_name("mouthSmil_L", k_names), "mouthSmile_L");
  EXPECT_EQ(closest_name("MOUTHSMILE_R", k_names), "mouthSmile_R");
  EXPECT_EQ(closest_name("jawopne", k_names), "jawOpen");
}

TEST(ClosestName, SuggestsNothingForSomethingElse) {
  EXPECT_FALSE(closest_name("elbow", k_names).has_value());
  EXPECT_FALSE(closest_name("x", {}).has_value());
  EXPECT_FALSE(closest_name(std::string(100000, 'a'), k_names).has_value());
}

}  // namespace
}  // namespace penpose::base
