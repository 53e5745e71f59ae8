#include "ui/app/playback/sheet/mirrored_keys.h"

#include <gtest/gtest.h>

#include "core/document/time/timeline.h"
#include "core/document/time/timeline_editing.h"
#include "tests/support/app_desk.h"

// A pose on the other side: pasted, and keys exchanged.

namespace penpose::app {
namespace {

const document::PoseKey& key_of(const Desk& desk, double time_s) {
  return desk.document().timeline->keys[*document::key_at(*desk.document().timeline, time_s)];
}

TEST(MirroredKeys, APoseIsPastedToTheOtherSide) {
  Desk desk("paste-mirrored");
  desk.begin();
  desk.set("mouth_corner_L", 0.75);
  desk.set("jaw", 0.5);
  desk.press('c', true);
  desk.app->of<Playback>().go_to(1);
  desk.press('v', true, true);
  EXPECT_EQ(desk.value_of("mouth_corner_R"), 0.75);
  EXPECT_EQ(desk.value_of("mouth_corner_L"), 0);
  EXPECT_EQ(desk.value_of("jaw"), 0.5) << "what has no side stays";
  EXPECT_EQ(key_of(desk, 1).pose[desk.index_of("mouth_corner_R")], 0.75);
  desk.press('z', true);
  EXPECT_TRUE(desk.document().timeline->keys.empty()) << "one step";
  EXPECT_EQ(desk.value_of("mouth_corner_L"), 0.75);
}

TEST(MirroredKeys, SelectedKeysAreExchangedAndOtherControlsAndMomentsStay) {
  Desk desk("mirror-keys");
  desk.begin();
  const std::size_t left = desk.index_of("mouth_corner_L");
  const std::size_t right = desk.index_of("mouth_corner_R");
  const std::size_t brow = desk.index_of("brow_inner_L");
  auto& editing = desk.app->of<EditingSession>();
  desk.set("brow_inner_L", 0.5);
  desk.set("mouth_corner_L", 0.75);
  desk.set("mouth_corner_R", 0.25);
  editing.perform(document::SetKey{0, {}});
  editing.perform(document::SetKey{1, {}});
  editing.perform(document::SetKeyKind{{{0}, {"mouth_corner_L"}}, document::KeyKind::stepped});
  const std::size_t before = editing.steps().list().size();
  desk.app->of<Keys>().selected().add(0, left);
  desk.app->of<Actions>().run(Action{"mirror_keys"});
  EXPECT_EQ(key_of(desk, 0).pose[right], 0.75);
  EXPECT_EQ(key_of(desk, 0).pose[left], 0.25);
  EXPECT_EQ(key_of(desk, 0).controls[right].kind, document::KeyKind::stepped) << "with how it goes on";
  EXPECT_EQ(key_of(desk, 0).controls[left].kind, document::KeyKind::smooth);
  EXPECT_EQ(key_of(desk, 0).pose[brow], 0.5);
  EXPECT_EQ(key_of(desk, 1).pose[left], 0.75);
  EXPECT_EQ(editing.steps().list().size(), before + 1) << "one step";
}

TEST(MirroredKeys, ASideWithoutAKeyGetsOne) {
  Desk desk("mirror-alone");
  desk.begin();
  auto& editing = desk.app->of<EditingSession>();
  desk.set("mouth_corner_L", 0.75);
  editing.perform(document::SetKey{0.5, {}, {"mouth_corner_L"}});
  desk.app->of<Playback>().go_to(0.5);
  desk.app->of<Actions>().run(Action{"mirror_keys"});
  const document::PoseKey& key = key_of(desk, 0.5);
  EXPECT_TRUE(key.controls.has(desk.index_of("mouth_corner_R")));
  EXPECT_EQ(key.pose[desk.index_of("mouth_corner_R")], 0.75);
  EXPECT_EQ(key.pose[desk.index_of("mouth_corner_L")], 0);
  EXPECT_EQ(desk.value_of("mouth_corner_R"), 0.75) << "the face shows it";
}

TEST(MirroredKeys, WhereBothSidesAreTheSameNothingIsDone) {
  Desk desk("mirror-same");
  desk.begin();
  desk.set("jaw", 0.5);
  desk.click("Key");
  EXPECT_TRUE(mirrored_keys(desk.document(), {{0}, {}}).empty());
  const auto before = desk.document().timeline;
  desk.app->of<Actions>().run(Action{"mirror_keys"});
  EXPECT_EQ(desk.document().timeline, before);
  EXPECT_TRUE(desk.says("nothing to flip"));
}

}  // namespace
}  // namespace penpose::app
