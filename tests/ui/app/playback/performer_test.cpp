#include "ui/app/playback/performer.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/view/shown_features.h"

// Perform: whatever is under the pen is pulled while time runs; the take is kept, taken back or taken anew.

namespace penpose::app {
namespace {

constexpr char k_shift_space = ' ';

/// Where a feature of the face is seen, at a share of its length.
PxPoint on_feature(Desk& desk, const std::string& name, double share = 0.5) {
  auto& editing = desk.app->of<EditingSession>();
  Canvas& canvas = desk.app->of<Canvas>();
  for (const portrait::FeatureCurve& curve : editing.all_features().curves) {
    if (curve.name != name) continue;
    const auto line = feature_line(curve, canvas.surface(), canvas.view());
    return line[static_cast<std::size_t>(share * static_cast<double>(line.size() - 1))];
  }
  ADD_FAILURE() << "the face has no " << name;
  return {};
}

struct Pull {
  PxPoint by;
  int frames = 30;
  bool lift = true;
};

void pull(Desk& desk, PxPoint at, const Pull& pull) {
  auto& pointer = desk.app->of<Pointer>();
  pointer.moved(at);
  pointer.button(MouseButton::left, true, at);
  for (int i = 1; i <= pull.frames; ++i) {
    pointer.moved(at + pull.by * (1.0 * i / pull.frames));
    desk.frames(1);
  }
  if (!pull.lift) return;
  pointer.button(MouseButton::left, false, at + pull.by);
  desk.frames();
}

std::size_t key_count(const Desk& desk) { return desk.document().timeline->keys.size(); }

class PullsFeature : public testing::TestWithParam<std::tuple<const char*, double, double, double>> {};

TEST_P(PullsFeature, FollowsThePenWithoutAnyLineDrawnAndIsKeyed) {
  const auto& [feature, share, dx, dy] = GetParam();
  Desk desk("pulls");
  desk.begin();
  desk.press(k_shift_space, false, true);
  const PxPoint at = on_feature(desk, feature, share);
  pull(desk, at, {{dx, dy}, 40, false});
  ASSERT_TRUE(desk.app->of<Performer>().performing());
  desk.frames(10);
  const PxPoint there = on_feature(desk, feature, share);
  const PxPoint moved = there - at;
  const double along = (moved.x * dx + moved.y * dy) / std::hypot(dx, dy);
  EXPECT_GT(along, 0.5 * std::hypot(dx, dy)) << "the face follows";
  desk.let_go(at + PxPoint{dx, dy});
  EXPECT_GE(key_count(desk), 2U);
  EXPECT_LE(key_count(desk), 12U) << "few keys";
  EXPECT_TRUE(desk.document().curves.empty()) << "and nothing is drawn";
}

INSTANTIATE_TEST_SUITE_P(
    OfTheFace, PullsFeature,
    testing::Values(std::tuple{"brow_L", 0.5, 0.0, -12.0}, std::tuple{"jaw", 0.5, 0.0, 20.0},
                    std::tuple{"lip_lower", 0.5, 0.0, 14.0}, std::tuple{"eyelid_upper_R", 0.5, 0.0, 8.0},
                    std::tuple{"lip_upper", 0.02, -4.0, -10.0}, std::tuple{"lip_upper", 0.98, 4.0, -10.0},
                    std::tuple{"lip_upper", 0.5, 0.0, -6.0}, std::tuple{"lip_lower", 0.02, -4.0, -10.0}));

TEST(Performer, ArmsRecordsAndIsDone) {
  Desk desk("states");
  desk.begin();
  const WindowTool* before = &desk.app->of<ToolInHand>().now();
  desk.press(k_shift_space, false, true);
  EXPECT_TRUE(desk.app->of<ToolInHand>().now().pulls);
  EXPECT_NE(desk.interface->find("Done##performing"), nullptr) << "it says how to begin, and how to end";
  pull(desk, on_feature(desk, "brow_L"), {{0, -12}, 30, false});
  EXPECT_EQ(desk.interface->find("Again##performing"), nullptr);
  EXPECT_GE(desk.app->of<Performer>().frame_count(), 10U);
  desk.let_go(on_feature(desk, "brow_L"));
  const Take* take = desk.app->of<Performer>().take();
  ASSERT_NE(take, nullptr);
  EXPECT_EQ(take->keys, key_count(desk));
  EXPECT_NE(desk.interface->find("Again##performing"), nullptr);
  EXPECT_NE(desk.interface->find("Keep##performing"), nullptr);
  desk.click("Keep##performing");
  EXPECT_EQ(desk.app->of<Playback>().time_s(), 0) << "the next part is pulled over it";
  EXPECT_EQ(desk.app->of<Performer>().take(), nullptr);
  EXPECT_GE(key_count(desk), 2U);
  desk.click("Done##performing");
  EXPECT_EQ(&desk.app->of<ToolInHand>().now(), before);
  EXPECT_FALSE(desk.app->of<Playback>().while_drawing().performs);
}

TEST(Performer, AgainTakesTheTakeBackAndGoesToItsStartToBePulledAnew) {
  Desk desk("again");
  desk.begin();
  desk.app->of<Playback>().go_to(0.5);
  desk.press(k_shift_space, false, true);
  const rig::Pose before = desk.document().pose;
  const PxPoint at = on_feature(desk, "brow_L");
  pull(desk, at, {{0, -12}, 60});
  ASSERT_GE(key_count(desk), 2U);
  // Watched first: playing is no step.
  desk.click("Watch##performing");
  EXPECT_TRUE(desk.app->of<Playback>().playing());
  desk.frames(10);
  desk.app->of<Playback>().stop();
  desk.frames();
  desk.click("Again##performing");
  EXPECT_EQ(key_count(desk), 0U);
  EXPECT_EQ(desk.document().pose, before);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 0.5);
  pull(desk, at, {{0, -8}, 30});
  ASSERT_NE(desk.app->of<Performer>().take(), nullptr);
  EXPECT_DOUBLE_EQ(desk.document().timeline->keys.front().time_s, 0.5);
  EXPECT_EQ(desk.app->of<EditingSession>().steps().list().size(), 1U) << "one take, one step";
}

TEST(Performer, UndoEndsWhatIsOfferedForTheTake) {
  Desk desk("undone");
  desk.begin();
  desk.press(k_shift_space, false, true);
  pull(desk, on_feature(desk, "brow_L"), {{0, -12}});
  ASSERT_NE(desk.app->of<Performer>().take(), nullptr);
  desk.press('z', true);
  EXPECT_EQ(desk.app->of<Performer>().take(), nullptr);
  EXPECT_EQ(desk.interface->find("Again##performing"), nullptr);
  EXPECT_EQ(key_count(desk), 0U);
}

TEST(Performer, PlayingBackShowsTheMotionThatWasPulled) {
  Desk desk("played");
  desk.begin();
  desk.press(k_shift_space, false, true);
  const rig::Pose rest = desk.document().pose;
  const PxPoint at = on_feature(desk, "brow_L");
  pull(desk, at, {{0, -14}, 60});
  const rig::Pose end = desk.document().pose;
  EXPECT_NE(end, rest);
  auto& playback = desk.app->of<Playback>();
  playback.scrub(0);
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), rest);
  playback.scrub(0.5 * desk.document().timeline->keys.back().time_s);
  const rig::Pose half = desk.app->of<EditingSession>().shown().pose();
  EXPECT_NE(half, rest);
  EXPECT_NE(half, end);
}

