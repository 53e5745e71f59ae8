#include "ui/app/session/pose_library.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/input/side_pairs.h"

namespace penpose::app {
namespace {

/// A key at 1 s, named "wink", of a brow and the jaw; then back at rest.
void key_wink(Desk& desk) {
  desk.begin();
  desk.set("brow_inner_L", 0.8);
  desk.set("jaw", 0.5);
  desk.app->of<Playback>().place_cursor(1);
  desk.app->of<Actions>().run(Action::key_pose);
  desk.app->of<Keys>().name("wink");
  desk.app->of<EditingSession>().perform(document::ResetParameters{});
  desk.frames();
}

TEST(PoseLibrary, PartsAreToldByTheNamesOfControls) {
  for (const char* brow : {"browInnerUp_L", "EyebrowRaise"}) EXPECT_EQ(part_of(brow), FacePart::brows) << brow;
  EXPECT_EQ(part_of("eyeBlinkLeft"), FacePart::eyes);
  EXPECT_EQ(part_of("jawOpen"), FacePart::mouth);
  EXPECT_EQ(part_of("nose_sneer"), FacePart::all);
}

TEST(PoseLibrary, AKeyedPoseIsTakenWholeInPartMirroredAndByHalf) {
  Desk desk("library");
  key_wink(desk);
  const auto pairs = side_pairs(desk.document().model->rig->parameters());
  const auto value = [&](const PoseChoice& choice, const std::string& name) {
    for (const auto& one : values_of_choice(desk.document(), choice, pairs).values) {
      if (one.name == name) return one.value;
    }
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(value({1.0}, "brow_inner_L"), 0.8);
  EXPECT_DOUBLE_EQ(value({1.0}, "jaw"), 0.5);
  EXPECT_DOUBLE_EQ(value({1.0, FacePart::mouth}, "jaw"), 0.5);
  EXPECT_DOUBLE_EQ(value({1.0, FacePart::mouth}, "brow_inner_L"), 0);
  EXPECT_DOUBLE_EQ(value({1.0, FacePart::brows, true}, "brow_inner_R"), 0.8);
  EXPECT_DOUBLE_EQ(value({1.0, FacePart::brows, true}, "brow_inner_L"), 0);
  EXPECT_DOUBLE_EQ(value({1.0, FacePart::all, false, 0.5}, "jaw"), 0.25);
  EXPECT_TRUE(values_of_choice(desk.document(), {0.3}, pairs).values.empty()) << "there is no such key";
}

TEST(PoseLibrary, ATakeStandsAsItsFirstAndLastPose) {
  document::Timeline timeline;
  const auto key = [&](double frame, const std::string& name = {}) {
    timeline.keys.push_back({frame / 24, rig::Pose{frame, 0}, name});
  };
  const auto performed = [&](double frame) {
    key(frame);
    timeline.keys.back().controls = std::vector<document::ControlKey>{{}, {document::KeyKind::none, 0, 0}};
  };
  for (const double frame : {0.0, 12.0}) key(frame);
  for (const double frame : {40.0, 43.0, 45.0, 51.0, 57.0}) performed(frame);
  key(59, "smile");
  for (const double frame : {61.0, 63.0, 64.0}) performed(frame);
  EXPECT_EQ(keys_shown(timeline), (std::vector<std::size_t>{0, 1, 2, 6, 7, 8, 10}));
  EXPECT_TRUE(keys_shown({}).empty());
}

TEST(PoseLibrary, APoseIsChosenByItsPictureAndBlendedInWithThePen) {
  Desk desk("library-panel");
  key_wink(desk);
  desk.click("Poses");
  desk.frames(8);
  ASSERT_TRUE(desk.click("wink##pose frame 24"));
  desk.click("Mouth##part");
  const PxPoint half = desk.interface->find("slider blend")->middle();
  desk.drag_slider("blend", 0.01, 0.5, false);
  EXPECT_TRUE(desk.app->of<EditingSession>().shown().previews()) << "the face shows it before it is let go";
  EXPECT_NEAR(desk.app->of<EditingSession>().shown().pose()[desk.index_of("jaw")], 0.25, 0.02);
  desk.let_go(half);
  EXPECT_NEAR(desk.value_of("jaw"), 0.25, 0.02);
  EXPECT_EQ(desk.value_of("brow_inner_L"), 0) << "of the mouth alone";
  desk.click("All##part");
  desk.click("Take##pose");
  EXPECT_DOUBLE_EQ(desk.value_of("jaw"), 0.5);
  EXPECT_DOUBLE_EQ(desk.value_of("brow_inner_L"), 0.8);
}

TEST(PoseLibrary, AnExpressionOfTheModelMovesItsTargetsAlone) {
  Desk desk("library_expression");
  desk.begin();
  document::Document document = desk.document();
  document::Model model = *document.model;
  const std::size_t jaw = desk.index_of("jaw");
  model.expressions = {{"aa", {{jaw, 0.5}}}};
  document.model = std::make_shared<const document::Model>(model);
  document.pose[desk.index_of("brow_inner_L")] = 0.3;
  PoseChoice choice;
  EXPECT_FALSE(choice.chosen());
  choice.expression = 0;
  EXPECT_TRUE(choice.chosen());
  choice.amount = 0.5;
  const auto values = values_of_choice(document, choice, side_pairs(model.rig->parameters())).values;
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].name, "jaw");
  EXPECT_DOUBLE_EQ(values[0].value, 0.25);
  choice.expression = 7;
  EXPECT_TRUE(values_of_choice(document, choice, {}).values.empty());
}

}  // namespace
}  // namespace penpose::app
