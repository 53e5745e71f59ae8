#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/input/navigation.h"

// From where one looks: the sides, the model's own front, with perspective and without, the axes in the corner.

namespace penpose::app {
namespace {

double distance_of(const Desk& desk) {
  return geometry::distance(desk.app->of<Canvas>().view().camera.eye, desk.app->of<Canvas>().view().camera.look_at);
}

TEST(View, FrontKeepsTheZoomAndFrameShowsAllAgain) {
  Desk desk("front-zoom");
  desk.begin();
  const double all = distance_of(desk);
  for (int i = 0; i < 4; ++i) desk.press('+');
  desk.press(k_key_right);
  const double near = distance_of(desk);
  ASSERT_LT(near, 0.8 * all);
  desk.press(pad_key(1));
  EXPECT_NEAR(distance_of(desk), near, 1e-9);
  EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees, 0, 1e-6);
  desk.press('f');
  EXPECT_NEAR(distance_of(desk), all, 0.05 * all);
}

TEST(View, WithoutPerspectiveTheNearIsAsLargeAsTheFar) {
  Desk desk("flat");
  desk.begin();
  const Area free = desk.app->of<Canvas>().free_area();
  const double before = desk.named_curve("lip_upper_inner").back().x - desk.named_curve("lip_upper_inner").front().x;
  desk.press(pad_key(5));
  EXPECT_TRUE(desk.app->of<Canvas>().flat());
  const double after = desk.named_curve("lip_upper_inner").back().x - desk.named_curve("lip_upper_inner").front().x;
  EXPECT_NEAR(after, before, 0.15 * before) << "about as large as before";
  // Sides and zoom stay without it.
  desk.press(pad_key(3));
  EXPECT_TRUE(desk.app->of<Canvas>().flat());
  desk.press('+');
  EXPECT_TRUE(desk.app->of<Canvas>().flat());
  // One draws as ever.
  desk.press(pad_key(1));
  desk.press('f');
  for (const PxPoint& p : desk.named_curve("lip_upper_inner")) EXPECT_TRUE(free.holds(p));
  desk.stroke(desk.named_curve("brow_L"));
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_NE(desk.document().pose, rig::rest_pose(*desk.document().model->rig));
  desk.press(pad_key(5));
  EXPECT_FALSE(desk.app->of<Canvas>().flat());
}

TEST(View, TheModelsOwnFrontIsChosenOnceAndKeptInTheProject) {
  double yaw = 0;
  std::string project;
  {
    Desk desk("own-front");
    desk.begin();
    for (int i = 0; i < 2; ++i) desk.press(k_key_right);
    yaw = viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees;
    ASSERT_GT(std::abs(yaw), 20);
    desk.app->of<Actions>().run(Action::set_front);
    desk.frames();
    desk.press(pad_key(3));
    EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees, yaw + 90, 1e-6);
    desk.press(pad_key(1));
    EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees, yaw, 1e-6);
    project = desk.path("turned.glb");
    ASSERT_TRUE(desk.app->of<Files>().save(project).ok());
    // It is a step like others.
    desk.app->of<Playback>().undo();
    desk.press(pad_key(1));
    EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees, 0, 1e-6);
  }
  Desk again("own-front-again", project);
  EXPECT_NEAR(viewpoint_of(again.app->of<Canvas>().view().camera).yaw_degrees, yaw, 1e-6) << "it opens seen from there";
}

TEST(View, TheEndsOfTheAxesAreButtonsToLookFromThere) {
  Desk desk("axes");
  desk.begin();
  desk.app->of<Pointer>().resized({1280, 800}, 96);
  desk.frames();
  desk.click("X##axis");
  EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees, 90, 1e-6);
  desk.click("Z##axis");
  EXPECT_NEAR(viewpoint_of(desk.app->of<Canvas>().view().camera).yaw_degrees, 0, 1e-6);
  EXPECT_TRUE(desk.document().curves.empty()) << "pressing them draws nothing";
}

}  // namespace
}  // namespace penpose::app
