#include "core/document/commands/list/view/camera_commands.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

TEST(CameraCommands, KeysAreInOrderAndReplaceEachOther) {
  DocumentHand hand;
  View near = hand.view;
  near.camera.eye.z -= 1;
  hand.does(KeyCamera{2, hand.view});
  hand.does(KeyCamera{1, near, KeyKind::stepped});
  hand.does(KeyCamera{2, near});
  ASSERT_EQ(hand.document().camera->keys.size(), 2U);
  EXPECT_EQ(hand.document().camera->keys[0], (CameraKey{1, near, KeyKind::stepped}));
  EXPECT_EQ(hand.document().camera->keys[1], (CameraKey{2, near, KeyKind::smooth}));
  EXPECT_EQ(hand.refuses(KeyCamera{-1, near}).place, "time_s");
  EXPECT_EQ(hand.refuses(KeyCamera{1, near, KeyKind::free}).place, "kind");
  near.camera.vertical_fov_degrees = 0;
  EXPECT_EQ(hand.refuses(KeyCamera{1, near}).place, "view/vertical_fov_degrees");
}

TEST(CameraCommands, AKeyIsMovedOverAnotherOneAndDeleted) {
  DocumentHand hand;
  View near = hand.view;
  near.camera.eye.z -= 1;
  hand.does(KeyCamera{0, hand.view});
  hand.does(KeyCamera{1, near});
  hand.does(MoveCameraKey{0, 1});
  ASSERT_EQ(hand.document().camera->keys.size(), 1U);
  EXPECT_EQ(hand.document().camera->keys[0].view, hand.view);
  EXPECT_EQ(hand.refuses(MoveCameraKey{0, 2}).place, "from_s");
  EXPECT_EQ(hand.refuses(DeleteCameraKeys{{0}}).place, "times_s");
  hand.does(DeleteCameraKeys{{1}});
  EXPECT_EQ(hand.document().camera, nullptr);
  hand.does(KeyCamera{0, hand.view});
  hand.does(KeyCamera{1, near});
  hand.does(DeleteCameraKeys{});
  EXPECT_EQ(hand.document().camera, nullptr);
  EXPECT_EQ(hand.refuses(DeleteCameraKeys{}).place, "times_s");
}

TEST(CameraCommands, AKeyboardsKeyIsOneViewsAlone) {
  DocumentHand hand;
  hand.does(SaveView{"left", hand.view, 1});
  hand.does(SaveView{"right", hand.view, 1});
  EXPECT_EQ(hand.document().views[0]->key, 0U);
  EXPECT_EQ(hand.document().views[1]->key, 1U);
  // Kept anew it keeps its key; renamed, too.
  hand.does(SaveView{"right", hand.view});
  hand.does(NameView{"right", "door"});
  EXPECT_EQ(hand.document().views[1]->key, 1U);
  EXPECT_EQ(hand.document().views[1]->name, "door");
  EXPECT_EQ(hand.refuses(NameView{"door", "left"}).place, "to");
  EXPECT_EQ(hand.refuses(NameView{"right", "other"}).place, "name");
  EXPECT_EQ(hand.refuses(SaveView{"door", hand.view, 10}).place, "key");
}

}  // namespace
}  // namespace penpose::document
