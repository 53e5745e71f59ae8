#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "tests/support/app_desk.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

// Where Save writes, and what it never writes over by itself.

namespace penpose::app {
namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A model as others make it, in the desk's folder, and opened there.
std::string open_model(Desk& desk, const char* name) {
  const std::string path = desk.path(name);
  const auto model = files::load_model("builtin:demo");
  EXPECT_TRUE(model.ok() && files::save_model(*model, path, files::SaveNotes::quiet).ok());
  EXPECT_TRUE(desk.app->of<Files>().open(path).ok());
  desk.frames();
  return path;
}

TEST(Saving, AModelThatWasOpenedIsNotWrittenOverByTheFirstSave) {
  Desk desk("save-model");
  desk.begin();
  const std::string model = open_model(desk, "face.glb");
  const std::string before = bytes_of(model);
  pose_mouth(desk);
  desk.press('s', true);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::save) << "a name is asked for";
  EXPECT_EQ(desk.app->of<Dialogs>().state<FileChoice>().name, "face.penpose.glb");
  desk.click("Save##now");
  EXPECT_EQ(bytes_of(model), before);
  EXPECT_TRUE(std::filesystem::exists(desk.path("face.penpose.glb")));
  EXPECT_FALSE(desk.app->of<EditingSession>().unsaved());
  // From here on it is saved at once, and the same where it is opened again.
  for (const bool again : {false, true}) {
    if (again) {
      ASSERT_TRUE(desk.app->of<Files>().open(desk.path("face.penpose.glb")).ok());
      desk.frames();
    }
    desk.click("Key");
    desk.app->of<Controls>().set_parameter(0, desk.document().model->rig->parameters()[0].maximum * (again ? 0.5 : 1));
    desk.press('s', true);
    EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
    EXPECT_FALSE(desk.app->of<EditingSession>().unsaved());
  }
  EXPECT_EQ(bytes_of(model), before);
}

TEST(Saving, SaveAsOntoTheModelSaysWhatIsLostBeforeItIsDone) {
  Desk desk("save-over");
  desk.begin();
  const std::string model = open_model(desk, "face.glb");
  const std::string before = bytes_of(model);
  pose_mouth(desk);
  desk.app->of<Actions>().run(Action::save_as);
  desk.frames();
  desk.click("face.glb");
  desk.click("Save##now");
  EXPECT_EQ(bytes_of(model), before) << "it is said first";
  EXPECT_NE(desk.app->of<Dialogs>().state<FileChoice>().lost.find("face.glb is the model that was opened"),
            std::string::npos);
  ASSERT_NE(desk.interface->find("Write over it##now"), nullptr);
  EXPECT_EQ(desk.interface->find("Save##now"), nullptr);
  // Another name, and there is nothing to say.
  desk.app->of<Dialogs>().state<FileChoice>().name = "other.glb";
  desk.frames();
  EXPECT_NE(desk.interface->find("Save##now"), nullptr);
  desk.click("face.glb");
  desk.click("Save##now");
  desk.click("Write over it##now");
  EXPECT_TRUE(files::is_project(model));
  EXPECT_EQ(desk.app->of<Files>().project(), model);
  desk.press('s', true);
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none) << "now it is the project's own file";
}

TEST(Saving, AnExportOntoAFileThatIsThereIsAskedAboutToo) {
  Desk desk("export-over");
  desk.begin();
  const std::string model = open_model(desk, "face.glb");
  const std::string before = bytes_of(model);
  desk.app->of<Actions>().run(Action::export_as);
  desk.frames();
  EXPECT_EQ(desk.app->of<Dialogs>().state<FileChoice>().name, "face-export.glb");
  desk.click("face.glb");
  desk.click("Export##now");
  EXPECT_EQ(bytes_of(model), before);
  EXPECT_NE(desk.interface->find("Write over it##now"), nullptr);
}

TEST(Saving, AProjectIsToldFromAModelAndFromAnotherEditionsProject) {
  Desk desk("is-project");
  const std::string model = open_model(desk, "face.glb");
  EXPECT_FALSE(files::is_project(model));
  const std::string project = desk.path("mine.glb");
  ASSERT_TRUE(desk.app->of<Files>().save(project).ok());
  EXPECT_TRUE(files::is_project(project));
  std::string bytes = bytes_of(project);
  const std::size_t edition = bytes.find("\"edition\":");
  ASSERT_NE(edition, std::string::npos);
  // An edition to come has one digit more; the name of the program that wrote the file has one letter less.
  std::string newer = bytes;
  newer.insert(edition + 10, "9");
  newer.erase(newer.find("\"generator\":\"") + 13, 1);
  std::ofstream(project, std::ios::binary) << newer;
  EXPECT_FALSE(files::is_project(project)) << "it opens as a model: its controls are baked";
  EXPECT_FALSE(files::is_older_project(project));
  // Edition 1, in as many letters.
  bytes[edition + 10] = ' ';
  bytes[edition + 11] = '1';
  std::ofstream(project, std::ios::binary) << bytes;
  EXPECT_TRUE(files::is_older_project(project));
  EXPECT_FALSE(files::is_project(project));
  ASSERT_TRUE(desk.app->of<Files>().open(project).ok());
  EXPECT_EQ(desk.app->of<Files>().project(), "") << "the first save asks for a name";
  const auto& said = desk.app->of<Notices>().all();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Notice& one) {
    return one.text.find("was drawn in edition 1") != std::string::npos;
  }));
  EXPECT_FALSE(files::is_project(desk.path("none.glb")));
}

}  // namespace
}  // namespace penpose::app
