#include "ui/app/camera/camera_desk.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/input/navigation.h"

namespace penpose::app {
namespace {

double yaw_of(const Desk& desk) { return viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees; }

/// Where a place of the model lies on the window.
PxPoint px_of(const Desk& desk, const geometry::ModelPoint& point = {0, 0, 0}) {
  const document::View& view = desk.app->of<Canvas>().view();
  return *geometry::Camera::make(view.camera, view.viewport).value().project(point);
}

void go_to(Desk& desk, double time_s) {
  desk.app->of<Playback>().go_to(time_s);
  desk.frames();
}

TEST(CameraDesk, AViewIsKeptOnAKeyAndGoneToAgain) {
  Desk desk("kept-views");
  desk.begin();
  desk.press(k_key_right);
  const double yaw = yaw_of(desk);
  const PxPoint at = px_of(desk);
  desk.press('3', true);
  ASSERT_EQ(desk.document().views.size(), 1U);
  EXPECT_EQ(desk.document().views[0]->key, 3U);
  desk.press(pad_key(3));
  ASSERT_NE(yaw_of(desk), yaw);
  desk.press('3');
  EXPECT_NEAR(yaw_of(desk), yaw, 1e-6);
  EXPECT_NEAR(px_of(desk).x, at.x, 1e-6);
  EXPECT_NEAR(px_of(desk).y, at.y, 1e-6);
  // The same key keeps another view in its place.
  desk.press(k_key_right);
  desk.press('3', true);
  ASSERT_EQ(desk.document().views.size(), 1U);
  desk.press(pad_key(1));
  desk.press('3');
  EXPECT_NEAR(yaw_of(desk), yaw + 15, 1e-6);
  desk.app->of<Playback>().undo();
  desk.press('3');
  EXPECT_NEAR(yaw_of(desk), yaw, 1e-6);
}

TEST(CameraDesk, AKeyWithoutAViewSaysHowToKeepOne) {
  Desk desk("no-view");
  desk.begin();
  const double yaw = yaw_of(desk);
  desk.press('4');
  EXPECT_EQ(yaw_of(desk), yaw);
  EXPECT_NE(desk.app->of<Notices>().all().back().text.find("Ctrl+4"), std::string::npos);
}

TEST(CameraDesk, TheListNamesReplacesAndRemoves) {
  Desk desk("view-list");
  desk.begin();
  desk.press('1', true);
  desk.press('0', true);
  desk.click("Camera 1##camera");
  desk.click("5##camera key");
  EXPECT_EQ(desk.document().views[0]->key, 5U);
  EXPECT_TRUE(desk.app->of<CameraDesk>().rename("Camera 1", "door"));
  EXPECT_FALSE(desk.app->of<CameraDesk>().rename("door", "front")) << "that is the model's own front";
  desk.frames();
  desk.click("door##camera");
  desk.click("Keep this view##camera");
  EXPECT_EQ(desk.document().views.size(), 2U);
  desk.click("door##camera");
  desk.click("Remove##camera");
  ASSERT_EQ(desk.document().views.size(), 1U);
  EXPECT_EQ(desk.document().views[0]->name, "Camera 1");
}

TEST(CameraDesk, LookedThroughItMovesAlongTheTimelineAndElseTheViewIsFree) {
  Desk desk("moving-camera");
  desk.begin();
  const double first = yaw_of(desk);
  desk.app->of<Actions>().run(Action{"key_camera"});
  go_to(desk, 1);
  for (int i = 0; i < 4; ++i) desk.press(k_key_right);
  const double last = yaw_of(desk);
  desk.app->of<Actions>().run(Action{"key_camera"});
  ASSERT_EQ(desk.document().camera->keys.size(), 2U);
  EXPECT_GE(desk.app->of<Playback>().last_s(), 1) << "it is played to its last key";
  go_to(desk, 0);
  EXPECT_EQ(yaw_of(desk), last) << "the view is free";
  desk.app->of<Actions>().run(Action{"look_through"});
  desk.frames();
  EXPECT_NEAR(yaw_of(desk), first, 1e-6);
  go_to(desk, 0.5);
  EXPECT_NEAR(yaw_of(desk), 0.5 * (first + last), 1e-6);
  // Turned away it is keyed or, elsewhere in time, left.
  desk.press(k_key_up);
  const double pitch = viewpoint_of(desk.app->of<Canvas>().view().camera).pitch_degrees;
  EXPECT_GT(pitch, 10);
  go_to(desk, 1);
  EXPECT_NEAR(yaw_of(desk), last, 1e-6);
  EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).pitch_degrees, 0, 1e-6);
  desk.app->of<Playback>().undo();
  desk.frames();
  EXPECT_NEAR(yaw_of(desk), first, 1e-6) << "undone, the camera stands where its only key is";
}

TEST(CameraDesk, ACutShowsTheNextKeyAtOnce) {
  Desk desk("camera-cut");
  desk.begin();
  const double first = yaw_of(desk);
  desk.app->of<Actions>().run(Action{"key_camera"});
  go_to(desk, 1);
  desk.press(k_key_right);
  desk.app->of<Actions>().run(Action{"key_camera"});
  go_to(desk, 0);
  desk.app->of<Actions>().run(Action{"camera_cut"});
  desk.app->of<Actions>().run(Action{"look_through"});
  go_to(desk, 0.5);
  EXPECT_NEAR(yaw_of(desk), first, 1e-6);
  go_to(desk, 1);
  EXPECT_NEAR(yaw_of(desk), first + 15, 1e-6);
}

TEST(CameraDesk, ItIsSavedWithTheProject) {
  std::string project;
  {
    Desk desk("camera-saved");
    desk.begin();
    desk.press(k_key_right);
    desk.press('2', true);
    desk.app->of<Actions>().run(Action{"key_camera"});
    project = desk.path("shot.glb");
    ASSERT_TRUE(desk.app->of<Files>().save(project).ok());
  }
  Desk again("camera-saved-again", project);
  ASSERT_EQ(again.document().views.size(), 1U);
  EXPECT_EQ(again.document().views[0]->key, 2U);
  ASSERT_NE(again.document().camera, nullptr);
  again.press('2');
  EXPECT_NEAR(yaw_of(again), 15, 1e-6);
}

}  // namespace
}  // namespace penpose::app
