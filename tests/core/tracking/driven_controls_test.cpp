#include "core/tracking/driven_controls.h"

#include <gtest/gtest.h>

#include "tests/support/models/square_with_shapes.h"

namespace penpose::tracking {
namespace {

using tests::square_with_shapes;

std::vector<std::size_t> controls(const document::Model& model, std::string_view name) {
  std::vector<std::size_t> found;
  for (const DrivenControl& one : driven_controls(model, name)) found.push_back(one.parameter);
  return found;
}

using Numbers = std::vector<std::size_t>;

TEST(DrivenControls, ActionUnitsMoveWhatTheManualSaysTheyDo) {
  const auto arkit =
      square_with_shapes({"eyeBlinkLeft", "eyeBlinkRight", "jawOpen", "mouthSmileLeft", "mouthSmileRight"});
  EXPECT_EQ(controls(arkit, "AU12"), (Numbers{3, 4}));
  EXPECT_EQ(controls(arkit, "AU26"), (Numbers{2}));
  EXPECT_EQ(controls(arkit, "AU45"), (Numbers{0, 1}));
  EXPECT_TRUE(controls(arkit, "AU02").empty());
  EXPECT_EQ(controls(square_with_shapes({"Lip_Corner_Puller", "AU26"}), "AU12"), (Numbers{0}));
  EXPECT_EQ(controls(square_with_shapes({"jawOpen", "AU26"}), "AU26"), (Numbers{1})) << "its own name first";
}

TEST(DrivenControls, MouthCuesMoveVisemesVowelsOrShapes) {
  const auto oculus = square_with_shapes({"viseme_sil", "viseme_PP", "viseme_aa", "viseme_U"});
  EXPECT_EQ(controls(oculus, "mouth cue D"), (Numbers{2}));
  EXPECT_EQ(controls(oculus, "mouth cue MBP"), (Numbers{1}));
  EXPECT_EQ(controls(oculus, "mouth cue WQ"), (Numbers{3}));
  const auto vowels = square_with_shapes({"A", "I", "U", "E", "O"});
  EXPECT_EQ(controls(vowels, "mouth cue D"), (Numbers{0}));
  EXPECT_TRUE(controls(vowels, "mouth cue A").empty()) << "Rhubarb's A is a closed mouth, not the vowel";
  EXPECT_TRUE(is_driven(vowels, "mouth cue A"));
  const auto own = square_with_shapes({"mouth_A", "mouth_B", "mouth_C", "mouth_D", "mouth_E", "mouth_F", "mouth_X"});
  EXPECT_EQ(controls(own, "mouth cue A"), (Numbers{0}));
  EXPECT_EQ(controls(own, "mouth cue X"), (Numbers{6}));
  const auto arkit = square_with_shapes({"jawOpen", "mouthPucker"});
  ASSERT_EQ(driven_controls(arkit, "mouth cue F").size(), 2U);
  EXPECT_NEAR(driven_controls(arkit, "mouth cue F")[1].gain, 0.8, 1e-12);
}

TEST(DrivenControls, MorphsOfMikuMikuDanceStandForOthers) {
  EXPECT_EQ(controls(square_with_shapes({"あ", "jawOpen"}), "あ"), (Numbers{0}));
  EXPECT_EQ(controls(square_with_shapes({"eyeBlinkLeft", "eyeBlinkRight"}), "まばたき"), (Numbers{0, 1}));
  EXPECT_EQ(controls(square_with_shapes({"Face.M_F00_000_00_Fcl_MTH_A", "Face.M_F00_000_00_Fcl_MTH_I"}), "い"),
            (Numbers{1}));
}

TEST(DrivenControls, AnExpressionDrivesWhatItIsMadeOf) {
  auto model = square_with_shapes({"lids", "cheeks"});
  model.expressions = {{"Blink", {{0, 1.0}, {1, 0.25}}}};
  const auto driven = driven_controls(model, "blink");
  ASSERT_EQ(driven.size(), 2U);
  EXPECT_EQ(driven[1].gain, 0.25);
}

TEST(DrivenControls, AModelWithTheExpressionsOfVrmTakesArkitsColumnsInPart) {
  auto model = square_with_shapes({"s0", "s1", "s2", "s3"});
  model.expressions = {{"aa", {{0, 1}}}, {"blinkLeft", {{1, 1}}}, {"blinkRight", {{2, 1}}}, {"happy", {{3, 1}}}};
  EXPECT_EQ(controls(model, "JawOpen"), (Numbers{0}));
  EXPECT_EQ(controls(model, "EyeBlinkLeft"), (Numbers{1}));
  EXPECT_EQ(controls(model, "EyeBlinkRight"), (Numbers{2}));
  EXPECT_EQ(controls(model, "MouthSmileLeft"), (Numbers{3}));
  EXPECT_EQ(controls(model, "MouthSmileRight"), (Numbers{3}));
  EXPECT_TRUE(controls(model, "MouthPucker").empty());
}

TEST(DrivenControls, MikuMikuDancesMorphsAreTargetsAndSources) {
  const auto morphs = square_with_shapes({"まばたき", "あ", "にやり", "ウィンク２", "ｳｨﾝｸ２右"});
  EXPECT_EQ(controls(morphs, "jawOpen"), (Numbers{1}));
  EXPECT_EQ(controls(morphs, "eyeBlinkLeft"), (Numbers{3}));
  EXPECT_EQ(controls(morphs, "eyeBlinkRight"), (Numbers{4}));
  EXPECT_EQ(controls(morphs, "AU45"), (Numbers{0}));
  EXPECT_EQ(controls(morphs, "mouthSmileLeft"), (Numbers{2}));
  const auto arkit = square_with_shapes({"mouthSmileLeft", "mouthSmileRight", "cheekSquintLeft"});
  EXPECT_EQ(controls(arkit, "happy"), (Numbers{0, 1, 2}));
  EXPECT_EQ(controls(arkit, "にやり"), (Numbers{0, 1}));
}

TEST(DrivenControls, AHalfOfAnUpperAndALowerShapeGoesToTheWholeOnItsSide) {
  const auto arkit = square_with_shapes({"mouthPressLeft", "mouthPressRight", "mouthFunnel"});
  EXPECT_EQ(controls(arkit, "MouthTightenerLeft"), (Numbers{0}));
  EXPECT_EQ(controls(arkit, "LipFunnelUpperLeft"), (Numbers{2}));
}

}  // namespace
}  // namespace penpose::tracking
