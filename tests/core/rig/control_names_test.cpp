#include "core/rig/control_names.h"

#include <gtest/gtest.h>

namespace penpose::rig {
namespace {

TEST(ControlNames, AreComparedWithoutCaseSeparatorsAndSides) {
  for (const char* name : {"eyeBlink_L", "EyeBlinkLeft", "eye-blink.left", "EYE BLINK L"}) {
    EXPECT_EQ(folded_name(name), "eyeblinkl") << name;
  }
  EXPECT_EQ(folded_name("mouthRight"), "mouthr");
  EXPECT_EQ(folded_name("left"), "left");
}

TEST(ControlNames, ANameWithoutASideMeansBothSides) {
  const std::vector<Parameter> parameters{{"browInnerUp_L"}, {"jawOpen"}, {"browInnerUp_R"}, {"mouthLeft"}};
  EXPECT_EQ(controls_named(parameters, "BrowInnerUp"), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(controls_named(parameters, "BrowInnerUpRight"), (std::vector<std::size_t>{2}));
  EXPECT_EQ(controls_named(parameters, "MouthLeft"), (std::vector<std::size_t>{3}));
  EXPECT_TRUE(controls_named(parameters, "tongueOut").empty());
  EXPECT_TRUE(controls_named(parameters, "_").empty());
}

}  // namespace
}  // namespace penpose::rig
