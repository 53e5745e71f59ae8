#include "core/document/words/readable_name.h"

#include <gtest/gtest.h>

#include "core/document/words/face_deeds.h"

namespace penpose::document {
namespace {

TEST(ReadableName, PutsTheSideBehind) {
  EXPECT_EQ(readable_name("mouth_corner_L").text(), "mouth corner, left");
  EXPECT_EQ(readable_name("anim_leftLipPucker").text(), "lip pucker, left");
  EXPECT_EQ(readable_name("RightUpLeg").text(), "up leg, right");
  EXPECT_EQ(readable_name("Face.blinkLeft").text(), "blink, left");
}

TEST(ReadableName, KeepsWhatHasNoWords) {
  EXPECT_EQ(readable_name("___").text(), "___");
  EXPECT_EQ(readable_name("L").text(), "L") << "a name that is a side alone";
}

TEST(DeedNamed, KnowsTheNamesThatProgramsAgreeOn) {
  const auto said = [](const char* name) {
    const auto deed = deed_named(name);
    return deed ? std::string(words_of_deed(*deed, false)) : std::string();
  };
  EXPECT_EQ(said("eyeBlinkLeft"), "eye closes");
  EXPECT_EQ(said("blendShape1.jawOpen"), "jaw opens");
  EXPECT_EQ(said("anim_rightLipCornerPuller"), "smile");
  EXPECT_EQ(said("vrc_blink_left"), "eye closes");
  EXPECT_EQ(said("something"), "");
}

TEST(ExpressionNamed, KnowsSoundsAndFeelings) {
  EXPECT_EQ(expression_named("viseme_aa"), "mouth: aa");
  EXPECT_EQ(expression_named("blendShape19.vrc_v_th"), "mouth: th");
  EXPECT_EQ(expression_named("Fcl_MTH_A"), "mouth: a");
  EXPECT_EQ(expression_named("viseme_sil"), "mouth: silence");
  EXPECT_EQ(expression_named("Joy"), "joy");
  EXPECT_EQ(expression_named("mouthPucker"), "");
}

}  // namespace
}  // namespace penpose::document