TEST(Performer, APointBesideAllFeaturesIsPulledToo) {
  Desk desk("cheek");
  desk.begin();
  desk.press(k_shift_space, false, true);
  // The chin, between the lip and the jaw's line.
  const PxPoint lip = on_feature(desk, "lip_lower");
  const PxPoint at = lip * 0.5 + on_feature(desk, "jaw") * 0.5;
  pull(desk, at, {{0, 14}, 40});
  EXPECT_GE(key_count(desk), 2U);
}

TEST(Performer, BesideTheModelNothingIsRecordedAndThatIsSaid) {
  Desk desk("beside");
  desk.begin();
  desk.press(k_shift_space, false, true);
  const Area& free = desk.app->of<Canvas>().free_area();
  pull(desk, {free.left + 20, free.bottom - 30}, {{0, -40}});
  EXPECT_EQ(key_count(desk), 0U);
  EXPECT_TRUE(desk.says("nothing under the pen"));
}

TEST(Performer, ATapLeavesEverythingAsItWas) {
  Desk desk("tap");
  desk.begin();
  desk.press(k_shift_space, false, true);
  const rig::Pose before = desk.document().pose;
  pull(desk, on_feature(desk, "brow_L"), {{0, 0}, 3});
  EXPECT_EQ(key_count(desk), 0U);
  EXPECT_EQ(desk.document().pose, before);
  EXPECT_EQ(desk.app->of<Playback>().time_s(), 0);
}

TEST(Performer, AnotherToolOrEscapeEndsIt) {
  Desk desk("ends");
  desk.begin();
  desk.press(k_shift_space, false, true);
  desk.press('d');
  EXPECT_FALSE(desk.app->of<Playback>().while_drawing().performs);
  desk.press(k_shift_space, false, true);
  desk.press(k_key_escape);
  desk.press(k_key_escape);
  EXPECT_FALSE(desk.app->of<Playback>().while_drawing().performs);
  EXPECT_EQ(desk.app->of<ToolInHand>().now().kind, drawing::ToolKind::draw);
}

}  // namespace
}  // namespace penpose::app
