#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "tests/support/app_replay.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/files/load_model.h"
#include "ui/files/trace_file.h"

// The rest of the face, offered from poses that are keyed.

namespace penpose::app {
namespace {

double value_of(const rig::Pose& pose, const Desk& desk, const std::string& name) { return pose[desk.index_of(name)]; }

/// Three faces whose brows go with the corner of the mouth, then the face at rest again.
void key_faces(Desk& desk, int count = 3) {
  for (int k = 0; k < count; ++k) {
    const double much = 0.3 + 0.3 * k;
    for (const char* name : {"mouth_corner_L", "mouth_corner_R"}) desk.set(name, much);
    for (const char* name : {"brow_inner_L", "brow_inner_R"}) desk.set(name, 0.9 * much);
    desk.app->of<Playback>().place_cursor(0.5 * k);
    desk.click("Key");
  }
  desk.click("Rest pose");
}

struct KeyedDesk : Desk {
  explicit KeyedDesk(const std::string& name) : Desk(name) {
    begin();
    key_faces(*this);
  }
};

TEST(Suggestion, IsGreyAndSaysWhyUntilTwoPosesAreKeyed) {
  Desk desk("suggest-grey");
  desk.begin();
  EXPECT_NE(desk.app->of<SuggestionOffer>().why_not(desk.app->of<EditingSession>()).find("no pose is keyed yet"),
            std::string::npos);
  key_faces(desk, 1);
  desk.set("mouth_corner_L", 0.5);
  desk.click("Suggest");
  EXPECT_FALSE(desk.app->of<SuggestionOffer>().open()) << "a grey button does nothing";
  desk.press('g');
  EXPECT_FALSE(desk.app->of<SuggestionOffer>().open());
  EXPECT_TRUE(desk.says("only one pose is keyed yet"));
  EXPECT_TRUE(desk.says("key two different poses or more"));
  key_faces(desk, 2);
  EXPECT_EQ(desk.app->of<SuggestionOffer>().why_not(desk.app->of<EditingSession>()), "");
}

TEST(Suggestion, IsShownAndChangesTheDocumentOnlyWhenItIsTaken) {
  KeyedDesk desk("suggest-take");
  desk.set("mouth_corner_L", 0.5);
  desk.set("mouth_corner_R", 0.5);
  const auto before = desk.app->of<EditingSession>().state();
  const std::size_t undo = desk.app->of<EditingSession>().editor().history().undo_count();
  desk.click("Suggest");
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  EXPECT_EQ(desk.app->of<EditingSession>().state(), before);
  const rig::Pose shown = desk.app->of<EditingSession>().shown().pose();
  EXPECT_GT(value_of(shown, desk, "brow_inner_L"), 0.2) << "the brow goes with the mouth";
  EXPECT_EQ(value_of(shown, desk, "mouth_corner_L"), 0.5) << "what was posed stays";
  desk.click("Take it##suggestion");
  EXPECT_FALSE(desk.app->of<SuggestionOffer>().open());
  EXPECT_EQ(desk.document().pose, shown);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), undo + 1);
  desk.press('z', true);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), before);
}

TEST(Suggestion, DismissedTheFaceIsAsItWasAndNothingIsRecorded) {
  KeyedDesk desk("suggest-dismiss");
  desk.set("mouth_corner_L", 0.5);
  const auto before = desk.app->of<EditingSession>().state();
  const auto revision = desk.app->of<EditingSession>().revision();
  for (const bool by_button : {true, false}) {
    desk.press('g');
    ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
    EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
    if (by_button) {
      desk.click("Dismiss##suggestion");
    } else {
      desk.hit_escape();
    }
    EXPECT_FALSE(desk.app->of<SuggestionOffer>().open());
    EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  }
  EXPECT_EQ(desk.app->of<EditingSession>().state(), before);
  EXPECT_EQ(desk.app->of<EditingSession>().revision(), revision);
}

TEST(Suggestion, ThePenAloneTakesHalfOfIt) {
  KeyedDesk desk("suggest-half");
  desk.set("mouth_corner_L", 0.5);
  desk.click("Suggest");
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  const Area* found = desk.interface->find("slider amount");
  ASSERT_NE(found, nullptr);
  const Area slider = *found;
  const auto pull_to = [&](double share) {
    desk.app->of<Pointer>().moved({slider.right - 4, slider.middle().y});
    desk.app->of<Pointer>().button(MouseButton::left, true, {slider.right - 4, slider.middle().y});
    desk.frames(2);
    const PxPoint at{slider.left + share * slider.width(), slider.middle().y};
    desk.app->of<Pointer>().moved(at);
    desk.frames(2);
    desk.app->of<Pointer>().button(MouseButton::left, false, at);
    desk.frames(2);
  };
  pull_to(0.5);
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  const double strength = desk.app->of<SuggestionOffer>().suggestion().command.strength;
  EXPECT_NEAR(strength, 0.5, 0.1);
  const double half = value_of(desk.app->of<EditingSession>().shown().pose(), desk, "brow_inner_L");
  desk.click("Take it##suggestion");
  EXPECT_EQ(value_of(desk.document().pose, desk, "brow_inner_L"), half);
  EXPECT_GT(half, 0.05);
}

TEST(Suggestion, NotThisOneAsksAgainAndAStrokeASliderOrTheTimelineEndsIt) {
  KeyedDesk desk("suggest-end");
  desk.set("mouth_corner_L", 0.5);
  desk.press('g');
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  desk.turn_lock("brow_inner_L");
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  EXPECT_EQ(value_of(desk.app->of<EditingSession>().shown().pose(), desk, "brow_inner_L"), 0);
  EXPECT_GT(value_of(desk.app->of<EditingSession>().shown().pose(), desk, "brow_inner_R"), 0.1);
  desk.set("jaw", 0.4);
  EXPECT_FALSE(desk.app->of<SuggestionOffer>().open());
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  desk.press('g');
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  desk.app->of<Playback>().scrub(0.25);
  desk.frames(2);
  EXPECT_FALSE(desk.app->of<SuggestionOffer>().open());
  EXPECT_TRUE(desk.app->of<EditingSession>().shown().previews()) << "what the timeline shows stays";
  desk.app->of<Playback>().end_scrub();
  desk.press('g');
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  desk.click("Pose");
  desk.stroke(desk.named_curve(any_curve(desk)), false);
  EXPECT_FALSE(desk.app->of<SuggestionOffer>().open());
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
}

TEST(Suggestion, ATakenOneIsReplayed) {
  KeyedDesk desk("suggest-replay");
  pose_mouth(desk);
  desk.press('g');
  ASSERT_TRUE(desk.app->of<SuggestionOffer>().open());
  desk.click("Take it##suggestion");
  const auto state = desk.app->of<EditingSession>().state();
  const std::string session = desk.app->of<Recording>().path();
  const auto played = replayed(session);
  ASSERT_TRUE(played.ok());
  EXPECT_EQ(played->differing, 0U);
  EXPECT_EQ(played->session->editor().state(), state);
}

}  // namespace
}  // namespace penpose::app
