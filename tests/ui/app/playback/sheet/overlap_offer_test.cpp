#include "ui/app/playback/sheet/overlap_offer.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// Overlap: controls whose keys are selected trail, seen before they are baked.

namespace penpose::app {
namespace {

/// The jaw opens from 0 to 1 s and stays; the corner of the mouth is keyed and rests.
class OverlapDesk : public Desk {
 public:
  explicit OverlapDesk(const std::string& name) : Desk(name) {
    begin();
    for (const double time : {0.0, 1.0, 2.0}) {
      perform(document::SetParameters{{{"jaw", time > 0 ? 0.8 : 0.2}, {"brow_inner_L", time == 1 ? 0.6 : 0.1}}});
      perform(document::SetKey{time, {}});
    }
    app->of<Playback>().go_to(0.5);
    press('t');
    frames();
  }
  void perform(const document::Command& command) { ASSERT_TRUE(app->of<EditingSession>().perform(command)); }
  OverlapOffer& offer() { return app->of<OverlapOffer>(); }
  void trail(const std::string& control) {
    click("row " + control);
    app->of<Actions>().run(Action{"overlap"});
    frames();
  }
  std::size_t number(const std::string& control) const {
    return *rig::find_parameter(document().model->rig->parameters(), control);
  }
  double value(const std::string& control, double time_s) const {
    return *document::sample(*document().timeline, number(control), time_s);
  }
  double shown(const std::string& control) const { return app->of<EditingSession>().shown().pose()[number(control)]; }
};

TEST(OverlapOffer, WhatTrailsIsSeenOnTheFaceAndNothingIsKeyedBeforeItIsBaked) {
  OverlapDesk desk("overlap-seen");
  const auto before = desk.document().timeline;
  desk.trail("jaw");
  ASSERT_TRUE(desk.offer().open());
  EXPECT_NEAR(desk.shown("jaw"), *desk.offer().value_at(desk.number("jaw"), 0.5), 1e-12);
  EXPECT_LT(desk.shown("jaw"), desk.value("jaw", 0.5) - 0.05) << "it comes later";
  OverlapValues values = desk.offer().values();
  values.delay_frames = 6;
  const double less = desk.shown("jaw");
  desk.offer().set(values);
  desk.frames();
  EXPECT_LT(desk.shown("jaw"), less - 0.05) << "at once";
  EXPECT_EQ(desk.document().timeline, before);
  desk.press(k_key_escape);
  EXPECT_FALSE(desk.offer().open());
  EXPECT_EQ(desk.document().timeline, before);
  EXPECT_EQ(desk.shown("jaw"), desk.value("jaw", 0.5));
}

TEST(OverlapOffer, BakedKeysAreOneStepAndWhatWasSeen) {
  OverlapDesk desk("overlap-bake");
  desk.click("row jaw");
  for (const auto& key : desk.document().timeline->keys)
    desk.app->of<Keys>().selected().add(key.time_s, desk.number("brow_inner_L"));
  desk.app->of<Actions>().run(Action{"overlap"});
  desk.frames();
  ASSERT_EQ(desk.offer().trailing().size(), 2U);
  const auto seen = desk.offer().trailing();
  const auto before = *desk.document().timeline;
  desk.click("Bake##overlap");
  EXPECT_FALSE(desk.offer().open());
  for (const auto& one : seen) {
    for (std::size_t i = 0; i < one.curve.times_s.size(); ++i)
      EXPECT_NEAR(*document::sample(*desk.document().timeline, one.overlap.control, one.curve.times_s[i]),
                  one.curve.values[i], 0.01 * 0.6 + 1e-9);
    EXPECT_LE(one.keys.times_s.size(), one.curve.times_s.size() / 4);
  }
  EXPECT_NEAR(desk.document().pose[desk.number("jaw")], desk.value("jaw", 0.5), 1e-12) << "the face is of it";
  desk.press('z', true);
  EXPECT_EQ(*desk.document().timeline, before) << "one step takes all of it back";
}

TEST(OverlapOffer, ALeaderIsFollowed) {
  OverlapDesk desk("overlap-leader");
  desk.trail("brow_inner_L");
  const auto leaders = desk.offer().leaders();
  ASSERT_NE(std::find(leaders.begin(), leaders.end(), desk.number("jaw")), leaders.end());
  EXPECT_EQ(std::find(leaders.begin(), leaders.end(), desk.number("brow_inner_L")), leaders.end());
  OverlapValues values = desk.offer().values();
  values.leader = desk.number("jaw");
  values.amount = 0.5;
  desk.offer().set(values);
  desk.frames();
  desk.click("Bake##overlap");
  const auto parameters = desk.document().model->rig->parameters();
  const auto& brow = parameters[desk.number("brow_inner_L")];
  const auto& jaw = parameters[desk.number("jaw")];
  const double by = 0.6 / (jaw.maximum - jaw.minimum) * 0.5 * (brow.maximum - brow.minimum);
  EXPECT_NEAR(desk.value("brow_inner_L", 2.5), 0.1 + by, 1e-9);
}

TEST(OverlapOffer, OneDrawingSaysHowSoftItIsAndIsTakenBack) {
  OverlapDesk desk("overlap-drawn");
  desk.trail("jaw");
  const auto before = *desk.document().timeline;
  const std::size_t jaw = desk.number("jaw");
  OverlapValues values = desk.offer().values();
  values.period_frames = 20;
  desk.offer().set(values);
  const double meant = *desk.offer().value_at(jaw, 1.0);
  values.period_frames = 8;
  desk.offer().set(values);
  desk.click("Show by drawing##overlap");
  desk.app->of<Playback>().go_to(1.0);
  desk.frames();
  EXPECT_NEAR(desk.document().pose[jaw], *desk.offer().value_at(jaw, 1.0), 1e-12) << "drawn on as it is seen";
  desk.perform(document::SetParameters{{{"jaw", meant}}});
  desk.frames();
  EXPECT_NEAR(desk.offer().values().period_frames, 20, 0.01);
  EXPECT_NEAR(*desk.offer().value_at(jaw, 1.0), meant, 1e-6);
  EXPECT_NE(desk.offer().said().find("passes"), std::string::npos) << desk.offer().said();
  // Beyond what comes by then.
  desk.perform(document::SetParameters{{{"jaw", 0.0}}});
  desk.frames();
  EXPECT_NE(desk.offer().said().find("No stiffness"), std::string::npos) << desk.offer().said();
  desk.press(k_key_escape);
  EXPECT_EQ(*desk.document().timeline, before);
  EXPECT_EQ(desk.document().pose[jaw], desk.value("jaw", 1.0));
  EXPECT_EQ(desk.app->of<EditingSession>().steps().can_redo(), 0U) << "no trace";
}

TEST(OverlapOffer, WithoutSelectedKeysItSaysWhatToSelect) {
  OverlapDesk desk("overlap-none");
  desk.app->of<Actions>().run(Action{"overlap"});
  desk.frames();
  EXPECT_FALSE(desk.offer().open());
  ASSERT_FALSE(desk.app->of<Notices>().all().empty());
  EXPECT_NE(desk.app->of<Notices>().all().back().text.find("touch a control's name"), std::string::npos);
}

}  // namespace
}  // namespace penpose::app
