#include "ui/app/face/kept_features.h"

#include <fstream>
#include <gtest/gtest.h>

#include "core/document/features/feature_curves.h"
#include "tests/support/app_replay.h"
#include "ui/files/save_model.h"

// Features of the face in the window: shown on opening, corrected, kept for the next file of the same mesh.

namespace penpose::app {
namespace {

/// A file of the built-in head without names of lines.
std::string head_file(const std::string& folder, const std::string& name) {
  auto head = files::load_document("builtin:demo", files::NamedBy::file).value();
  document::Model model = *head.model;
  model.curves.clear();
  const std::string path = (Desk::folder_of(folder) / name).string();
  std::filesystem::create_directories(Desk::folder_of(folder));
  EXPECT_TRUE(files::save_document(document::make_document(model), path).ok());
  return path;
}

const document::Model& model_of(const Desk& desk) { return *desk.document().model; }
bool shows(const Desk& desk) { return desk.app->of<KeptFeatures>().shown(); }

/// Draws along the left brow, a little above it, with the tool Feature.
void correct_brow(Desk& desk) {
  desk.begin();
  desk.click("Feature");
  desk.stroke(desk.named_curve("brow_L", {0, -8}));
}

TEST(KeptFeatures, AreShownOnOpeningUntilSomethingIsDrawn) {
  Desk desk("features-shown");
  desk.begin();
  EXPECT_TRUE(shows(desk));
  const std::size_t with = desk.app->of<CanvasDrawing>().curves.size();
  EXPECT_GE(with, 10U) << "brows, lids and lips";
  desk.click("Draw");
  EXPECT_TRUE(shows(desk)) << "a tool is chosen to draw over them";
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
  EXPECT_FALSE(shows(desk));
  EXPECT_NE(desk.document().face, nullptr) << "they were not in the way";
}

TEST(KeptFeatures, AModelWithoutAFaceShowsNone) {
  const std::string path = (Desk::folder_of("features-faceless") / "sheet.obj").string();
  std::filesystem::create_directories(Desk::folder_of("features-faceless"));
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n";
  Desk desk("features-faceless", path, false);
  EXPECT_FALSE(shows(desk));
  // A line can be said to be a feature all the same.
  desk.app->of<EditingSession>().perform(document::PlaceFeature{"seam", {{0, {1, 0, 0}}, {1, {0, 1, 0}}}});
  EXPECT_EQ(desk.app->of<EditingSession>().features().size(), 1U);
}

TEST(KeptFeatures, EscapeEndsTheShow) {
  Desk desk("features-escape");
  desk.begin();
  desk.hit_escape();
  EXPECT_FALSE(shows(desk));
  EXPECT_TRUE(desk.app->of<CanvasDrawing>().curves.empty());
}

TEST(KeptFeatures, TimeEndsTheShow) {
  Desk timed("features-time");
  timed.begin();
  timed.app->of<Playback>().scrub(1.0);
  timed.frames();
  EXPECT_FALSE(shows(timed));
}

TEST(KeptFeatures, ALineOfTheToolCorrectsAndIsOneStep) {
  Desk desk("features-correct");
  correct_brow(desk);
  ASSERT_EQ(model_of(desk).features.size(), 1U);
  EXPECT_EQ(model_of(desk).features.front().name, "brow_L");
  EXPECT_NE(desk.interface->find("feature brow_L"), nullptr) << "its name is beside it";
  desk.app->of<EditingSession>().steps().undo();
  desk.frames();
  EXPECT_TRUE(model_of(desk).features.empty());
}

TEST(KeptFeatures, TheMenuOfANameTakesAFeatureAwayAndBack) {
  Desk desk("features-menu");
  desk.begin();
  desk.click("Feature");
  ASSERT_TRUE(desk.click("feature brow_L"));
  EXPECT_EQ(desk.interface->find("As found##feature"), nullptr) << "nothing was corrected";
  ASSERT_TRUE(desk.click("No such feature"));
  EXPECT_EQ(desk.interface->find("feature brow_L"), nullptr);
  ASSERT_EQ(model_of(desk).features.size(), 1U);
  desk.app->of<EditingSession>().steps().undo();
  desk.frames();
  EXPECT_NE(desk.interface->find("feature brow_L"), nullptr);
}

TEST(KeptFeatures, ALineThatMayBeSeveralIsAskedAbout) {
  Desk desk("features-ask");
  desk.begin();
  desk.click("Feature");
  desk.stroke(desk.named_curve("lip_upper_inner"));
  EXPECT_TRUE(model_of(desk).features.empty());
  EXPECT_FALSE(desk.says("Nothing changed")) << "it is asked, not refused";
  ASSERT_TRUE(desk.click("inner lower lip##which"));
  ASSERT_EQ(model_of(desk).features.size(), 1U);
  EXPECT_EQ(model_of(desk).features.front().name, "lip_lower_inner");
  EXPECT_EQ(desk.interface->find("Close##which"), nullptr);
}

TEST(KeptFeatures, ADrawnLineIsSaidToBeAFeature) {
  Desk desk("features-drawn");
  desk.begin();
  desk.click("Draw");
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
  ASSERT_TRUE(desk.click("line 1"));
  ASSERT_TRUE(desk.click("This is the left brow##face"));
  ASSERT_EQ(model_of(desk).features.size(), 1U);
  EXPECT_EQ(model_of(desk).features.front().name, "brow_L");
  EXPECT_EQ(desk.document().face, nullptr);
  desk.stroke(desk.named_curve("brow_R", {0, -14}));
  ASSERT_TRUE(desk.click("line 1"));
  ASSERT_TRUE(desk.click("This is another feature##face"));
  ASSERT_TRUE(desk.click("right upper eyelid##which"));
  EXPECT_EQ(model_of(desk).features.back().name, "eyelid_upper_R");
}

TEST(KeptFeatures, GoToTheNextFileOfTheSameMeshAndIntoItsSession) {
  const std::string first = head_file("features-next", "first.glb"), second = head_file("features-next", "second.glb");
  std::vector<document::NamedCurve> features;
  {
    Desk desk("features-next", first, false);
    desk.begin();
    desk.click("Feature");
    const auto& all = desk.app->of<EditingSession>().all_features();
    ASSERT_FALSE(all.curves.empty());
    desk.app->of<EditingSession>().perform(document::PlaceFeature{"jaw", {{0, {1, 0, 0}}, {5, {0, 1, 0}}}});
    desk.app->of<EditingSession>().perform(document::PlaceFeature{"chin", {}});
    desk.frames();
    features = model_of(desk).features;
  }
  std::string session;
  {
    Desk desk("features-next", second, false);
    EXPECT_TRUE(desk.says("Features as you corrected them for this mesh"));
    ASSERT_EQ(model_of(desk).features.size(), features.size());
    EXPECT_EQ(model_of(desk).features.front().points, features.front().points);
    EXPECT_FALSE(desk.app->of<EditingSession>().unsaved());
    session = desk.app->of<Recording>().path();
    // Undoing it in this file is no wish for the next one.
    desk.app->of<EditingSession>().steps().undo();
    desk.frames();
    EXPECT_TRUE(model_of(desk).features.empty()) << "all in one step";
    EXPECT_TRUE(std::filesystem::exists(desk.app->of<KeptFeatures>().path_of(*model_of(desk).mesh)));
    desk.app->of<EditingSession>().steps().redo();
    desk.frames();
  }
  // Another machine has no such file.
  std::filesystem::remove_all(Desk::folder_of("features-next") / "config");
  const auto played = replayed(session);
  ASSERT_TRUE(played.ok()) << played.error().line();
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(played->session->editor().document().model->features.size(), features.size());
  Desk third("features-next", first, false);
  EXPECT_TRUE(model_of(third).features.empty());
}

TEST(KeptFeatures, TakingTheLastOneBackForgetsTheMesh) {
  const std::string file = head_file("features-back", "a.glb");
  Desk desk("features-back", file, false);
  const std::string kept = desk.app->of<KeptFeatures>().path_of(*model_of(desk).mesh);
  desk.app->of<EditingSession>().perform(document::PlaceFeature{"jaw", {}});
  desk.frames();
  EXPECT_TRUE(std::filesystem::exists(kept));
  desk.app->of<EditingSession>().perform(document::FeatureAsFound{"jaw"});
  desk.frames();
  EXPECT_FALSE(std::filesystem::exists(kept));
}

TEST(KeptFeatures, ABrokenFileIsNamedAndLeavesTheFaceAsFound) {
  const std::string file = head_file("features-broken", "a.glb");
  std::string kept;
  {
    Desk desk("features-broken", file, false);
    kept = desk.app->of<KeptFeatures>().path_of(*model_of(desk).mesh);
  }
  std::filesystem::create_directories(std::filesystem::path(kept).parent_path());
  std::ofstream(kept) << "{\"penpose_features\": 1, \"mesh\": 3}";
  Desk desk("features-broken", file, false);
  EXPECT_TRUE(desk.says(kept));
  EXPECT_TRUE(desk.says("/mesh"));
  EXPECT_TRUE(model_of(desk).features.empty());
  EXPECT_TRUE(shows(desk));
}

TEST(KeptFeatures, NamesOfLinesStayWhileOneErases) {
  Desk desk("features-erase");
  desk.begin();
  desk.click("Draw");
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
  desk.click("Erase");
  EXPECT_NE(desk.interface->find("line 1"), nullptr);
  desk.click("Pose");
  EXPECT_EQ(desk.interface->find("line 1"), nullptr);
}

}  // namespace
}  // namespace penpose::app
