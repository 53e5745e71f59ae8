#include <fstream>
#include <gtest/gtest.h>

#include "core/document/document_hash.h"
#include "tests/support/app_desk.h"
#include "ui/files/load_model.h"

namespace penpose::app {
namespace {

constexpr const char* k_lying = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 4\nf 1 4 3\n";

/// A wedge that lies on its back: three units along z, two along y.
std::string lying_file(const std::string& name) {
  const auto folder = Desk::folder_of(name + "_file");
  std::filesystem::create_directories(folder);
  const auto path = (folder / "lying.obj").string();
  std::ofstream(path) << k_lying;
  return path;
}

double height(Desk& desk) {
  const auto& box = desk.document().model->mesh->rest_box();
  return box.maximum.y - box.minimum.y;
}

std::size_t notices_with(Desk& desk, const std::string& word) {
  std::size_t count = 0;
  for (const Notice& one : desk.app->of<Notices>().all()) count += one.text.find(word) != std::string::npos ? 1 : 0;
  return count;
}

TEST(UpAxis, AFileThatLiesIsStoodUpFromTheMenuAndLaidDownAgain) {
  const std::string path = lying_file("up_axis");
  Desk desk("up_axis", path);
  EXPECT_EQ(notices_with(desk, "Z up"), 1U) << "it looks as if it lay";
  EXPECT_NEAR(height(desk), 2, 1e-9);
  desk.app->of<Actions>().run(Action::up_axis);
  desk.frames();
  EXPECT_NEAR(height(desk), 3, 1e-9);
  EXPECT_EQ(desk.app->of<Preferences>().settings().recent.front(), path + "?up=z") << "opened again as it was";
  desk.app->of<Actions>().run(Action::left_handed);
  desk.frames();
  EXPECT_NEAR(desk.document().model->mesh->rest_box().minimum.x, -1, 1e-9);
  EXPECT_NEAR(height(desk), 3, 1e-9);
  desk.app->of<Actions>().run(Action::up_axis);
  desk.frames();
  EXPECT_NEAR(height(desk), 2, 1e-9);
}

TEST(UpAxis, AFileThatSaysItsAxesOffersNothing) {
  Desk desk("up_axis_said");
  EXPECT_FALSE(desk.app->of<Actions>().usable(Action::up_axis));
  EXPECT_FALSE(desk.app->of<Actions>().usable(Action::left_handed));
}

TEST(UpAxis, ASessionIsReplayedOnTheModelAsItStood) {
  const std::string path = lying_file("up_axis_session");
  std::string session;
  base::Hash128 state;
  {
    Desk desk("up_axis_session", path + "?up=z");
    EXPECT_NEAR(height(desk), 3, 1e-9);
    EXPECT_EQ(notices_with(desk, "Z up"), 0U);
    desk.app->of<EditingSession>().perform(document::SaveView{"side", desk.app->of<Canvas>().view()});
    desk.frames();
    session = desk.app->of<Recording>().path();
    state = document::DocumentHasher()(desk.document()).whole;
  }
  Desk again("up_axis_again", session);
  EXPECT_NEAR(height(again), 3, 1e-9);
  EXPECT_EQ(document::DocumentHasher()(again.document()).whole, state);
}

TEST(UpAxis, WhatIsSavedStandsAndSaysItItself) {
  const std::string path = lying_file("up_axis_saved");
  Desk desk("up_axis_saved", path + "?up=z");
  const std::string saved = desk.path("standing.glb");
  ASSERT_TRUE(desk.app->of<Files>().save(saved).ok());
  ASSERT_TRUE(desk.app->of<Files>().open(saved).ok());
  EXPECT_NEAR(height(desk), 3, 1e-9);
  EXPECT_FALSE(desk.app->of<Actions>().usable(Action::up_axis));
}

}  // namespace
}  // namespace penpose::app
