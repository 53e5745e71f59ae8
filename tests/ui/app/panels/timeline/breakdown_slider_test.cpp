#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/playback/keys.h"

// Between: a slider from the key before to the key after.

namespace penpose::app {
namespace {

constexpr double k_whole = 1.6;  ///< of the slider, from 30 % before to 30 % beyond

class BetweenDesk : public Desk {
 public:
  explicit BetweenDesk(const std::string& name) : Desk(name) {
    begin();
    app->of<EditingSession>().perform(document::SetKey{0, {}});
    app->of<EditingSession>().perform(document::SetParameters{{{"jaw", 0.5}}});
    app->of<EditingSession>().perform(document::SetKey{2, {}});
    app->of<Playback>().go_to(1);
    frames();
  }
  double jaw(const rig::Pose& pose) const {
    return pose[*rig::find_parameter(document().model->rig->parameters(), "jaw")];
  }
  double shown_jaw() { return jaw(app->of<EditingSession>().shown().pose()); }
  /// Px of the slider at a share of the way.
  PxPoint at(double share) {
    const Area area = *interface->find("slider Between");
    const double inset = 0.2 * area.height();
    return {area.left + inset + (share + 0.3) / k_whole * (area.width() - 2 * inset), area.middle().y};
  }
  void pull(double from, double to) {
    app->of<Pointer>().moved(at(from));
    app->of<Pointer>().button(MouseButton::left, true, at(from));
    frames();
    app->of<Pointer>().moved(at(to));
    frames();
  }
  void lift(double share) { let_go(at(share)); }
  bool says(const std::string& words) {
    const auto& all = app->of<Notices>().all();
    return std::any_of(all.begin(), all.end(),
                       [&](const Notice& one) { return one.text.find(words) != std::string::npos; });
  }
};

TEST(BreakdownSlider, ThePoseIsShownWhileItIsPulledAndKeyedWhereItIsLetGo) {
  BetweenDesk desk("between");
  EXPECT_GE(desk.interface->find("slider Between")->width(), 150);
  desk.pull(0.5, 0.75);
  EXPECT_NEAR(desk.shown_jaw(), 0.375, 0.01) << "live";
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U) << "and not keyed yet";
  desk.lift(0.75);
  ASSERT_EQ(desk.document().timeline->keys.size(), 3U);
  EXPECT_EQ(desk.document().timeline->keys[1].time_s, 1);
  EXPECT_NEAR(desk.jaw(desk.document().timeline->keys[1].pose), 0.375, 0.01);
  EXPECT_EQ(desk.document().pose, rig::Pose(desk.document().timeline->keys[1].pose));
  EXPECT_GT(desk.app->of<Keys>().shine(1), 0.8) << "the key is seen to land";
  EXPECT_EQ(desk.app->of<Keys>().shine(0), 0);
  EXPECT_TRUE(desk.says("keyed at frame 24: 75 %"));
  EXPECT_GE(desk.app->next_frame_ms(), 0) << "frames for its shine";
  desk.frames(80);
  EXPECT_EQ(desk.app->of<Keys>().shine(1), 0);
  desk.press('z', true);
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U);
}

TEST(BreakdownSlider, BeyondItsMarksItOvershoots) {
  BetweenDesk desk("between-over");
  desk.pull(0.5, 1.2);
  desk.lift(1.2);
  ASSERT_EQ(desk.document().timeline->keys.size(), 3U);
  EXPECT_NEAR(desk.jaw(desk.document().timeline->keys[1].pose), 0.6, 0.01);
  desk.pull(0.5, 0.01);
  desk.lift(0.01);
  EXPECT_EQ(desk.jaw(desk.document().timeline->keys[1].pose), 0) << "it sticks to the marks";
}

TEST(BreakdownSlider, WhereAKeyIsLackingItSaysWhichAndKeysNothing) {
  BetweenDesk desk("between-lacks");
  desk.app->of<Playback>().go_to(0);
  desk.pull(0.5, 0.75);
  EXPECT_TRUE(desk.says("no key before this frame"));
  desk.lift(0.75);
  desk.app->of<Playback>().go_to(2);
  desk.pull(0.5, 0.75);
  EXPECT_TRUE(desk.says("no key after this frame"));
  desk.lift(0.75);
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U);
}

}  // namespace
}  // namespace penpose::app
