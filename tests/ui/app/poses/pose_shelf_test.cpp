#include "ui/app/poses/pose_shelf.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// A desk with the library open and a smile in it, the face back at rest.
void keep_smile(Desk& desk) {
  desk.begin();
  desk.set("mouth_corner_L", 0.8);
  desk.set("brow_inner_L", 0.5);
  desk.click("Poses");
  desk.click("Library##poses");
  ASSERT_TRUE(desk.click("Keep##pose"));
  desk.app->of<EditingSession>().perform(document::ResetParameters{});
  desk.frames();
}

std::string all_notices(const Desk& desk) {
  std::string text;
  for (const Notice& one : desk.app->of<Notices>().all()) text += one.text + "\n";
  return text;
}

TEST(PoseShelf, APoseIsKeptInAFileAndTakenByOneTouchAndOneUndo) {
  Desk desk("shelf-keep");
  keep_smile(desk);
  EXPECT_TRUE(fs::exists(desk.folder / "poses" / "pose 1.pose.json"));
  ASSERT_TRUE(desk.click("pose 1##kept pose 1.pose.json"));
  EXPECT_DOUBLE_EQ(desk.value_of("mouth_corner_L"), 0.8);
  EXPECT_DOUBLE_EQ(desk.value_of("brow_inner_L"), 0.5);
  EXPECT_NE(all_notices(desk).find("by the names of its controls"), std::string::npos) << all_notices(desk);
  desk.app->of<EditingSession>().steps().undo();
  EXPECT_DOUBLE_EQ(desk.value_of("mouth_corner_L"), 0);
  EXPECT_DOUBLE_EQ(desk.value_of("brow_inner_L"), 0);
}

TEST(PoseShelf, TheSliderTakesAShareInTheSameStep) {
  Desk desk("shelf-share");
  keep_smile(desk);
  desk.click("pose 1##kept pose 1.pose.json");
  const PxPoint half = desk.interface->find("slider amount")->middle();
  desk.drag_slider("amount", 0.99, 0.5, false);
  EXPECT_NEAR(desk.app->of<EditingSession>().shown().pose()[desk.index_of("mouth_corner_L")], 0.4, 0.03);
  desk.let_go(half);
  EXPECT_NEAR(desk.value_of("mouth_corner_L"), 0.4, 0.03);
  desk.app->of<EditingSession>().steps().undo();
  EXPECT_DOUBLE_EQ(desk.value_of("mouth_corner_L"), 0) << "one step takes back the pose and its share";
}

TEST(PoseShelf, OnlyTheChosenPartIsShownAndTaken) {
  Desk desk("shelf-part");
  keep_smile(desk);
  desk.click("Eyes##part");
  EXPECT_EQ(desk.interface->find("pose 1##kept pose 1.pose.json"), nullptr) << "it does nothing to the eyes";
  desk.click("Brows##part");
  ASSERT_TRUE(desk.click("pose 1##kept pose 1.pose.json"));
  EXPECT_DOUBLE_EQ(desk.value_of("brow_inner_L"), 0.5);
  EXPECT_DOUBLE_EQ(desk.value_of("mouth_corner_L"), 0);
}

TEST(PoseShelf, MirroredItIsThePoseOfTheOtherSide) {
  Desk desk("shelf-mirrored");
  keep_smile(desk);
  desk.click("Mirrored##kept");
  desk.click("pose 1##kept pose 1.pose.json");
  EXPECT_DOUBLE_EQ(desk.value_of("mouth_corner_R"), 0.8);
  EXPECT_DOUBLE_EQ(desk.value_of("mouth_corner_L"), 0);
}

TEST(PoseShelf, ADeletedPoseComesBackOutOfTheTrash) {
  Desk desk("shelf-trash");
  keep_smile(desk);
  desk.click("pose 1##kept pose 1.pose.json");
  ASSERT_TRUE(desk.click("Delete##pose"));
  EXPECT_FALSE(fs::exists(desk.folder / "poses" / "pose 1.pose.json"));
  EXPECT_TRUE(fs::exists(desk.folder / "poses" / "trash" / "pose 1.pose.json"));
  EXPECT_EQ(desk.interface->find("pose 1##kept pose 1.pose.json"), nullptr);
  ASSERT_TRUE(desk.click("Bring back##pose"));
  EXPECT_TRUE(fs::exists(desk.folder / "poses" / "pose 1.pose.json"));
  EXPECT_NE(desk.interface->find("pose 1##kept pose 1.pose.json"), nullptr);
}

TEST(PoseShelf, ARenamedPoseIsFoundByItsNewName) {
  Desk desk("shelf-rename");
  keep_smile(desk);
  auto& shelf = desk.app->of<PoseShelf>();
  const std::string renamed = shelf.rename((desk.folder / "poses" / "pose 1.pose.json").string(), "a/wide smile");
  EXPECT_EQ(fs::path(renamed).filename(), "a-wide smile.pose.json") << "the file stays in its folder";
  EXPECT_EQ(shelf.listed("WIDE", FacePart::all).size(), 1U);
  EXPECT_TRUE(shelf.listed("pose", FacePart::all).empty());
  EXPECT_TRUE(shelf.rename(renamed, "").empty()) << "it needs a name";
  EXPECT_TRUE(fs::exists(renamed));
}

TEST(PoseShelf, FilesThatAreNoPosesAreShownAndDoNothing) {
  Desk desk("shelf-foreign");
  keep_smile(desk);
  std::ofstream(desk.folder / "poses" / "broken.pose.json") << "{\"penpose_pose\": 1, \"name\": ";
  std::ofstream(desk.folder / "poses" / "notes.txt") << "do not forget the brows";
  desk.frames(6);
  const std::uint64_t before = desk.app->of<EditingSession>().revision();
  ASSERT_TRUE(desk.click("broken.pose.json##kept broken.pose.json"));
  ASSERT_TRUE(desk.click("notes.txt##kept notes.txt"));
  EXPECT_EQ(desk.app->of<EditingSession>().revision(), before);
  const files::PoseFile* broken = desk.app->of<PoseShelf>().find((desk.folder / "poses" / "broken.pose.json").string());
  ASSERT_NE(broken, nullptr);
  EXPECT_NE(broken->pose.error().line().find("byte offset"), std::string::npos);
}

TEST(PoseShelf, AnotherFolderIsRememberedAndTheUsualOneForgetsIt) {
  Desk desk("shelf-folder");
  keep_smile(desk);
  auto& shelf = desk.app->of<PoseShelf>();
  shelf.choose_folder(desk.path("elsewhere"));
  desk.frames();
  EXPECT_TRUE(shelf.poses().empty());
  EXPECT_EQ(load_settings(desk.path("config")).pose_folder, desk.path("elsewhere"));
  shelf.choose_folder({});
  desk.frames();
  EXPECT_EQ(shelf.poses().size(), 1U);
}

}  // namespace
}  // namespace penpose::app
