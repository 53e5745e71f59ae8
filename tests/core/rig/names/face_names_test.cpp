#include "core/rig/names/face_names.h"

#include <gtest/gtest.h>

#include "core/rig/control_names.h"

namespace penpose::rig {
namespace {

/// "eyeBlink left"; empty: no meaning.
std::string said(const char* name) {
  const auto found = face_name(name);
  if (!found) return {};
  const char* sides[] = {"", " left", " right"};
  return face_meanings()[found->meaning].name + sides[static_cast<std::size_t>(found->side)];
}

TEST(FaceNames, AreReadInTheSpellingOfManyPrograms) {
  const std::pair<const char*, const char*> names[] = {
      {"eyeBlinkLeft", "eyeBlink left"},
      {"EyeBlink_L", "eyeBlink left"},
      {"A14_Eye_Blink_Left", "eyeBlink left"},
      {"A25_Jaw_Open", "jawOpen"},
      {"Eye_Left_Blink", "eyeBlink left"},
      {"L_eyeBlink", "eyeBlink left"},
      {"eyeBlink_lf", "eyeBlink left"},
      {"rt_eyeBlink", "eyeBlink right"},
      {"Left_Eye_Blink", "eyeBlink left"},
      {"EyeClosedRight", "eyeBlink right"},
      {"CTRL_expressions_eyeBlinkL", "eyeBlink left"},
      {"CTRL_expressions_mouthCornerPullR", "mouthSmile right"},
      {"CTRL_expressions_browRaiseInL", "browInnerUp left"},
      {"CTRL_expressions_eyeLookLeftL", "eyeLookOut left"},
      {"CTRL_expressions_eyeLookLeftR", "eyeLookIn right"},
      {"Eye_Right_Left", "eyeLookIn right"},
      {"Mouth_Smile_Left", "mouthSmile left"},
      {"MouthCornerPullLeft", "mouthSmile left"},
      {"Mouth_Sad_Right", "mouthFrown right"},
      {"Mouth_Ape_Shape", "mouthClose"},
      {"Mouth_Lower_DownLeft", "mouthLowerDown left"},
      {"Mouth_Upper_UpRight", "mouthUpperUp right"},
      {"Brow_Raise_Outer_L", "browOuterUp left"},
      {"Mouth_Roll_In_Upper", "mouthRollUpper"},
      {"Mouth_L", "mouthLeft"},
      {"Jaw_R", "jawRight"},
      {"jawLeft", "jawLeft"},
      {"facs_bs_MouthSmileLeft_div2", "mouthSmile left"},
      {"facs_jnt_EyesBlinkRight", "eyeBlink right"},
      {"AU12", "mouthSmile"},
      {"AU4", "browDown"},
      {"vrc.v_oh", "viseme_O"},
      {"viseme_PP", "viseme_PP"},
      {"Fcl_MTH_A", "viseme_aa"},
      {"blink_l", "eyeBlink left"},
      {"blinkRight", "eyeBlink right"},
      {"Joy", "happy"},
      {"まばたき", "eyeBlink"},
      {"まばたき左", "eyeBlink left"},
      {"左まばたき", "eyeBlink left"},
      {"ｳｨﾝｸ２右", "eyeBlink right"},
      {"あ", "viseme_aa"},
  };
  for (const auto& [name, meant] : names) EXPECT_EQ(said(name), meant) << name;
}

TEST(FaceNames, OthersMeanNothing) {
  for (const char* name : {"", "_", "L", "left", "Body_Height", "half_jawOpen", "hair", "14", "A14", "teeth_L"})
    EXPECT_EQ(said(name), "") << name;
}

TEST(FaceNames, EachNameOfTheTableIsOfItsOwnRow) {
  for (std::size_t i = 0; i < face_meanings().size(); ++i) {
    const FaceMeaning& meaning = face_meanings()[i];
    for (const std::string_view name : meaning.names) {
      const auto found = face_name(name.substr(0, name.find('>')));
      ASSERT_TRUE(found) << name;
      EXPECT_EQ(found->meaning, i) << name << " is said of two meanings";
    }
  }
}

std::vector<Parameter> shapes(std::initializer_list<const char*> names) {
  std::vector<Parameter> parameters;
  for (const char* name : names) parameters.push_back({name});
  return parameters;
}
using Numbers = std::vector<std::size_t>;

TEST(FaceNames, AControlAnswersToTheNamesOfOtherPrograms) {
  const auto cc = shapes({"Eye_Blink_L", "Eye_Blink_R", "Mouth_Smile_L", "Mouth_Smile_R", "Jaw_Open", "Mouth_L"});
  EXPECT_EQ(controls_named(cc, "EyeClosedRight"), (Numbers{1}));
  EXPECT_EQ(controls_named(cc, "mouthCornerPullL"), (Numbers{2}));
  EXPECT_EQ(controls_named(cc, "AU12"), (Numbers{2, 3}));
  EXPECT_EQ(controls_named(cc, "mouthLeft"), (Numbers{5}));
  const auto meta = shapes({"CTRL_expressions_jawOpen", "CTRL_expressions_mouthCornerPullL",
                            "CTRL_expressions_mouthCornerPullR", "CTRL_expressions_eyeBlinkL"});
  EXPECT_EQ(controls_named(meta, "MouthSmileLeft"), (Numbers{1}));
  EXPECT_EQ(controls_named(meta, "eyeBlinkLeft"), (Numbers{3}));
  EXPECT_TRUE(controls_named(meta, "eyeBlinkRight").empty()) << "the other side is none of it";
}

TEST(FaceNames, OfSeveralControlsThatMeanTheSameTheFirstOfTheTableCounts) {
  const auto both = shapes({"Smile_L", "MouthCornerPull_L", "blink", "まばたき"});
  EXPECT_EQ(controls_named(both, "mouthSmileLeft"), (Numbers{1}));
  EXPECT_EQ(controls_named(both, "EyeClosedLeft"), (Numbers{2})) << "a control without a side does it for both";
}

}  // namespace
}  // namespace penpose::rig
