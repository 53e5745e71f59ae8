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

std::vector<Parameter> named(std::initializer_list<const char*> names) {
  std::vector<Parameter> parameters;
  for (const char* name : names) parameters.push_back({name});
  return parameters;
}

TEST(ControlNames, APrefixThatTheShapesOfAMeshShareIsNoPartOfTheName) {
  for (const std::string prefix :
       {"blendShape1.", "BS_node.", "Head__", "CTRL_expressions_", "Face.M_F00_", "blendShapes.", "rig:face|", "bs"}) {
    std::vector<Parameter> parameters;
    for (const char* name : {"EyeBlink_L", "EyeBlink_R", "JawOpen", "MouthLeft"}) parameters.push_back({prefix + name});
    EXPECT_EQ(controls_named(parameters, "jawOpen"), (std::vector<std::size_t>{2})) << prefix;
    EXPECT_EQ(controls_named(parameters, "EyeBlinkRight"), (std::vector<std::size_t>{1})) << prefix;
    EXPECT_EQ(controls_named(parameters, "eyeBlink"), (std::vector<std::size_t>{0, 1})) << prefix;
    EXPECT_EQ(controls_named(parameters, "mouthLeft"), (std::vector<std::size_t>{3})) << prefix;
  }
}

TEST(ControlNames, EachMeshMayHaveAPrefixOfItsOwn) {
  const auto parameters = named({"Head__jawOpen", "Head__mouthPucker", "Teeth__jawOpen", "Body__breathe", "Neck.rx"});
  EXPECT_EQ(controls_named(parameters, "jawOpen"), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(controls_named(named({"face.jawOpen", "tail"}), "jawOpen"), (std::vector<std::size_t>{0}));
}

TEST(ControlNames, AWordBeforeAnotherIsNoPrefixUnlessItIsShared) {
  EXPECT_TRUE(controls_named(named({"half_jawOpen", "smile"}), "jawOpen").empty());
  EXPECT_TRUE(controls_named(named({"unjawopen", "unsmile"}), "jawOpen").empty());
  // The name itself comes before any that a prefix hides.
  EXPECT_EQ(controls_named(named({"fix_jawOpen", "fix_smile", "jawOpen"}), "jawOpen"), (std::vector<std::size_t>{2}));
}

TEST(ControlNames, NamesOfOtherScriptsAreKept) {
  EXPECT_EQ(controls_named(named({"\xe3\x81\x82", "\xe3\x81\x84"}), "\xe3\x81\x84"), (std::vector<std::size_t>{1}));
  EXPECT_EQ(folded_name("\xe7\xac\x91\xe3\x81\x84_L"), "\xe7\xac\x91\xe3\x81\x84l");
}

}  // namespace
}  // namespace penpose::rig
